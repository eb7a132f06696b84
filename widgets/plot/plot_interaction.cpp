#include "widgets/plot/plot_interaction.h"

#include "widgets/plot/axis_moves.h"
#include "widgets/plot/focus_outline.h"

#include <QApplication>
#include <QRubberBand>
#include <QToolTip>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kWheelFactor = 0.85; // for one notch
static constexpr double kDegreesANotch = 120.0;
static constexpr double kMoved = 3.0; // px; less is a click
static constexpr int kHoverMs = 300;

PlotInteraction::PlotInteraction(QCustomPlot *plot, const Palette &look)
    : QObject(plot), m_plot(plot), m_outline(new FocusOutline(plot))
{
    plot->setFocusPolicy(Qt::StrongFocus);
    plot->setMouseTracking(true);
    plot->installEventFilter(this);
    m_hoverTimer.setSingleShot(true);
    m_hoverTimer.setInterval(kHoverMs);
    connect(&m_hoverTimer, &QTimer::timeout, this, &PlotInteraction::showHover);
    setLook(look);
}

PlotInteraction::~PlotInteraction() = default;

void PlotInteraction::setLook(const Palette &look)
{
    m_look = look;
    m_background = look.base;
    m_outline->setColor(look.accent);
    if (m_cursors)
        m_cursors->setLook(look);
}

PlotCursors &PlotInteraction::enableCursors()
{
    if (!m_cursors)
        m_cursors = new PlotCursors(m_plot, m_look);
    return *m_cursors;
}

void PlotInteraction::addMenuAction(QAction *action)
{
    m_menuActions.append(action);
}

PlotInteraction::View PlotInteraction::view() const
{
    View view;
    for (const QCPAxisRect *panel : m_plot->axisRects()) {
        const QCPAxis &keys = *panel->axis(QCPAxis::atBottom);
        const QCPAxis &values = *panel->axis(QCPAxis::atLeft);
        view.panels.push_back({keys.label(), values.label(), keys.range().lower, keys.range().upper,
                               values.range().lower, values.range().upper});
    }
    return view;
}

void PlotInteraction::putBack(const View &view)
{
    const auto panels = m_plot->axisRects();
    if (view.panels.size() != static_cast<std::size_t>(panels.size()))
        return;
    m_moved = true;
    for (qsizetype i = 0; i < panels.size(); ++i) {
        const View::Panel &wanted = view.panels[static_cast<std::size_t>(i)];
        QCPAxis &keys = *panels[i]->axis(QCPAxis::atBottom);
        QCPAxis &values = *panels[i]->axis(QCPAxis::atLeft);
        if (keys.label() == wanted.keyLabel)
            keys.setRange(wanted.keyLow, wanted.keyHigh);
        if (values.label() == wanted.valueLabel)
            values.setRange(wanted.valueLow, wanted.valueHigh);
    }
}

void PlotInteraction::rememberHome()
{
    m_home = view();
    m_moved = false;
}

QCPRange PlotInteraction::homeOf(const QCPAxisRect &panel, Qt::Orientation axis) const
{
    const auto panels = m_plot->axisRects();
    const auto at = static_cast<std::size_t>(
        std::max<qsizetype>(0, std::find(panels.begin(), panels.end(), &panel) - panels.begin()));
    if (at >= m_home.panels.size())
        return {0.0, 0.0};
    const View::Panel &home = m_home.panels[at];
    return axis == Qt::Horizontal ? QCPRange(home.keyLow, home.keyHigh)
                                  : QCPRange(home.valueLow, home.valueHigh);
}

void PlotInteraction::changed()
{
    m_moved = true;
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    emit viewChanged();
}

void PlotInteraction::fit()
{
    if (m_fit)
        m_fit();
    else
        putBack(m_home);
    m_moved = false;
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    emit fitted();
}

bool PlotInteraction::isUnderMouse() const
{
    return m_plot->isVisible() && m_plot->rect().contains(m_plot->mapFromGlobal(QCursor::pos()));
}

QPointF PlotInteraction::actionPlace() const
{
    if (m_plot->underMouse() && !m_lastAt.isNull())
        return m_lastAt;
    const auto panels = m_plot->axisRects();
    return panels.isEmpty() ? QPointF() : QPointF(panels.front()->rect().center());
}

double PlotInteraction::keyAt(const QPointF &place) const
{
    const auto panels = m_plot->axisRects();
    const QCPAxisRect *panel = panelAt(*m_plot, place);
    if (!panel)
        panel = panels.front();
    const double x = std::clamp(place.x(), double(panel->left()), double(panel->right()));
    return panel->axis(QCPAxis::atBottom)->pixelToCoord(x);
}

void PlotInteraction::zoomAt(const QPointF &place, double factor, Qt::Orientations axes)
{
    QCPAxisRect *panel = panelAt(*m_plot, place);
    if (!panel)
        return;
    if (axes.testFlag(Qt::Horizontal))
        zoomAxis(*panel->axis(QCPAxis::atBottom), factor, place.x(), homeOf(*panel, Qt::Horizontal));
    if (axes.testFlag(Qt::Vertical))
        zoomAxis(*panel->axis(QCPAxis::atLeft), factor, place.y(), homeOf(*panel, Qt::Vertical));
    changed();
}

void PlotInteraction::zoomBy(double factor)
{
    zoomAt(actionPlace(), factor, m_freeAxes);
}

bool PlotInteraction::wheelTurned(QWheelEvent *event)
{
    const QCPAxisRect *panel = panelAt(*m_plot, event->position());
    const int turned = event->angleDelta().y();
    if (!panel || turned == 0)
        return false;
    Qt::Orientations axes = m_freeAxes;
    switch (panelPartAt(*panel, event->position())) {
    case PanelPart::KeyAxis:
        axes = Qt::Horizontal;
        break;
    case PanelPart::ValueAxis:
        axes = Qt::Vertical;
        break;
    case PanelPart::Margin:
        return false;
    case PanelPart::Inside:
        break;
    }
    zoomAt(event->position(), std::pow(kWheelFactor, turned / kDegreesANotch), axes);
    return true;
}

bool PlotInteraction::mousePressed(QMouseEvent *event)
{
    QToolTip::hideText();
    m_hoverTimer.stop();
    if (event->button() != Qt::LeftButton)
        return false;
    m_pressedAt = m_lastAt = event->position();
    m_pressedWith = event->modifiers();
    m_pressedPanel = panelAt(*m_plot, m_pressedAt);
    const auto cursor = m_cursors ? m_cursors->at(m_pressedAt) : std::nullopt;
    if (cursor) {
        m_drag = Drag::MoveCursor;
        m_dragged = *cursor;
        return true;
    }
    m_drag = m_pressedPanel ? Drag::Pending : Drag::None;
    return m_drag != Drag::None;
}

void PlotInteraction::startDrag(Qt::KeyboardModifiers modifiers)
{
    const bool inside = panelPartAt(*m_pressedPanel, m_pressedAt) == PanelPart::Inside;
    if (modifiers.testFlag(Qt::ShiftModifier) && inside)
        m_drag = Drag::Box;
    else if (modifiers.testFlag(Qt::ControlModifier) && m_boxSelection && inside)
        m_drag = Drag::SelectBox;
    else if (m_dragAction == DragAction::SelectKeys && inside)
        m_drag = Drag::SelectKeys;
    else
        m_drag = Drag::Pan;
}

void PlotInteraction::panTo(const QPointF &place)
{
    Qt::Orientations axes = m_freeAxes;
    const PanelPart part = panelPartAt(*m_pressedPanel, m_pressedAt);
    if (part == PanelPart::KeyAxis)
        axes = Qt::Horizontal;
    else if (part == PanelPart::ValueAxis)
        axes = Qt::Vertical;
    if (axes.testFlag(Qt::Horizontal))
        panAxis(*m_pressedPanel->axis(QCPAxis::atBottom), m_lastAt.x(), place.x());
    if (axes.testFlag(Qt::Vertical))
        panAxis(*m_pressedPanel->axis(QCPAxis::atLeft), m_lastAt.y(), place.y());
    changed();
}

void PlotInteraction::selectTo(const QPointF &place)
{
    const QCPAxis &keys = *m_pressedPanel->axis(QCPAxis::atBottom);
    const double left = m_pressedPanel->left();
    const double right = m_pressedPanel->right();
    const double a = keys.pixelToCoord(m_pressedAt.x());
    const double b = keys.pixelToCoord(std::clamp(place.x(), left, right));
    emit keysSelected(m_pressedPanel, std::min(a, b), std::max(a, b));
}

void PlotInteraction::stretchBand(const QPointF &place)
{
    if (!m_band)
        m_band = new QRubberBand(QRubberBand::Rectangle, m_plot);
    const QRect box(m_pressedAt.toPoint(), place.toPoint());
    m_band->setGeometry(box.normalized().intersected(m_pressedPanel->rect()));
    m_band->show();
}

bool PlotInteraction::mouseMoved(QMouseEvent *event)
{
    const QPointF place = event->position();
    if (m_drag == Drag::Pending && !m_pressedPanel)
        m_drag = Drag::None;
    if (m_drag == Drag::Pending && (place - m_pressedAt).manhattanLength() >= kMoved)
        startDrag(m_pressedWith);
    if (m_drag == Drag::None || m_drag == Drag::Pending) {
        updateShape(place);
        m_hoverTimer.start();
    } else if (m_drag == Drag::MoveCursor) {
        m_cursors->place(m_dragged, keyAt(place));
    } else if (!m_pressedPanel) {
        m_drag = Drag::None; // the plot was built anew meanwhile
    } else if (m_drag == Drag::Pan) {
        panTo(place);
    } else if (m_drag == Drag::SelectKeys) {
        selectTo(place);
    } else {
        stretchBand(place);
    }
    m_lastAt = place;
    return m_drag != Drag::None;
}

void PlotInteraction::updateShape(const QPointF &place)
{
    const bool overCursor = m_cursors && m_cursors->at(place);
    if (overCursor)
        m_plot->setCursor(Qt::SizeHorCursor);
    else
        m_plot->unsetCursor();
}

void PlotInteraction::endBox(const QPointF &place)
{
    m_band->hide();
    const QRectF inside = m_pressedPanel->rect();
    const QRectF box = QRectF(m_pressedAt, place).normalized().intersected(inside);
    QCPAxis &keys = *m_pressedPanel->axis(QCPAxis::atBottom);
    QCPAxis &values = *m_pressedPanel->axis(QCPAxis::atLeft);
    if (m_drag == Drag::SelectBox) {
        const QPointF low(keys.pixelToCoord(box.left()), values.pixelToCoord(box.bottom()));
        const QPointF high(keys.pixelToCoord(box.right()), values.pixelToCoord(box.top()));
        emit boxSelected(m_pressedPanel, QRectF(low, high));
        return;
    }
    const bool zoomedKeys = zoomAxisTo(keys, box.left(), box.right());
    const bool zoomedValues = zoomAxisTo(values, box.top(), box.bottom());
    if (zoomedKeys || zoomedValues)
        changed();
}

bool PlotInteraction::mouseReleased(QMouseEvent *event)
{
    const Drag drag = m_drag;
    if (event->button() != Qt::LeftButton || drag == Drag::None)
        return false;
    if (m_pressedPanel && (drag == Drag::Box || drag == Drag::SelectBox)) {
        endBox(event->position());
    } else if (m_pressedPanel && drag == Drag::SelectKeys) {
        selectTo(event->position());
        emit selectionEnded(m_pressedPanel);
    } else if (m_pressedPanel && drag == Drag::Pending) {
        emit clicked(m_pressedPanel, event->position());
    }
    m_drag = Drag::None;
    return true;
}

bool PlotInteraction::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_plot)
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        mousePressed(static_cast<QMouseEvent *>(event));
        break; // the plot takes the focus
    case QEvent::MouseMove:
        return mouseMoved(static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonRelease:
        return mouseReleased(static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent *>(event)->button() == Qt::LeftButton)
            fit();
        return true;
    case QEvent::Wheel:
        if (!wheelTurned(static_cast<QWheelEvent *>(event)))
            break;
        event->accept();
        return true;
    case QEvent::KeyPress:
        return handleKey(static_cast<QKeyEvent *>(event));
    case QEvent::ContextMenu:
        openMenu(static_cast<QContextMenuEvent *>(event)->globalPos());
        return true;
    case QEvent::Leave:
        m_hoverTimer.stop();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace driftbench
