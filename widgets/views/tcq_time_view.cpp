#include "widgets/views/tcq_time_view.h"

#include "engine/base/axes.h"
#include "engine/features/temperature_quantities.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/role_pens.h"

namespace driftbench {

static constexpr int kColumns = 420;
static constexpr double kLastRowStretch = 1.28; // room for the time below it

TcqTimeView::TcqTimeView(const Palette &look, QWidget *parent)
    : PlotView(tr("Temperature quantities and drift error over time"), look, parent)
{
    rebuild();
}

void TcqTimeView::setRun(std::shared_ptr<const RunFeatures> run)
{
    m_run = std::move(run);
    rebuild();
}

namespace {

// One panel: what is drawn in it, over the time of the run.
struct Strip
{
    QString title;
    Eigen::VectorXd values;
    QPen line;
    QColor fill;
};

} // namespace

static void drawStrip(QCPAxisRect &rect, const Strip &strip, const Eigen::VectorXd &timeS,
                      const TimeScale &scale)
{
    const auto trace =
        envelope(timeS, strip.values, timeS[0], timeS[timeS.size() - 1], kColumns, scale.secondsPerUnit);
    Extent extent;
    for (qsizetype i = 0; i < trace.key.size(); ++i) {
        extent.include(trace.low[i]);
        extent.include(trace.high[i]);
    }
    rect.axis(QCPAxis::atLeft)->setRange(extent.padded());
    rect.axis(QCPAxis::atLeft)->setLabel(strip.title);
    addRange(rect, trace.key, trace.low, trace.high, strip.fill);
    addLine(rect, trace.key, trace.mean, strip.line);
}

void TcqTimeView::build()
{
    if (!m_run || m_run->timeS.size() == 0) {
        showEmpty(tr("No run yet"), tr("Record a run, or open a log file."));
        return;
    }
    const QPen temperature(look().text, 1.0);
    addLegend(
        {{LegendEntry::Kind::Line, tr("Temperature quantity"), temperature, {}},
         {LegendEntry::Kind::Range, tr("TDE, mean and range"), rolePen(Role::Raw, look()), look().rawRange}});
    const Eigen::MatrixXd quantities = temperatureQuantities(FeatureSet::DeltaTSquaredRoot, m_run->deltaT);
    const std::array<QString, 3> names{tr("ΔT (°C)"), tr("ΔT² (°C²)"), tr("√ΔT (√°C)")};
    std::array<Strip, 6> strips;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        strips[2 * k] = {names[k], quantities.col(i), temperature, look().grid};
        const QString axis = QString::fromUtf8(kAxisNames[k].data());
        strips[2 * k + 1] = {tr("TDE, %1 (dps)").arg(axis), m_run->tdeDps.col(i), rolePen(Role::Raw, look()),
                             look().rawRange};
    }

    const Eigen::VectorXd sinceStart = m_run->timeS.array() - m_run->timeS[0];
    const TimeScale scale = timeScaleFor(sinceStart.maxCoeff());
    Extent time;
    time.include(0.0);
    time.include(sinceStart.maxCoeff() / scale.secondsPerUnit);
    QCPLayoutGrid &grid = addPanels();
    for (int i = 0; i < 6; ++i) {
        QCPAxisRect &rect = addPanel(grid, i / 2, i % 2);
        drawStrip(rect, strips[static_cast<std::size_t>(i)], sinceStart, scale);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        bottom.setRange(time.padded(0.0));
        applyTimeScale(bottom, scale, tr("Time since start"));
        if (i / 2 < 2)
            hideAxisText(bottom);
        auto *notes = new PanelNotes(&rect, look());
        notes->setMarginLabels({});
    }
    grid.setRowStretchFactor(2, kLastRowStretch);
}

} // namespace driftbench
