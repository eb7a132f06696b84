// The accent border of a widget that has the keyboard, for widgets that draw all of their area themselves. It
// shows when the focus came by the keyboard; a click needs no border to be found again.
#pragma once

#include <QColor>
#include <QWidget>

namespace driftbench {

class FocusOutline : public QWidget
{
    Q_OBJECT

public:
    explicit FocusOutline(QWidget *around);

    void setColor(const QColor &color);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QColor m_color;
};

} // namespace driftbench
