// The middle of a panel that has nothing to show: an icon, what is missing, one sentence what to do, one or
// two small buttons.
#pragma once

#include "widgets/controls/action_button.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QLabel;

namespace driftbench {

class TextLabel;

class EmptyState : public QWidget
{
    Q_OBJECT

public:
    explicit EmptyState(const QString &iconName, QWidget *parent = nullptr);

    void setTexts(const QString &headline, const QString &sentence);
    void setActions(const std::vector<QAction *> &actions);

protected:
    void changeEvent(QEvent *event) override;

private:
    void showIcon();

    QString m_iconName;
    QLabel *m_icon;
    TextLabel *m_headline;
    TextLabel *m_sentence;
    QHBoxLayout *m_buttons;
};

} // namespace driftbench
