#include "widgets/views/tcq_time_view.h"

#include "engine/base/axes.h"
#include "engine/features/temperature_quantities.h"
#include "widgets/plot/axis_moves.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/role_pens.h"

namespace driftbench {

static constexpr int kColumns = 420;
static constexpr double kLastRowStretch = 1.28; // room for the time below it

TcqTimeView::TcqTimeView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Temperature quantities and drift error over time"); }, look, parent)
{
    rebuild();
}

TcqTimeTraces tcqTimeTraces(const RunFeatures &run)
{
    TcqTimeTraces shown;
    if (run.timeS.size() == 0)
        return shown;
    const Eigen::VectorXd sinceStart = run.timeS.array() - run.timeS[0];
    shown.spanS = sinceStart[sinceStart.size() - 1];
    Eigen::VectorXd quantity; // one at a time: a run may be long
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        quantity = run.deltaT.unaryExpr([i](double deltaT) { return temperatureQuantities(deltaT)[i]; });
        shown.traces[at] = envelope(sinceStart, quantity, 0.0, shown.spanS, kColumns);
        shown.traces[3 + at] = envelope(sinceStart, run.tdeDps.col(i), 0.0, shown.spanS, kColumns);
    }
    return shown;
}

void TcqTimeView::setRun(std::shared_ptr<const RunFeatures> run)
{
    setTraces(run ? tcqTimeTraces(*run) : TcqTimeTraces{});
}

void TcqTimeView::setTraces(TcqTimeTraces traces)
{
    m_shown = std::move(traces);
    rebuild();
}

namespace {

// One panel: what is drawn in it, over the time of the run.
struct Strip
{
    QString title;
    const Envelope *trace = nullptr;
    QPen line;
    QColor fill;
};

} // namespace

static void drawStrip(QCPAxisRect &rect, const Strip &strip, const TimeScale &scale)
{
    const Envelope &trace = *strip.trace;
    Extent extent;
    QVector<double> keys = trace.key;
    for (double &key : keys)
        key /= scale.secondsPerUnit;
    for (qsizetype i = 0; i < trace.key.size(); ++i) {
        extent.include(trace.low[i]);
        extent.include(trace.high[i]);
    }
    rect.axis(QCPAxis::atLeft)->setRange(extent.padded());
    rect.axis(QCPAxis::atLeft)->setLabel(strip.title);
    addRange(rect, keys, trace.low, trace.high, strip.fill);
    addLine(rect, keys, trace.mean, strip.line, strip.title);
}

void TcqTimeView::build()
{
    if (m_shown.traces.front().key.isEmpty()) {
        showEmpty(tr("No run yet"), tr("Record a run, or open a log file."));
        return;
    }
    const QPen temperature(look().text, 1.0);
    addLegend(
        {{LegendEntry::Kind::Line, tr("Temperature quantity"), temperature, {}},
         {LegendEntry::Kind::Range, tr("TDE, mean and range"), rolePen(Role::Raw, look()), look().rawRange}});
    const std::array<QString, 3> names{tr("ΔT (°C)"), tr("ΔT² (°C²)"), tr("√ΔT (√°C)")};
    std::array<Strip, 6> strips;
    for (std::size_t k = 0; k < 3; ++k) {
        strips[2 * k] = {names[k], &m_shown.traces[k], temperature, look().grid};
        const QString axis = QString::fromUtf8(kAxisNames[k].data());
        strips[2 * k + 1] = {tr("TDE, %1 (dps)").arg(axis), &m_shown.traces[3 + k],
                             rolePen(Role::Raw, look()), look().rawRange};
    }

    const TimeScale scale = timeScaleFor(m_shown.spanS);
    Extent time;
    time.include(0.0);
    time.include(m_shown.spanS / scale.secondsPerUnit);
    QCPLayoutGrid &grid = addPanels();
    QList<QCPAxis *> keys;
    for (int i = 0; i < 6; ++i) {
        QCPAxisRect &rect = addPanel(grid, i / 2, i % 2);
        drawStrip(rect, strips[static_cast<std::size_t>(i)], scale);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        bottom.setRange(time.padded(0.0));
        applyTimeScale(bottom, scale, tr("Time since start"));
        if (i / 2 < 2)
            hideAxisText(bottom);
        auto *notes = new PanelNotes(&rect, look());
        notes->setMarginLabels({});
        keys.append(&bottom);
    }
    linkAxes(keys);
    grid.setRowStretchFactor(2, kLastRowStretch);
}

} // namespace driftbench
