// The part of InspectPage that shows: from the session's runs to what stands in the plots.
#include "app/gui/event_log.h"
#include "app/gui/inspect/inspect_side.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/workbench.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/loading_state.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/legend_row.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"
#include "widgets/views/coverage_view.h"
#include "widgets/views/exclusion_strip.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QStackedWidget>

#include <cmath>

namespace driftbench {

void InspectPage::entered()
{
    m_failed = false;
    refresh();
}

void InspectPage::showEmptyTexts()
{
    if (m_failed)
        m_empty->setTexts(tr("The runs are not read"), tr("Come back to this page to read them again."));
    else
        m_empty->setTexts(tr("No runs yet"), tr("Record a run, or open a log file."));
}

void InspectPage::sayFailure(const Error &error)
{
    m_failed = true;
    if (!m_seen) {
        showEmptyTexts();
        m_states->setCurrentIndex(kEmpty);
    }
    if (error.code == Errc::Cancelled)
        return;
    BannerContent content;
    content.kind = BannerKind::Bad;
    content.what = tr("The runs can't be read.");
    content.toDo = QString::fromStdString(error.message);
    banners().post(QStringLiteral("reading"), content);
}

// Nothing is prepared for a page that nobody looks at, but for the rail's word on it.
void InspectPage::refresh()
{
    Workbench &workbench = *context().workbench;
    const Session &session = workbench.session();
    const bool runs = !session.runs().empty();
    if (!runs) {
        m_seen.reset();
        m_selection.clear();
        showEmptyTexts();
        m_states->setCurrentIndex(kEmpty);
        showHead();
        showBanner();
        showButtons();
        emit stateChanged();
        return;
    }
    if (!session.prepared()) {
        if (!isVisible() || m_failed || workbench.training().isRunning())
            return;
        const Status started = workbench.prepare();
        if (!started.ok())
            context().events.add(EventKind::Bad, QString::fromStdString(started.error().message));
        if (!m_seen && started.ok()) {
            m_loading->setProgress(tr("Reading the runs"), -1.0);
            m_states->setCurrentIndex(kLoading);
        }
        return;
    }
    if (!m_failed && (!m_seen || m_seen->prepared != session.prepared()))
        look();
}

void InspectPage::look()
{
    const Session &session = context().workbench->session();
    std::shared_ptr<const TrainedModel> model;
    if (const auto &result = session.result()) {
        if (const TrainedModel *rbf = result->model("rbf"))
            model = std::shared_ptr<const TrainedModel>(result, rbf);
    }
    const std::pair lookedAt(session.prepared().get(), model.get());
    if (m_job.isRunning()) {
        if (lookedAt != m_lookedAt) {
            m_lookPending = true;
            m_job.cancel();
        }
        return;
    }
    m_lookedAt = lookedAt;
    m_job.start(session.prepared(), model);
}

void InspectPage::take(const std::shared_ptr<const InspectionData> &seen)
{
    const bool again = std::exchange(m_lookPending, false);
    const auto &prepared = context().workbench->session().prepared();
    if (again && prepared)
        return look();
    if (prepared && (!seen || m_job.isCancelled()))
        return sayFailure({Errc::Cancelled, {}});
    if (!seen || seen->prepared != prepared)
        return; // of runs that are gone
    m_seen = seen;
    banners().withdraw(QStringLiteral("reading"));
    m_selection.clear();
    m_picked.reset();
    m_strip->setSelection(std::nullopt);
    m_strip->setPicked(std::nullopt);
    m_coverage->setSelection(std::nullopt);
    m_states->setCurrentIndex(kPlots);
    showAll();
}

void InspectPage::setAxis(int axis)
{
    if (m_axis == axis)
        return;
    m_axis = axis;
    showAll();
}

void InspectPage::showAll()
{
    m_side->showSeen(m_seen, m_axis);
    showHead();
    showBanner();
    showButtons();
    if (m_seen) {
        showScatter();
        showStrip();
        showOverTime();
    }
    emit stateChanged();
}

void InspectPage::showScatter()
{
    TcqScatterData shown;
    shown.axis = m_axis;
    for (const InspectedRun &run : m_seen->runs)
        shown.runs.push_back(run.dots);
    shown.referenceTemperatureC = m_seen->referenceTemperatureC;
    shown.density = m_seen->density;
    if (m_seen->curve && m_seen->inspection) {
        shown.curves = {*m_seen->curve};
        UncertaintyBand band;
        band.temperatureC = m_seen->inspection->spread.deltaT.array() + m_seen->referenceTemperatureC;
        band.curveHalfWidthDps = m_seen->inspection->spread.rmsDps;
        shown.band = std::move(band);
        shown.bandText = tr("Fitted curve, ±1 σ of its residuals");
    }
    std::tie(shown.heatingText, shown.coolingText) = directionTexts();
    shown.excludedDeltaT = m_seen->excludedDots.deltaT;
    shown.excludedTdeDps = m_seen->excludedDots.tdeDps;
    const SelectedDots selected = dotsIn(*m_seen, m_selection);
    shown.selectedDeltaT = selected.deltaT;
    shown.selectedTdeDps = selected.tdeDps;
    m_scatter->setData(std::move(shown));
    showLegend();
}

void InspectPage::addStripDots(StripData &strip) const
{
    for (const InspectedRun &run : m_seen->runs) {
        const auto heating = heatingFlags(run.dots->timeS, run.dots->deltaT);
        for (Eigen::Index i = 0; i < run.dots->timeS.size(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            StripDots &group = run.dots->usableForTraining[at] == 0 ? strip.excluded
                               : heating[at] != 0                   ? strip.heating
                                                                    : strip.cooling;
            group.timeS.append(run.toStrip(run.dots->timeS[i]));
            group.valueDps.append(run.dots->tdeDps(i, m_axis));
        }
    }
    const ExcludedDots &out = m_seen->excludedDots;
    for (Eigen::Index i = 0; i < out.timeS.size(); ++i) {
        strip.excluded.timeS.append(m_seen->runs[out.run[static_cast<std::size_t>(i)]].toStrip(out.timeS[i]));
        strip.excluded.valueDps.append(out.tdeDps(i, m_axis));
    }
    const SelectedDots selected = dotsIn(*m_seen, m_selection);
    for (std::size_t i = 0; i < selected.run.size(); ++i) {
        strip.selected.timeS.append(m_seen->runs[selected.run[i]].toStrip(selected.timeS[i]));
        strip.selected.valueDps.append(selected.tdeDps(static_cast<Eigen::Index>(i), m_axis));
    }
}

void InspectPage::addStripRanges(StripData &strip) const
{
    for (const std::size_t row : m_rangeRows) {
        const ExcludedStretch &stretch = m_seen->excluded[row];
        const InspectedRun &run = m_seen->runs[stretch.run];
        strip.ranges.push_back(
            {run.toStrip(stretch.startS), run.toStrip(stretch.endS), stretch.own.has_value()});
    }
}

void InspectPage::showStrip()
{
    m_rangeRows.clear();
    for (std::size_t row = 0; row < m_seen->excluded.size(); ++row) {
        if (!m_seen->excluded[row].everywhere)
            m_rangeRows.push_back(row);
    }
    StripData strip;
    strip.valueLabel = tr("TDE, %1 (dps)").arg(axisLetter(m_axis));
    strip.spanS = m_seen->stripSpanS;
    for (std::size_t r = 1; r < m_seen->runs.size(); ++r)
        strip.runStartsS.push_back(m_seen->runs[r].stripStartS);
    addStripDots(strip);
    addStripRanges(strip);
    m_strip->setData(std::move(strip));
    if (!m_seen->inspection) {
        m_coverage->setData({}, std::nullopt);
        return;
    }
    const auto &plan = context().workbench->session().testPlan();
    m_coverage->setData(m_seen->inspection->coverage,
                        plan ? std::optional(std::pair(plan->lowestC, plan->highestC)) : std::nullopt);
}

void InspectPage::showOverTime()
{
    m_time->setTraces(m_seen->overTime);
}

void InspectPage::showLegend()
{
    const PlotView &shown = m_overTime ? static_cast<const PlotView &>(*m_time) : *m_scatter;
    m_legend->setEntries(shown.legend(), lookOf(palette()));
}

} // namespace driftbench
