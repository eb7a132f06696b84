#include "app/gui/pages/compare_page.h"

#include "app/gui/app_context.h"
#include "app/gui/compare/report_writer.h"
#include "app/gui/page_head.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "engine/evaluation/axis_finding.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/loading_state.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/style/role_pens.h"
#include "widgets/tables/comparison_table_model.h"
#include "widgets/tables/data_table.h"
#include "widgets/views/judged_run_view.h"
#include "widgets/views/verdict_card.h"

#include <QAction>
#include <QComboBox>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace driftbench {

static constexpr int kMostRunButtons = 6;
static constexpr int kEmpty = 0, kComparison = 1, kLoading = 2; // pages, as the constructor adds them

void ComparePage::showResult()
{
    const CalibrationResult *found = result();
    m_report->setEnabled(found != nullptr && !m_reports->isRunning());
    head().setOrigin(found == nullptr           ? Origin::None
                     : found->figures.simulated ? Origin::Simulated
                                                : Origin::Real);
    showState();
    if (found != nullptr) {
        m_run = std::clamp(m_run, 0, std::max(0, static_cast<int>(found->heldOut.size()) - 1));
        showRunChoice();
    }
    showPlan();
    loadTraces();
}

void ComparePage::showPlan()
{
    const CalibrationPlan &plan = context().workbench->session().plan();
    {
        const QSignalBlocker quiet(m_limit);
        m_limit->setValue(plan.limitRmsDps.value_or(kNoLimitDps));
    }
    m_judging->setCurrent(plan.judging == Judging::Absolute ? 0 : 1);
    const CalibrationResult *found = result();
    const std::string model = found != nullptr ? mainModelName(*found) : std::string();
    head().setContext(model.empty()
                          ? tr("Models against a constant, on runs they have not seen")
                          : tr("%1 against a constant, on runs it has not seen").arg(shortModelLabel(model)));
    showCards();
    showTable();
    m_plots->setOrigin(context().workbench->session().isSimulated() ? OriginChip::words(Origin::Simulated)
                                                                    : QString());
    if (m_traces)
        m_plots->setData({m_traces, plan.limitRmsDps});
    emit stateChanged();
}

void ComparePage::showCards()
{
    const CalibrationResult *found = result();
    if (found == nullptr)
        return;
    const std::string fallback = mainModelName(*found);
    const auto &limit = context().workbench->session().plan().limitRmsDps;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const AxisVerdict &judged = found->figures.verdicts[a];
        const AxisFinding finding =
            findAxis(found->figures.rows, axis, judgedModel(judged, fallback), judged.verdict, limit);
        m_verdicts[a] = finding.verdict;
        m_cards[a]->setFinding(finding, found->figures.hysteresis.rmsDps[axis],
                               QString::fromStdString(judged.reason));
    }
}

void ComparePage::showRunChoice()
{
    QStringList names;
    for (const HeldOutModels &fold : result()->heldOut)
        names.append(QString::fromStdString(fold.fold));
    const bool many = names.size() > kMostRunButtons;
    m_runs->setVisible(!many);
    m_manyRuns->setVisible(many);
    m_runs->setTexts(many ? QStringList() : names);
    m_runs->setCurrent(m_run);
    const QSignalBlocker quiet(m_manyRuns);
    m_manyRuns->clear();
    m_manyRuns->addItems(names);
    m_manyRuns->setCurrentIndex(m_run);
}

QString ComparePage::runTitle() const
{
    const CalibrationResult *found = result();
    if (found == nullptr || m_run >= static_cast<int>(found->heldOut.size()))
        return {};
    return QString::fromStdString(found->heldOut[static_cast<std::size_t>(m_run)].fold);
}

void ComparePage::showTable()
{
    const CalibrationResult *found = result();
    if (found == nullptr)
        return;
    const std::string name = mainModelName(*found);
    m_model->setData({found->figures.rows, name.empty() ? "rbf" : name, runTitle().toStdString(),
                      context().workbench->session().plan().limitRmsDps, runTitle()});
    m_tablePanel->setFixedHeight(m_table->heightOfRows(std::max(3, m_model->rowCount())) + 2);
}

// Off this thread: a prediction for every sample of the run, and two Allan deviations.
void ComparePage::loadTraces()
{
    const Session &session = context().workbench->session();
    const auto found = session.result();
    const auto prepared = session.prepared();
    if (!found || !prepared || prepared->refusal) {
        m_traces.reset();
        m_plots->setData({nullptr, std::nullopt});
        return;
    }
    if (m_tracing.isRunning()) {
        m_traceAgain = true;
        return;
    }
    const std::string fold = runTitle().toStdString();
    const auto traces = std::make_shared<JudgedTraces>();
    m_tracing.start([target = traces, found, prepared, fold](const ProgressHook &) -> Status {
        const TrainedModel *model = found->heldOutModel(fold, mainModelName(*found));
        for (const auto &run : prepared->loaded.features.runs) {
            if (run->name == fold && model != nullptr)
                *target =
                    judgedTraces(run, *model, found->heldOutModel(fold, "constant"), prepared->plan.judging);
        }
        return {};
    });
    m_pending = traces;
}

void ComparePage::tracesReady(const Status &)
{
    m_traces = std::exchange(m_pending, nullptr);
    if (std::exchange(m_traceAgain, false))
        return loadTraces();
    m_plots->setData({m_traces, context().workbench->session().plan().limitRmsDps});
}

void ComparePage::showState()
{
    m_empty->setTexts(tr("Nothing to judge"), tr("Train a model first."));
    const bool judging = context().workbench != nullptr && context().workbench->training().isRunning();
    const int shown = result() != nullptr ? kComparison : judging ? kLoading : kEmpty;
    if (shown == kLoading && m_stack->currentIndex() != kLoading)
        m_loading->setProgress(tr("The models are trained and judged on runs held out."), -1.0);
    m_stack->setCurrentIndex(shown);
    m_cancel->setEnabled(m_reports->isRunning() && shown != kLoading); // which has Esc for itself
}

} // namespace driftbench
