#include "widgets/live/live_strips.h"

#include "widgets/plot/axis_moves.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/range_graph.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <QCoreApplication>

#include <cmath>

namespace driftbench {

// Heights of the strips with their surroundings, as drawn: room for the cursors' tags above the first, for
// the time below the last.
static constexpr std::array<double, LiveStrips::kStrips> kHeights{156.0, 140.0, 140.0, 144.0};
static constexpr std::array<int, LiveStrips::kStrips> kAbove{24, 10, 10, 10};
static constexpr std::array<int, LiveStrips::kStrips> kBelow{6, 6, 6, 46};
static constexpr int kSide = 8;
static constexpr int kTallStrip = 150;
static constexpr double kFar = 1e12; // s: reference lines have no end

static QString stripWords(const char *text)
{
    return QCoreApplication::translate("driftbench::LiveStrips", text);
}

LiveStrips::LiveStrips(QCustomPlot &plot, const Palette &look) : m_plot(plot), m_look(look) {}

void LiveStrips::build(const Palette &look, const QStringList &valueTitles)
{
    m_look = look;
    m_plot.clearPlottables();
    m_plot.clearItems();
    m_plot.plotLayout()->clear();
    m_plot.plotLayout()->simplify();
    delete m_margins;
    m_margins = new QCPMarginGroup(&m_plot);
    applyPlotStyle(m_plot, m_look);
    // One buffer less to put together at every repaint.
    m_plot.layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical);
    m_plot.plotLayout()->setMargins(QMargins(kSide, 0, kSide, 0));
    m_plot.plotLayout()->setRowSpacing(0);
    QList<QCPAxis *> keyAxes;
    for (int strip = 0; strip < kStrips; ++strip) {
        buildStrip(strip, m_margins);
        keyAxes.append(panel(strip).axis(QCPAxis::atBottom));
    }
    linkAxes(keyAxes);
    setValueTitles(valueTitles);
}

void LiveStrips::buildStrip(int row, QCPMarginGroup *margins)
{
    const auto at = static_cast<std::size_t>(row);
    Strip &strip = m_strips[at];
    strip = {};
    strip.panel = new QCPAxisRect(&m_plot);
    m_plot.plotLayout()->addElement(row, 0, strip.panel);
    m_plot.plotLayout()->setRowStretchFactor(row, kHeights[at]);
    applyPlotStyle(*strip.panel, m_look);
    strip.panel->setAutoMargins(QCP::msLeft | QCP::msRight);
    strip.panel->setMargins(QMargins(0, kAbove[at], 0, kBelow[at]));
    strip.panel->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    QCPAxis &keys = *strip.panel->axis(QCPAxis::atBottom);
    keys.setTicker(QSharedPointer<QCPAxisTicker>(new ClockTicker));
    if (row + 1 < kStrips)
        hideAxisText(keys);
    const bool temperature = row + 1 == kStrips;
    addSeries(strip, temperature);
    strip.notes = new PanelNotes(strip.panel, m_look);
    const QString widest = stripWords(QT_TRANSLATE_NOOP("driftbench::LiveStrips", "%1 comp."));
    strip.notes->setMarginRoom(widest.arg(QStringLiteral("−000.00")));
}

void LiveStrips::addSeries(Strip &strip, bool temperature)
{
    QCPAxis *keys = strip.panel->axis(QCPAxis::atBottom);
    QCPAxis *values = strip.panel->axis(QCPAxis::atLeft);
    const auto graph = [&](const QPen &pen) {
        auto *line = new QCPGraph(keys, values);
        line->setPen(pen);
        line->setAdaptiveSampling(false); // it is thinned already
        return line;
    };
    if (temperature) {
        strip.plan = graph(referencePen(m_look));
        strip.raw = graph(QPen(m_look.text, 1.0));
        return;
    }
    strip.rawBand = new RangeGraph(keys, values);
    strip.rawBand->setBrush(m_look.rawRange);
    strip.compensatedBand = new RangeGraph(keys, values);
    strip.compensatedBand->setBrush(m_look.compensatedRange);
    strip.reference = new QCPItemStraightLine(&m_plot);
    strip.reference->setClipAxisRect(strip.panel);
    strip.reference->setAntialiased(false);
    strip.reference->setPen(referencePen(m_look));
    strip.reference->setVisible(false);
    for (QCPItemPosition *position : {strip.reference->point1, strip.reference->point2}) {
        position->setAxisRect(strip.panel);
        position->setAxes(keys, values);
        position->setType(QCPItemPosition::ptPlotCoords);
    }
    strip.raw = graph(rolePen(Role::Raw, m_look));
    strip.compensated = graph(rolePen(Role::Compensated, m_look));
}

void LiveStrips::setValueTitles(const QStringList &titles)
{
    for (int strip = 0; strip < kStrips; ++strip)
        panel(strip).axis(QCPAxis::atLeft)->setLabel(titles.value(strip));
}

void LiveStrips::setKeyTitle(const QString &hours, const QString &seconds)
{
    m_hoursTitle = hours;
    m_secondsTitle = seconds;
}

QCPAxis &LiveStrips::keys() const
{
    return *panel(0).axis(QCPAxis::atBottom);
}

int LiveStrips::columns() const
{
    return std::max(panel(0).width(), 1);
}

static QVector<double> shifted(QVector<double> values, double by)
{
    if (by != 0.0) {
        for (double &value : values)
            value += by;
    }
    return values;
}

void LiveStrips::showData(const TracePyramid::Envelopes &data, const Eigen::Vector3d &shiftDps,
                          bool compensated)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Strip &strip = m_strips[axis];
        const double shift = shiftDps[static_cast<Eigen::Index>(axis)];
        const auto show = [&](std::size_t trace, RangeGraph &band, QCPGraph &line) {
            const QVector<double> low = shifted(data.low[trace], shift);
            band.setBand(data.timeS, low, shifted(data.high[trace], shift));
            line.setData(data.timeS, shifted(data.mean[trace], shift), true);
        };
        show(TracePyramid::kRaw + axis, *strip.rawBand, *strip.raw);
        strip.compensatedBand->setVisible(compensated);
        strip.compensated->setVisible(compensated);
        if (compensated)
            show(TracePyramid::kCompensated + axis, *strip.compensatedBand, *strip.compensated);
    }
    m_strips.back().raw->setData(data.timeS, data.mean[TracePyramid::kTemperature], true);
}

void LiveStrips::showReference(const std::optional<Eigen::Vector3d> &rateDps)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QCPItemStraightLine *line = m_strips[axis].reference;
        line->setVisible(rateDps.has_value());
        if (!rateDps)
            continue;
        const double value = (*rateDps)[static_cast<Eigen::Index>(axis)];
        line->point1->setCoords(0.0, value);
        line->point2->setCoords(kFar, value);
    }
}

void LiveStrips::showPlan(const PlanLine &plan)
{
    m_strips.back().plan->setData(plan.timeS, plan.setpointC, true);
}

void LiveStrips::showValueRanges(const std::array<ValueRange, 3> &rates, const ValueRange &temperature)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_strips[axis].panel->axis(QCPAxis::atLeft)->setRange(rates[axis].low, rates[axis].high);
    m_strips.back().panel->axis(QCPAxis::atLeft)->setRange(temperature.low, temperature.high);
}

void LiveStrips::showTags(const std::optional<std::array<double, TracePyramid::kTraces>> &values,
                          bool compensated)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<MarginLabel> labels;
        if (values) {
            const double raw = (*values)[TracePyramid::kRaw + axis];
            labels.push_back(
                {raw, rolePen(Role::Raw, m_look),
                 stripWords(QT_TRANSLATE_NOOP("driftbench::LiveStrips", "%1 raw")).arg(numberText(raw, 2)),
                 false});
        }
        if (values && compensated) {
            const double after = (*values)[TracePyramid::kCompensated + axis];
            labels.push_back({after, rolePen(Role::Compensated, m_look),
                              stripWords(QT_TRANSLATE_NOOP("driftbench::LiveStrips", "%1 comp."))
                                  .arg(numberText(after, 2)),
                              true});
        }
        m_strips[axis].notes->setMarginLabels(std::move(labels));
    }
    std::vector<MarginLabel> labels;
    if (values) {
        const double temperature = (*values)[TracePyramid::kTemperature];
        labels.push_back(
            {temperature, QPen(m_look.text, 1.0), numberText(temperature, 2) + QStringLiteral(" °C"), true});
    }
    m_strips.back().notes->setMarginLabels(std::move(labels));
}

void LiveStrips::updateTickers()
{
    for (Strip &strip : m_strips) {
        const int ticks = strip.panel->height() > kTallStrip ? 5 : 3;
        strip.panel->axis(QCPAxis::atLeft)->ticker()->setTickCount(ticks);
    }
    const double stepS = ClockTicker::stepFor(keys().range().size(), keys().ticker()->tickCount());
    const QString title = ClockTicker::needsSeconds(stepS) ? m_secondsTitle : m_hoursTitle;
    QCPAxis *bottom = m_strips.back().panel->axis(QCPAxis::atBottom);
    if (bottom->label() != title)
        bottom->setLabel(title);
}

} // namespace driftbench
