#include "widgets/views/exclusion_strip.h"

#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/fonts.h"

#include <QMouseEvent>
#include <QPointer>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kCatch = 4.0;
static constexpr double kGripWidth = 5.0;
static constexpr double kGripHeight = 20.0;
static constexpr int kFillAlpha = 31; // 12 %
static constexpr double kShortestS = 1e-3;
static constexpr double kSelectedDot = 3.0;

// Hatches, grips and the selection; on the cursors' layer, so that dragging draws nothing else again.
class ExclusionStrip::Marks : public QCPLayerable
{
public:
    Marks(QCustomPlot *plot, const ExclusionStrip *strip)
        : QCPLayerable(plot, QStringLiteral("cursors")), m_strip(strip)
    {
    }

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(false); }

    void draw(QCPPainter *painter) override
    {
        const auto panels = mParentPlot->axisRects();
        if (panels.isEmpty() || m_strip->isEmpty())
            return;
        const QRectF inside = panels.front()->rect();
        for (std::size_t i = 0; i < m_strip->m_shown.ranges.size(); ++i)
            drawRange(*painter, inside, m_strip->m_shown.ranges[i], m_strip->m_picked == i);
        if (m_strip->m_selection)
            drawSelection(*painter, inside, *m_strip->m_selection);
    }

private:
    QRectF areaOf(const QRectF &inside, const StripRange &range) const
    {
        const double left = std::clamp(m_strip->pixelOf(range.startS), inside.left(), inside.right());
        const double right = std::clamp(m_strip->pixelOf(range.endS), inside.left(), inside.right());
        return {left, inside.top(), right - left, inside.height()};
    }

    void drawRange(QCPPainter &painter, const QRectF &inside, const StripRange &range, bool picked) const
    {
        const Palette &look = m_strip->look();
        const QRectF area = areaOf(inside, range);
        if (area.width() < 0.5)
            return;
        QColor fill = picked ? look.accent : look.constant;
        fill.setAlpha(kFillAlpha);
        painter.fillRect(area, fill);
        painter.fillRect(area, QBrush(look.excluded, Qt::BDiagPattern));
        if (!range.own)
            return;
        painter.setPen(QPen(picked ? look.accent : look.axisLine, 1.0));
        for (const double x : {area.left(), area.right()}) {
            painter.setAntialiasing(false);
            painter.drawLine(QLineF(std::floor(x) + 0.5, area.top(), std::floor(x) + 0.5, area.bottom()));
            painter.setBrush(look.base);
            painter.setAntialiasing(true);
            painter.drawRoundedRect(QRectF(std::floor(x) - kGripWidth / 2 + 0.5,
                                           std::floor(area.center().y()) - kGripHeight / 2 + 0.5, kGripWidth,
                                           kGripHeight),
                                    1.5, 1.5);
            painter.setBrush(Qt::NoBrush);
        }
        const QString word = ExclusionStrip::tr("excluded");
        if (QFontMetrics(noteFont()).horizontalAdvance(word) + 4 > area.width())
            return;
        painter.setFont(noteFont());
        painter.setPen(look.text);
        painter.drawText(area.adjusted(0, 0, 0, -4), Qt::AlignHCenter | Qt::AlignBottom, word);
    }

    void drawSelection(QCPPainter &painter, const QRectF &inside, const StripRange &range) const
    {
        const Palette &look = m_strip->look();
        const QRectF area = areaOf(inside, range);
        QColor fill = look.accent;
        fill.setAlpha(kFillAlpha);
        painter.setAntialiasing(false);
        painter.fillRect(area, fill);
        painter.setPen(QPen(look.accent, 1.0));
        painter.drawLine(QLineF(area.topLeft(), area.bottomLeft()));
        painter.drawLine(QLineF(area.topRight(), area.bottomRight()));
    }

    QPointer<const ExclusionStrip> m_strip;
};

ExclusionStrip::ExclusionStrip(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Drift error over time"); }, look, parent)
{
    setLegendInside(false);
    PlotInteraction &interaction = enableInteraction();
    interaction.enableCursors(); // for its layer
    interaction.setDragAction(PlotInteraction::DragAction::SelectKeys);
    interaction.setFreeAxes(Qt::Horizontal);
    new Marks(&plot(), this);        // the plot's
    plot().installEventFilter(this); // before the interaction's
    connect(&interaction, &PlotInteraction::keysSelected, this,
            [this](QCPAxisRect *, double low, double high) {
                m_selection = StripRange{low * m_secondsPerUnit, high * m_secondsPerUnit, true};
                redrawMarks();
                emit selected(m_selection->startS, m_selection->endS);
            });
    connect(&interaction, &PlotInteraction::selectionEnded, this, &ExclusionStrip::selectionEnded);
    connect(&interaction, &PlotInteraction::clicked, this, [this](QCPAxisRect *, const QPointF &place) {
        if (const auto range = rangeAt(place))
            emit rangePicked(*range);
        else
            emit pickedNothing();
    });
    rebuild();
}

ExclusionStrip::~ExclusionStrip()
{
    plot().removeEventFilter(this);
}

void ExclusionStrip::setData(StripData shown)
{
    m_shown = std::move(shown);
    if (m_picked && *m_picked >= m_shown.ranges.size())
        m_picked.reset();
    rebuild();
}

void ExclusionStrip::setSelection(const std::optional<StripRange> &selection)
{
    m_selection = selection;
    redrawMarks();
}

void ExclusionStrip::setPicked(std::optional<std::size_t> range)
{
    m_picked = range;
    redrawMarks();
}

void ExclusionStrip::redrawMarks()
{
    plot().layer(QStringLiteral("cursors"))->replot();
}

double ExclusionStrip::secondAt(double pixel) const
{
    return plot().axisRects().front()->axis(QCPAxis::atBottom)->pixelToCoord(pixel) * m_secondsPerUnit;
}

double ExclusionStrip::pixelOf(double second) const
{
    return plot().axisRects().front()->axis(QCPAxis::atBottom)->coordToPixel(second / m_secondsPerUnit);
}

std::optional<ExclusionStrip::Edge> ExclusionStrip::edgeAt(const QPointF &place) const
{
    if (isEmpty() || !plot().axisRects().front()->rect().contains(place.toPoint()))
        return std::nullopt;
    std::optional<Edge> nearest;
    double distance = kCatch;
    for (std::size_t i = 0; i < m_shown.ranges.size(); ++i) {
        if (!m_shown.ranges[i].own)
            continue;
        for (const bool start : {true, false}) {
            const double edge = pixelOf(start ? m_shown.ranges[i].startS : m_shown.ranges[i].endS);
            if (std::abs(edge - place.x()) <= distance) {
                distance = std::abs(edge - place.x());
                nearest = Edge{i, start};
            }
        }
    }
    return nearest;
}

std::optional<std::size_t> ExclusionStrip::rangeAt(const QPointF &place) const
{
    const double second = secondAt(place.x());
    for (std::size_t i = 0; i < m_shown.ranges.size(); ++i) {
        const StripRange &range = m_shown.ranges[i];
        if (range.own && second >= range.startS && second <= range.endS)
            return i;
    }
    return std::nullopt;
}

bool ExclusionStrip::dragEdge(QEvent *event)
{
    auto *mouse = static_cast<QMouseEvent *>(event);
    if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) {
        m_dragged = edgeAt(mouse->position());
        return m_dragged.has_value();
    }
    if (!m_dragged) {
        if (event->type() == QEvent::MouseMove && mouse->buttons() == Qt::NoButton &&
            edgeAt(mouse->position())) {
            plot().setCursor(Qt::SizeHorCursor);
            return true;
        }
        return false;
    }
    StripRange &range = m_shown.ranges[m_dragged->range];
    const double second = std::clamp(secondAt(mouse->position().x()), 0.0, m_shown.spanS);
    if (m_dragged->start)
        range.startS = std::min(second, range.endS - kShortestS);
    else
        range.endS = std::max(second, range.startS + kShortestS);
    redrawMarks();
    if (event->type() == QEvent::MouseButtonRelease) {
        const std::size_t moved = m_dragged->range;
        m_dragged.reset();
        emit rangeMoved(moved, range.startS, range.endS);
    }
    return true;
}

bool ExclusionStrip::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        if (watched == &plot() && dragEdge(event))
            return true;
        break;
    default:
        break;
    }
    return PlotView::eventFilter(watched, event);
}

static QVector<double> inUnits(QVector<double> seconds, double secondsPerUnit)
{
    for (double &second : seconds)
        second /= secondsPerUnit;
    return seconds;
}

void ExclusionStrip::build()
{
    if (m_shown.heating.timeS.isEmpty() && m_shown.cooling.timeS.isEmpty() &&
        m_shown.excluded.timeS.isEmpty()) {
        showEmpty(tr("No samples"), tr("Record a run, or open a log file."));
        return;
    }
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    const TimeScale scale = timeScaleFor(m_shown.spanS);
    m_secondsPerUnit = scale.secondsPerUnit;
    QCPAxis &keys = *rect.axis(QCPAxis::atBottom);
    keys.setRange(0.0, std::max(m_shown.spanS, 1.0) * 1.01 / m_secondsPerUnit);
    applyTimeScale(keys, scale, tr("Time"));
    Extent extent;
    for (const StripDots *dots : {&m_shown.heating, &m_shown.cooling}) {
        for (const double value : dots->valueDps)
            extent.include(value);
    }
    if (extent.empty()) {
        for (const double value : m_shown.excluded.valueDps)
            extent.include(value);
    }
    QCPAxis &values = *rect.axis(QCPAxis::atLeft);
    values.setRange(extent.padded());
    values.ticker()->setTickCount(3);
    values.setLabel(m_shown.valueLabel);
    const auto add = [&](const StripDots &dots, const QColor &color, const QString &name, double size = 1.5) {
        addDots(rect, inUnits(dots.timeS, m_secondsPerUnit), dots.valueDps, color, size, name);
    };
    for (const double startS : m_shown.runStartsS)
        addVertical(rect, startS / m_secondsPerUnit, QPen(look().grid, 1.0));
    add(m_shown.excluded, look().excluded, tr("Excluded"));
    add(m_shown.heating, look().heating, tr("Heating"));
    add(m_shown.cooling, look().cooling, tr("Cooling"));
    add(m_shown.selected, look().accent, tr("Selected"), kSelectedDot);
}

} // namespace driftbench
