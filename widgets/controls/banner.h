// What device or data have to say, under the head of a page: an icon, what happened (semibold), what to do,
// at most two buttons, a cross. Never a dialog.
#pragma once

#include "widgets/controls/action_button.h"

#include <QFrame>

#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace driftbench {

enum class BannerKind
{
    Info,
    Caution,
    Bad,
};

struct BannerContent
{
    BannerKind kind = BannerKind::Info;
    QString what;                     // one sentence, semibold
    QString toDo;                     // what to do; may be empty
    QString code;                     // a line in the fixed-width font that can be selected; may be empty
    QString icon;                     // empty: that of the kind
    std::vector<QAction *> actions{}; // at most two; not owned
    bool closable = true;
};

class Banner : public QFrame
{
    Q_OBJECT

public:
    explicit Banner(QWidget *parent = nullptr);

    void setContent(const BannerContent &content);
    const BannerContent &content() const { return m_content; }

    bool hasHeightForWidth() const override { return true; }

signals:
    void closed();

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showText();

    BannerContent m_content;
    QLabel *m_text;
    QLineEdit *m_code;
    QHBoxLayout *m_buttons;
    QToolButton *m_close;
};

} // namespace driftbench
