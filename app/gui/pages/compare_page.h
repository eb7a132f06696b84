// Compare: may this drift be compensated? One verdict an axis, each held-out run before and after the model
// that has not seen it, and the table in the paper's order.
#pragma once

#include "app/gui/page.h"
#include "app/session/job.h"
#include "app/session/prepared_campaign.h"
#include "engine/evaluation/judged_traces.h"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>

class QComboBox;
class QProgressBar;
class QStackedWidget;

namespace driftbench {

class ActionButton;
class ComparisonTableModel;
class DataTable;
class EmptyState;
class JudgedRunView;
class LoadingState;
class NumberField;
class Panel;
class ReportWriter;
class SegmentedButtons;
class VerdictCard;

class ComparePage : public Page
{
    Q_OBJECT

public:
    explicit ComparePage(AppContext &context, QWidget *parent = nullptr);
    ~ComparePage() override;

    StepState stepState() const override;
    QString hints() const override;
    std::vector<StatusPart> statusParts() const override;
    void entered() override;

    void writeReport(const std::filesystem::path &file); // .pdf or .html
    void chooseRun(int run);
    int run() const { return m_run; }
    void setLimit(double dps); // 0: none

    VerdictCard &card(int axis) const { return *m_cards[static_cast<std::size_t>(axis)]; }
    JudgedRunView &plots() const { return *m_plots; }
    DataTable &table() const { return *m_table; }
    ReportWriter &reports() const { return *m_reports; }

protected:
    void retranslate() override;

private:
    static constexpr double kNoLimitDps = 0.0; // as the field shows it

    void buildHead();
    QWidget *buildBody();
    void connectSession();
    void editPlan(const QString &step, const std::function<void(CalibrationPlan &)> &change);
    void judgeAgain(int choice);
    void cancelReport();
    void askReport();
    void reportEnded(const Status &outcome);
    void showResult();
    void showPlan();
    void showCards();
    void showRunChoice();
    void showTable();
    void loadTraces();
    void tracesReady(const Status &outcome);
    void showState(); // the comparison, that it is being made, or that there is none
    QString runTitle() const;
    const CalibrationResult *result() const;

    QStackedWidget *m_stack;
    EmptyState *m_empty;
    LoadingState *m_loading;
    NumberField *m_limit;
    SegmentedButtons *m_judging;
    QAction *m_report, *m_cancel, *m_toTrain;
    ActionButton *m_reportButton, *m_cancelButton;
    QProgressBar *m_bar;
    std::array<VerdictCard *, 3> m_cards;
    SegmentedButtons *m_runs;
    QComboBox *m_manyRuns;
    JudgedRunView *m_plots;
    ComparisonTableModel *m_model;
    DataTable *m_table;
    Panel *m_tablePanel;
    std::vector<QAction *> m_runKeys;
    ReportWriter *m_reports;

    TaskJob m_tracing;
    std::shared_ptr<JudgedTraces> m_traces;
    std::shared_ptr<JudgedTraces> m_pending; // being made
    bool m_traceAgain = false;               // another run was chosen meanwhile
    int m_run = 0;
    std::array<Verdict, 3> m_verdicts{};
};

} // namespace driftbench
