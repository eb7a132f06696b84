#include "widgets/live/live_trace_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/tickers.h"

#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kShortestRunS = 60.0;
static constexpr double kRoomAhead = 0.04; // of the span, right of now
static constexpr double kTagMeanS = 1.0;
static constexpr double kGrowRunBy = 1.25; // without a plan the view grows in steps

LiveTraceView::LiveTraceView(const Palette &look, QWidget *parent)
    : QWidget(parent)
    , m_look(look)
    , m_plot(new QCustomPlot(this))
    , m_traces(std::make_unique<TracePyramid>())
    , m_strips(std::make_unique<LiveStrips>(*m_plot, look))
    , m_marks(std::make_unique<LiveMarks>(m_plot, look))
    , m_interaction(new PlotInteraction(m_plot, look))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_interaction->enableCursors();
    m_interaction->setFreeAxes(Qt::Horizontal);
    m_interaction->setHoverText([this](const QPointF &place) { return hoverText(place); });
    m_interaction->setTable([this] { return table(); });
    m_interaction->setFit([this] {
        m_following = m_fitsValues = true;
        m_ranges.reset();
        refresh();
    });
    m_repaint.setSingleShot(true);
    connect(&m_repaint, &QTimer::timeout, this, &LiveTraceView::refresh);
    connect(m_interaction, &PlotInteraction::viewChanged, this, [this] {
        m_following = false;
        const auto &before = m_ranges;
        for (int axis = 0; before && axis < kAxisCount; ++axis) {
            const QCPRange shown = m_strips->panel(axis).axis(QCPAxis::atLeft)->range();
            const ValueRange fitted = (*before)[static_cast<std::size_t>(axis)];
            if (shown.lower != fitted.low || shown.upper != fitted.high)
                m_fitsValues = false; // the user has set them
        }
        makeDirty();
    });
    connect(&cursors(), &PlotCursors::changed, this, &LiveTraceView::cursorsChanged);
    rebuild();
    retranslate();
}

LiveTraceView::~LiveTraceView()
{
    delete m_plot; // it draws the marks
}

void LiveTraceView::setLook(const Palette &look)
{
    m_look = look;
    m_marks->look = look;
    m_interaction->setLook(look);
    rebuild();
    emit legendChanged();
}

void LiveTraceView::retranslate()
{
    const QString name = tr("Live traces");
    setAccessibleName(name);
    m_plot->setAccessibleName(name);
    followLocale(*m_plot);
    m_interaction->setTitle(name);
    m_strips->setKeyTitle(tr("Time since start (h:min)"), tr("Time since start (h:min:s)"));
    m_strips->setValueTitles(valueTitles());
    makeDirty();
    emit legendChanged();
}

void LiveTraceView::rebuild()
{
    const QCPRange keys = m_plot->axisRectCount() == LiveStrips::kStrips && !m_following
                              ? m_strips->keys().range()
                              : QCPRange(0.0, kShortestRunS);
    m_strips->build(m_look, valueTitles());
    m_strips->keys().setRange(keys);
    m_ranges.reset();
    showPlanPart();
    m_interaction->rememberHome();
    makeDirty();
}

QStringList LiveTraceView::valueTitles() const
{
    QStringList titles;
    for (const std::string_view axis : kAxisNames) {
        const QString name = QString::fromUtf8(axis.data(), static_cast<qsizetype>(axis.size()));
        titles.append(m_quantity == LiveQuantity::Rate ? tr("%1 rate (dps)").arg(name)
                                                       : tr("%1 TDE (dps)").arg(name));
    }
    titles.append(tr("T (°C)"));
    return titles;
}

void LiveTraceView::clear()
{
    m_traces = std::make_unique<TracePyramid>();
    m_marks->gaps.clear();
    m_marks->events.clear();
    m_marks->holds.clear();
    m_pausedAtS.reset();
    m_finished = false;
    m_following = m_fitsValues = true;
    m_ranges.reset();
    cursors().clear();
    makeDirty();
    emit legendChanged();
}

void LiveTraceView::setReference(const std::optional<Eigen::Vector3d> &rateDps)
{
    m_referenceDps = rateDps;
    makeDirty();
    emit legendChanged();
}

void LiveTraceView::setPlan(const std::optional<TemperatureProfile> &profile)
{
    m_plan = profile;
    showPlanPart();
    makeDirty();
}

// The steps of the plan as they are asked for; a stair of half a degree looks like its slope.
void LiveTraceView::showPlanPart()
{
    PlanLine line;
    if (m_plan) {
        for (const ProfileStep &step : m_plan->steps()) {
            if (!line.timeS.isEmpty()) {
                line.timeS.append(step.startS);
                line.setpointC.append(line.setpointC.last());
            }
            line.timeS.append(step.startS);
            line.setpointC.append(step.setpointC);
        }
        line.timeS.append(m_plan->durationS());
        line.setpointC.append(line.setpointC.last());
        m_marks->planLabelS = m_plan->durationS();
        m_marks->planLabelC = line.setpointC.last();
    } else {
        m_marks->planLabelS.reset();
    }
    m_strips->showPlan(line);
}

void LiveTraceView::setCompensated(bool on)
{
    if (m_compensated == on)
        return;
    m_compensated = on;
    makeDirty();
    emit legendChanged();
}

void LiveTraceView::setFinished(bool finished)
{
    m_finished = finished;
    makeDirty();
}

void LiveTraceView::append(const SampleBlock &block, const Eigen::MatrixX3d &compensatedDps)
{
    const bool compensated = compensatedDps.rows() == block.size() && block.size() > 0;
    for (Eigen::Index i = 0; i < block.size(); ++i) {
        TracePyramid::Values values;
        values.fill(std::numeric_limits<float>::quiet_NaN());
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            values[TracePyramid::kRaw + at] = static_cast<float>(block.rateDps(i, axis));
            if (compensated)
                values[TracePyramid::kCompensated + at] = static_cast<float>(compensatedDps(i, axis));
        }
        values[TracePyramid::kTemperature] = static_cast<float>(block.temperatureC[i]);
        m_traces->add(block.timeS[i], values);
    }
    if (!isPaused())
        makeDirty();
}

void LiveTraceView::addGap(const LiveGap &gap)
{
    const bool first = m_marks->gaps.empty();
    m_marks->addGap(gap);
    makeDirty();
    if (first)
        emit legendChanged();
}

void LiveTraceView::addEvent(double timeS, const QString &sentence)
{
    m_marks->addEvent({timeS, sentence});
    makeDirty();
}

void LiveTraceView::setHolds(std::vector<LiveHold> holds)
{
    m_marks->holds = std::move(holds);
    makeDirty();
}

void LiveTraceView::setSpan(LiveSpan span)
{
    m_span = span;
    m_following = true;
    makeDirty();
}

void LiveTraceView::setQuantity(LiveQuantity quantity)
{
    m_quantity = quantity;
    m_fitsValues = true;
    m_ranges.reset();
    m_strips->setValueTitles(valueTitles());
    makeDirty();
}

void LiveTraceView::setPaused(bool paused)
{
    if (paused == isPaused())
        return;
    m_pausedAtS = paused ? std::optional(m_traces->lastS()) : std::nullopt;
    m_samplesAtPause = m_traces->samples();
    makeDirty();
}

std::int64_t LiveTraceView::samplesSincePause() const
{
    return isPaused() ? m_traces->samples() - m_samplesAtPause : 0;
}

double LiveTraceView::nowS() const
{
    return m_pausedAtS.value_or(m_traces->lastS());
}

Eigen::Vector3d LiveTraceView::shiftDps() const
{
    return m_quantity == LiveQuantity::Tde
               ? Eigen::Vector3d(-m_referenceDps.value_or(Eigen::Vector3d::Zero()))
               : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void LiveTraceView::makeDirty()
{
    m_dirty = true;
    if (!isVisible() || m_repaint.isActive())
        return;
    const qint64 since = m_sinceRepaint.isValid() ? m_sinceRepaint.elapsed() : kShortestRepaintMs;
    m_repaint.start(static_cast<int>(std::clamp<qint64>(kShortestRepaintMs - since, 0, kShortestRepaintMs)));
}

void LiveTraceView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_dirty)
        makeDirty();
}

void LiveTraceView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    makeDirty();
}

void LiveTraceView::follow()
{
    const double now = nowS();
    if (m_span == LiveSpan::Run) {
        double endS = m_plan ? m_plan->durationS() : kShortestRunS;
        while (endS < now)
            endS *= kGrowRunBy;
        m_strips->keys().setRange(0.0, m_finished && !m_traces->empty() ? std::max(now, 1.0) : endS);
        return;
    }
    const double spanS = m_span == LiveSpan::TenMinutes ? 600.0 : 60.0;
    const double endS = std::max(now + kRoomAhead * spanS, spanS);
    m_strips->keys().setRange(endS - spanS, endS);
}

TracePyramid::Envelopes LiveTraceView::visible() const
{
    const QCPRange range = m_strips->keys().range();
    return m_traces->envelopes(std::max(range.lower, m_traces->firstS()), std::min(range.upper, nowS()),
                               range.size() / m_strips->columns());
}

void LiveTraceView::fitValues(const TracePyramid::Envelopes &shownData)
{
    std::array<Extent, 3> extents;
    Extent temperature;
    const Eigen::Vector3d shift = shiftDps();
    for (qsizetype i = 0; i < shownData.timeS.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const std::size_t trace : {TracePyramid::kRaw + axis, TracePyramid::kCompensated + axis}) {
                const double by = shift[static_cast<Eigen::Index>(axis)];
                extents[axis].include(shownData.low[trace][i] + by);
                extents[axis].include(shownData.high[trace][i] + by);
            }
        }
        temperature.include(shownData.low[TracePyramid::kTemperature][i]);
        temperature.include(shownData.high[TracePyramid::kTemperature][i]);
    }
    if (m_referenceDps && m_span == LiveSpan::Run) {
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            extents[static_cast<std::size_t>(axis)].include((*m_referenceDps)[axis] + shift[axis]);
    }
    if (m_plan && m_span == LiveSpan::Run) {
        temperature.include(m_plan->lowestC());
        temperature.include(m_plan->highestC());
    }
    m_ranges = commonRanges(extents, m_ranges);
    const QCPRange shown = temperature.padded(0.12);
    m_strips->showValueRanges(*m_ranges, {shown.lower, shown.upper});
}

void LiveTraceView::refresh()
{
    m_repaint.stop();
    m_dirty = false;
    m_sinceRepaint.start();
    if (m_following)
        follow();
    const auto shownData = visible();
    m_strips->showData(shownData, shiftDps(), m_compensated);
    if (m_fitsValues)
        fitValues(shownData);
    std::optional<Eigen::Vector3d> reference;
    if (m_referenceDps)
        reference = *m_referenceDps + shiftDps();
    m_strips->showReference(reference);
    auto latest = m_traces->means(nowS() - kTagMeanS, nowS());
    for (std::size_t axis = 0; latest && axis < 3; ++axis) {
        (*latest)[TracePyramid::kRaw + axis] += shiftDps()[static_cast<Eigen::Index>(axis)];
        (*latest)[TracePyramid::kCompensated + axis] += shiftDps()[static_cast<Eigen::Index>(axis)];
    }
    m_strips->showTags(latest, m_compensated);
    m_strips->updateTickers();
    m_marks->nowS = nowS();
    m_marks->showPending = !m_finished && !m_traces->empty();
    m_plot->replot(QCustomPlot::rpQueuedRefresh);
    emit refreshed();
}

} // namespace driftbench
