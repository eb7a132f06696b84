// The middle of a panel while something is read or computed: what and how far, a bar, Cancel (Esc).
#pragma once

#include "widgets/controls/action_button.h"

#include <QWidget>

class QProgressBar;

namespace driftbench {

class TextLabel;

class LoadingState : public QWidget
{
    Q_OBJECT

public:
    explicit LoadingState(QWidget *parent = nullptr);

    void setProgress(const QString &what, double fraction); // fraction below 0: not known

signals:
    void cancelled();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    TextLabel *m_what;
    QProgressBar *m_bar;
    QAction *m_cancel;
};

} // namespace driftbench
