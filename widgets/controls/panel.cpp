#include "widgets/controls/panel.h"

#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"

#include <QChildEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kEdge = 3;

namespace {

// Lies over the panel, paints its border and, outside of it, the page in the corners.
class Border : public QWidget
{
public:
    explicit Border(QWidget *parent) : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        setFocusPolicy(Qt::NoFocus);
    }
    void setFocused(bool focused)
    {
        m_focused = focused;
        update();
    }
    QColor edge;

protected:
    void paintEvent(QPaintEvent *) override
    {
        const Palette &look = lookOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QPainterPath outside;
        outside.addRect(rect());
        QPainterPath inside;
        inside.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);
        painter.fillPath(outside - inside, palette().color(QPalette::Window));
        if (edge.isValid()) {
            painter.setClipPath(inside);
            painter.fillRect(0, 0, width(), kEdge, edge);
            painter.setClipping(false);
        }
        paintBox(painter, rect(), {QColor(), m_focused ? look.accent : look.border, m_focused ? 2 : 1});
    }

private:
    bool m_focused = false;
};

} // namespace

Panel::Panel(QWidget *parent) : QFrame(parent), m_rows(new QVBoxLayout(this))
{
    m_rows->setContentsMargins(12, 8, 12, 8);
    m_rows->setSpacing(0);
    m_border = new Border(this);
}

void Panel::setFlush()
{
    m_rows->setContentsMargins(1, 1, 1, 1);
}

void Panel::setEdge(const QColor &edge)
{
    m_edge = edge;
    static_cast<Border *>(m_border)->edge = edge;
    m_border->update();
}

void Panel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), lookOf(palette()).base);
}

void Panel::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    m_border->setGeometry(rect());
    m_border->raise();
}

void Panel::childEvent(QChildEvent *event)
{
    QFrame::childEvent(event);
    if (!m_border || !event->child()->isWidgetType())
        return;
    if (event->added())
        event->child()->installEventFilter(this);
    if (event->added())
        m_border->raise();
}

bool Panel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        const auto *widget = qobject_cast<QWidget *>(watched);
        // Only what fills the panel lends it its focus; smaller controls show their own.
        if (widget && widget->width() >= width() - 2)
            static_cast<Border *>(m_border)->setFocused(event->type() == QEvent::FocusIn);
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace driftbench
