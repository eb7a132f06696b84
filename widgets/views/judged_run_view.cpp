#include "widgets/views/judged_run_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr int kColumns = 320; // of a trace, about one a pixel
static constexpr int kTicks = 4;     // the panels are low
static constexpr double kLowestDeviationDps = 1e-9;

JudgedRunView::JudgedRunView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Held-out run before and after compensation, and its Allan deviation"); }, look,
               parent)
{
    rebuild();
}

void JudgedRunView::setData(JudgedRunData shown)
{
    m_data = std::move(shown);
    rebuild();
}

static QString runList(const std::vector<std::string> &runs)
{
    QStringList names;
    for (const std::string &run : runs)
        names.append(QString::fromStdString(run));
    return names.join(QStringLiteral(", "));
}

void JudgedRunView::buildLegend()
{
    using Kind = LegendEntry::Kind;
    const JudgedTraces &traces = *m_data.traces;
    const QString model = shortModelLabel(traces.model);
    const QString after = traces.trainedOn.empty()
                              ? tr("After, %1").arg(model)
                              : tr("After, %1 trained on %2").arg(model, runList(traces.trainedOn));
    std::vector<LegendEntry> entries{{Kind::Line,
                                      traces.lessConstant ? tr("Before, less the constant") : tr("Before"),
                                      rolePen(Role::Raw, look()),
                                      {}},
                                     {Kind::Line, after, rolePen(Role::Compensated, look()), {}}};
    if (m_data.limitDps)
        entries.push_back(
            {Kind::Line, tr("Limit ±%1 dps").arg(numberText(*m_data.limitDps, 2)), referencePen(look()), {}});
    addLegend(std::move(entries));
}

static void include(const QVector<double> &values, Extent &extent)
{
    for (const double value : values)
        extent.include(value);
}

void JudgedRunView::drawTrace(QCPAxisRect &rect, int axis) const
{
    const JudgedTraces &traces = *m_data.traces;
    const Eigen::VectorXd sinceStart = traces.timeS.array() - traces.timeS[0];
    const double span = sinceStart[sinceStart.size() - 1];
    const TimeScale scale = timeScaleFor(span);
    const Envelope before =
        envelope(sinceStart, traces.beforeDps.col(axis), 0.0, span, kColumns, scale.secondsPerUnit);
    const Envelope after =
        envelope(sinceStart, traces.afterDps.col(axis), 0.0, span, kColumns, scale.secondsPerUnit);
    Extent values;
    for (const Envelope *trace : {&before, &after}) {
        include(trace->low, values);
        include(trace->high, values);
    }
    // A limit far beyond the signal would flatten it; then it stays outside of the panel.
    if (m_data.limitDps && *m_data.limitDps < 3.0 * std::max(values.high(), -values.low())) {
        values.include(*m_data.limitDps);
        values.include(-*m_data.limitDps);
    }
    QCPAxis &left = *rect.axis(QCPAxis::atLeft);
    QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
    left.setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(kTicks)));
    left.setRange(values.padded());
    left.setLabel(axis == 0 ? tr("TDE left (dps)") : QString());
    bottom.setRange(0.0, std::max(span / scale.secondsPerUnit, 1e-9));
    applyTimeScale(bottom, scale, tr("Time in run"));
    addRange(rect, before.key, before.low, before.high, look().rawRange);
    addRange(rect, after.key, after.low, after.high, look().compensatedRange);
    if (m_data.limitDps) {
        addHorizontal(rect, *m_data.limitDps, referencePen(look()));
        addHorizontal(rect, -*m_data.limitDps, referencePen(look()));
    }
    addLine(rect, before.key, before.mean, rolePen(Role::Raw, look()), tr("Before"));
    addLine(rect, after.key, after.mean, rolePen(Role::Compensated, look()), tr("After"));
    (new PanelNotes(&rect, look()))
        ->setName(QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()));
}

namespace {

struct Deviations
{
    QVector<double> tauS, dps;
    double lowest = NAN;
};

} // namespace

static Deviations deviationsOf(const AllanCurve &curve, int axis)
{
    Deviations result;
    for (Eigen::Index i = 0; i < curve.tauS.size(); ++i) {
        const double value = curve.deviationDps(i, axis);
        if (!(value > kLowestDeviationDps) || !std::isfinite(value) || !(curve.tauS[i] > 0.0))
            continue;
        result.tauS.append(curve.tauS[i]);
        result.dps.append(value);
        result.lowest = std::fmin(result.lowest, value);
    }
    return result;
}

void JudgedRunView::drawAllan(QCPAxisRect &rect, int axis) const
{
    Extent tau, deviation;
    for (const AllanCurve *curve : {&m_data.traces->allanBefore, &m_data.traces->allanAfter}) {
        for (int each = 0; each < kAxisCount; ++each) {
            const Deviations values = deviationsOf(*curve, each);
            include(values.tauS, tau);
            include(values.dps, deviation);
        }
    }
    if (tau.empty()) {
        tau.include(1.0);
        deviation.include(1.0);
    }
    QCPAxis &left = *rect.axis(QCPAxis::atLeft);
    QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
    applyLogScale(bottom, tau.low(), tau.high());
    bottom.setRange(tau.low() / 1.25, tau.high() * 1.25);
    applyLogScale(left, deviation.low(), deviation.high());
    bottom.setLabel(tr("Averaging time τ (s)"));
    left.setLabel(axis == 0 ? tr("σ(τ) (dps)") : QString());
    const Deviations before = deviationsOf(m_data.traces->allanBefore, axis);
    const Deviations after = deviationsOf(m_data.traces->allanAfter, axis);
    addLine(rect, before.tauS, before.dps, rolePen(Role::Raw, look()), tr("Before"));
    addLine(rect, after.tauS, after.dps, rolePen(Role::Compensated, look()), tr("After"));
    (new PanelNotes(&rect, look()))
        ->setNote(tr("lowest %1 before, %2 dps after")
                      .arg(deviationText(before.lowest), deviationText(after.lowest)));
}

void JudgedRunView::build()
{
    if (!m_data.traces || m_data.traces->timeS.size() == 0) {
        showEmpty(tr("No run to judge"), tr("Train a model and choose a run that it has not seen."));
        return;
    }
    buildLegend();
    QCPLayoutGrid &grid = addPanels();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        drawTrace(addPanel(grid, 0, axis), axis);
        drawAllan(addPanel(grid, 1, axis), axis);
    }
}

} // namespace driftbench
