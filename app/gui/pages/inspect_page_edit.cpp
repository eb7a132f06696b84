// The part of InspectPage that selects and edits: every edit is one step of the session's history.
#include "app/gui/event_log.h"
#include "app/gui/inspect/inspect_side.h"
#include "app/gui/pages/inspect_page.h"
#include "app/gui/workbench.h"
#include "widgets/style/number_text.h"
#include "widgets/views/coverage_view.h"
#include "widgets/views/exclusion_strip.h"
#include "widgets/views/tcq_scatter_view.h"

#include <QItemSelectionModel>
#include <QTableView>

#include <algorithm>

namespace driftbench {

void InspectPage::select(Selection selection)
{
    m_selection = std::move(selection);
    if (!m_selection.empty())
        m_picked.reset();
    if (!m_seen)
        return;
    std::optional<StripRange> shown;
    if (m_selection.size() == 1) {
        const SelectedStretch &one = m_selection.front();
        const InspectedRun &run = m_seen->runs[one.run];
        shown = StripRange{run.toStrip(one.startS), run.toStrip(one.endS), true};
    }
    showScatter();
    showStrip();
    m_strip->setPicked(std::nullopt);
    m_strip->setSelection(shown);
    if (m_selection.empty())
        m_coverage->setSelection(std::nullopt);
    showButtons();
}

void InspectPage::pick(std::optional<std::size_t> stripRange)
{
    m_picked = stripRange ? std::optional(m_rangeRows[*stripRange]) : std::nullopt;
    m_strip->setPicked(stripRange);
    if (m_picked) {
        if (!m_selection.empty())
            select({});
        m_picked = m_rangeRows[*stripRange];
        m_strip->setPicked(stripRange);
        QTableView &table = m_side->table();
        if (table.currentIndex().row() != static_cast<int>(*m_picked))
            table.setCurrentIndex(table.model()->index(static_cast<int>(*m_picked), 0));
    }
    showButtons();
}

void InspectPage::excludeOrInclude()
{
    if (!m_seen)
        return;
    if (m_picked && m_seen->excluded[*m_picked].own) {
        const ExcludedStretch stretch = m_seen->excluded[*m_picked];
        include(stretch.run, *stretch.own);
    } else if (!m_selection.empty()) {
        exclude(m_selection);
    }
}

static double lengthOf(const Selection &selection)
{
    double seconds = 0.0;
    for (const SelectedStretch &stretch : selection)
        seconds += stretch.endS - stretch.startS;
    return seconds;
}

void InspectPage::exclude(const Selection &selection)
{
    CalibrationPlan plan = context().workbench->session().plan();
    for (const SelectedStretch &stretch : selection) {
        RunInPlan *run = plan.find(m_seen->runs[stretch.run].id);
        if (!run)
            continue;
        run->excluded.push_back({{stretch.startS, stretch.endS}, {}});
        std::sort(run->excluded.begin(), run->excluded.end(),
                  [](const Exclusion &a, const Exclusion &b) { return a.range.startS < b.range.startS; });
    }
    const QString seconds = numberText(lengthOf(selection), 0);
    const QString run = QString::fromStdString(m_seen->runs[selection.front().run].name);
    edit(plan,
         selection.size() == 1
             ? tr("exclude %1 s of %2").arg(seconds, run)
             : tr("exclude %1 s in %n stretches", nullptr, static_cast<int>(selection.size())).arg(seconds));
}

void InspectPage::include(std::size_t run, std::size_t own)
{
    CalibrationPlan plan = context().workbench->session().plan();
    RunInPlan *in = plan.find(m_seen->runs[run].id);
    if (!in || own >= in->excluded.size())
        return;
    in->excluded.erase(in->excluded.begin() + static_cast<std::ptrdiff_t>(own));
    edit(plan, tr("include a stretch of %1").arg(QString::fromStdString(m_seen->runs[run].name)));
}

void InspectPage::moveExclusion(std::size_t stripRange, double startS, double endS)
{
    if (!m_seen || stripRange >= m_rangeRows.size())
        return;
    const ExcludedStretch stretch = m_seen->excluded[m_rangeRows[stripRange]];
    const InspectedRun &run = m_seen->runs[stretch.run];
    CalibrationPlan plan = context().workbench->session().plan();
    RunInPlan *in = plan.find(run.id);
    if (!in || !stretch.own || *stretch.own >= in->excluded.size())
        return;
    TimeRange &range = in->excluded[*stretch.own].range;
    range.startS = std::clamp(run.toRun(startS), run.firstS, run.lastS);
    range.endS = std::clamp(run.toRun(endS), run.firstS, run.lastS);
    edit(plan, tr("move an excluded stretch of %1").arg(QString::fromStdString(run.name)));
}

void InspectPage::edit(const CalibrationPlan &plan, const QString &text)
{
    const Status edited = context().workbench->session().editPlan(plan, text);
    if (edited.ok())
        return;
    BannerContent content;
    content.kind = BannerKind::Bad;
    content.what = tr("The plan can't be changed.");
    content.toDo = QString::fromStdString(edited.error().message);
    banners().post(QStringLiteral("edit"), content);
}

} // namespace driftbench
