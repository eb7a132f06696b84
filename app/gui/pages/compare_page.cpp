#include "app/gui/pages/compare_page.h"

#include "app/gui/banner_of.h"
#include "app/gui/compare/report_writer.h"
#include "app/gui/event_log.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/loading_state.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"
#include "widgets/tables/comparison_table_model.h"
#include "widgets/tables/data_table.h"
#include "widgets/views/judged_run_view.h"
#include "widgets/views/plot_panel.h"
#include "widgets/views/verdict_card.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace driftbench {

static constexpr int kRunKeys = 9;
static constexpr int kCardHeight = 96;
static constexpr double kMostLimitDps = 1000.0;
static const char *const kReport = "report";

ComparePage::ComparePage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(stepIcon(Step::Compare)))
    , m_loading(new LoadingState)
    , m_runs(new SegmentedButtons({}, ButtonSize::Small))
    , m_manyRuns(new QComboBox)
    , m_plots(new JudgedRunView)
    , m_model(new ComparisonTableModel(this))
    , m_table(new DataTable(QString()))
    , m_reports(new ReportWriter(this))
{
    m_report = addPageAction(QKeySequence::Print, QStringLiteral("report"), [this] { askReport(); });
    m_cancel =
        addPageAction(QKeySequence(Qt::Key_Escape), QStringLiteral("stop"), [this] { cancelReport(); });
    m_toTrain =
        addPageAction({}, QStringLiteral("train"), [this] { this->context().navigator.go(Step::Train); });
    for (int run = 0; run < kRunKeys; ++run)
        m_runKeys.push_back(
            addPageAction(QKeySequence(Qt::Key_1 + run), {}, [this, run] { chooseRun(run); }));
    setPrimaryAction(m_report);
    buildHead();
    auto *emptyPanel = new Panel;
    emptyPanel->rows()->addWidget(m_empty);
    m_stack->addWidget(emptyPanel);
    m_stack->addWidget(buildBody());
    auto *loadingPanel = new Panel;
    loadingPanel->rows()->addWidget(m_loading);
    m_stack->addWidget(loadingPanel);
    setBody(m_stack);
    connect(&m_tracing, &TaskJob::finished, this, &ComparePage::tracesReady);
    connect(m_reports, &ReportWriter::finished, this, &ComparePage::reportEnded);
    connect(m_reports, &ReportWriter::progress, this, [this](const QString &, double fraction) {
        m_bar->setValue(static_cast<int>(1000.0 * fraction));
    });
    if (context.workbench != nullptr)
        connectSession();
}

ComparePage::~ComparePage() = default;

void ComparePage::buildHead()
{
    auto *limit = new QWidget;
    auto *row = new QHBoxLayout(limit);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kLabelGap);
    auto *label = new TextLabel(TextRole::Muted);
    label->setObjectName(QStringLiteral("limitLabel"));
    m_limit = new NumberField({}, tr("dps"), 3, kNoLimitDps, kMostLimitDps, 0.01);
    m_limit->setKeyboardTracking(false);
    m_limit->setFixedHeight(kHeadHeight);
    label->setBuddy(m_limit);
    row->addWidget(label);
    row->addWidget(m_limit);
    m_judging = new SegmentedButtons({}, ButtonSize::Head);
    m_reportButton = new ActionButton(m_report, ButtonSize::Head);
    m_bar = new QProgressBar;
    m_bar->setFixedSize(96, 8);
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_cancelButton = new ActionButton(m_cancel, ButtonSize::Head);
    m_bar->hide();
    m_cancelButton->hide();
    m_cancel->setEnabled(false);
    for (QWidget *control :
         std::initializer_list<QWidget *>{limit, m_judging, m_bar, m_cancelButton, m_reportButton})
        head().addControl(control);
    connect(m_limit, &QDoubleSpinBox::valueChanged, this, &ComparePage::setLimit);
    connect(m_judging, &SegmentedButtons::currentChanged, this, &ComparePage::judgeAgain);
}

QWidget *ComparePage::buildBody()
{
    auto *body = new QWidget;
    auto *rows = new QVBoxLayout(body);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    auto *cards = new QHBoxLayout;
    cards->setSpacing(kWideGap);
    for (VerdictCard *&card : m_cards) {
        card = new VerdictCard;
        card->setMinimumHeight(kCardHeight);
        cards->addWidget(card, 1);
    }
    rows->addLayout(cards);
    auto *plots = new PlotPanel(m_plots);
    plots->addBeforeLegend(m_runs);
    plots->addBeforeLegend(m_manyRuns);
    rows->addWidget(plots, 1);
    m_table->setTableModel(m_model);
    m_table->setSortable(true);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tablePanel = new Panel;
    m_tablePanel->setFlush();
    m_tablePanel->rows()->addWidget(m_table);
    rows->addWidget(m_tablePanel);
    connect(m_runs, &SegmentedButtons::currentChanged, this, &ComparePage::chooseRun);
    connect(m_manyRuns, &QComboBox::activated, this, &ComparePage::chooseRun);
    return body;
}

void ComparePage::connectSession()
{
    Workbench &bench = *context().workbench;
    connect(&bench, &Workbench::planChanged, this, &ComparePage::showPlan);
    connect(&bench, &Workbench::runsChanged, this, &ComparePage::showResult);
    connect(&bench, &Workbench::preparedChanged, this, &ComparePage::loadTraces);
    connect(&bench, &Workbench::resultChanged, this, &ComparePage::showResult);
    // Queued: the outcome comes right after it.
    connect(&bench.training(), &Job::runningChanged, this, &ComparePage::showState, Qt::QueuedConnection);
    connect(&bench.training(), &Job::progress, this,
            [this](const QString &stage, double fraction) { m_loading->setProgress(stage, fraction); });
    connect(m_loading, &LoadingState::cancelled, &bench.training(), &Job::cancel);
    showResult();
}

const CalibrationResult *ComparePage::result() const
{
    return context().workbench != nullptr ? context().workbench->session().result().get() : nullptr;
}

void ComparePage::entered()
{
    if (context().workbench == nullptr)
        return;
    const Session &session = context().workbench->session();
    if (session.result() && !session.prepared() && !context().workbench->training().isRunning()) {
        if (const Status started = context().workbench->prepare(); !started)
            emit context().workbench->problem(started.error());
    }
    loadTraces();
}

void ComparePage::editPlan(const QString &step, const std::function<void(CalibrationPlan &)> &change)
{
    Workbench &bench = *context().workbench;
    CalibrationPlan plan = bench.session().plan();
    change(plan);
    if (const Status edited = bench.session().editPlan(plan, step); !edited)
        emit bench.problem(edited.error());
}

void ComparePage::setLimit(double dps)
{
    editPlan(tr("limit"), [dps](CalibrationPlan &plan) {
        plan.limitRmsDps = dps > kNoLimitDps ? std::optional(dps) : std::nullopt;
    });
}

// What was judged one way is not known the other way: the models are trained anew, the same ones.
void ComparePage::judgeAgain(int choice)
{
    const Judging judging = choice == 0 ? Judging::Absolute : Judging::Anchored;
    Workbench &bench = *context().workbench;
    if (bench.session().plan().judging == judging)
        return;
    const bool had = bench.session().result() != nullptr;
    editPlan(tr("judging"), [judging](CalibrationPlan &plan) { plan.judging = judging; });
    if (!had)
        return;
    if (const Status started = bench.train(); !started)
        emit bench.problem(started.error());
}

void ComparePage::askReport()
{
    if (m_reports->isRunning() || result() == nullptr)
        return;
    auto *dialog = new QFileDialog(this, tr("Write the report"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("PDF (*.pdf)"), tr("HTML, one file (*.html)")});
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->selectFile(context().workbench->session().name() + QStringLiteral(".pdf"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString &filter) {
        dialog->setDefaultSuffix(filter.contains(QStringLiteral("*.html")) ? QStringLiteral("html")
                                                                           : QStringLiteral("pdf"));
    });
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString &file) { writeReport(std::filesystem::path(file.toStdString())); });
    dialog->open();
}

void ComparePage::writeReport(const std::filesystem::path &file)
{
    const Session &session = context().workbench->session();
    if (!session.result() || !session.prepared() || session.prepared()->refusal) {
        banners().post(QString::fromLatin1(kReport),
                       bannerOf(
                           BannerKind::Caution, [] { return tr("There is nothing to report yet."); },
                           [] { return tr("Train a model first; its runs must be readable."); }));
        return;
    }
    banners().withdraw(QString::fromLatin1(kReport));
    if (!m_reports->start(session.prepared(), session.result(), session.plan().limitRmsDps, file))
        return;
    m_bar->show();
    m_cancelButton->show();
    m_cancel->setEnabled(true);
    m_report->setEnabled(false);
    m_report->setProperty("file", QString::fromStdString(file.string()));
}

void ComparePage::cancelReport()
{
    m_cancel->setEnabled(false);
    m_reports->cancel();
}

void ComparePage::reportEnded(const Status &outcome)
{
    m_bar->hide();
    m_cancelButton->hide();
    m_cancel->setEnabled(false);
    m_report->setEnabled(result() != nullptr);
    if (outcome) {
        const QString file = m_report->property("file").toString();
        context().events.add(EventKind::Info, tr("Report written to %1.").arg(file));
        banners().post(QString::fromLatin1(kReport),
                       bannerOf(
                           BannerKind::Info, [] { return tr("The report is written."); }, file));
        return;
    }
    if (outcome.error().code == Errc::Cancelled) {
        banners().post(QString::fromLatin1(kReport),
                       bannerOf(BannerKind::Info, [] { return tr("The report was cancelled."); }, {}));
        return;
    }
    banners().post(QString::fromLatin1(kReport),
                   bannerOf(
                       BannerKind::Bad, [] { return tr("The report was not written."); },
                       QString::fromStdString(outcome.error().message)));
}

void ComparePage::chooseRun(int run)
{
    const CalibrationResult *found = result();
    if (found == nullptr || run < 0 || run >= static_cast<int>(found->heldOut.size()))
        return;
    m_run = run;
    m_runs->setCurrent(run);
    m_manyRuns->setCurrentIndex(run);
    showTable();
    loadTraces();
}

StepState ComparePage::stepState() const
{
    if (result() == nullptr)
        return {};
    const auto yes = std::count(m_verdicts.begin(), m_verdicts.end(), Verdict::Yes);
    const auto no = std::count(m_verdicts.begin(), m_verdicts.end(), Verdict::NotRepeatable);
    return {tr("%1 of 3 axes: yes").arg(yes), true, no > 0 ? StepMark::Warning : StepMark::Done};
}

QString ComparePage::hints() const
{
    return tr("1, 2, 3 choose the held-out run · Wheel zoom · Drag pan · Double-click fit · Ctrl+E export "
              "what is visible");
}

std::vector<StatusPart> ComparePage::statusParts() const
{
    if (result() == nullptr)
        return {};
    const auto runs = static_cast<int>(result()->heldOut.size());
    return {{tr("%n held-out run(s)", nullptr, runs)},
            {result()->figures.judging == "anchored" ? tr("Judged: anchored") : tr("Judged: absolute")}};
}

void ComparePage::retranslate()
{
    head().setTitle(stepName(Step::Compare));
    findChild<TextLabel *>(QStringLiteral("limitLabel"))->setText(tr("Limit"));
    m_limit->setSpecialValueText(tr("none"));
    m_limit->setToolTip(tr("What may be left on a held-out run, rms. Zero: no limit."));
    m_judging->setTexts({tr("Absolute"), tr("Anchored")});
    m_report->setText(tr("Report…"));
    m_report->setToolTip(tr("Everything found as PDF or as one HTML file"));
    m_cancel->setText(tr("Cancel"));
    m_toTrain->setText(tr("Train"));
    m_manyRuns->setAccessibleName(tr("Held-out run"));
    m_runs->setAccessibleName(tr("Held-out run"));
    m_table->setAccessibleName(tr("Comparison of the models on the held-out run"));
    m_limit->setAccessibleName(tr("Limit of what may be left, rms"));
    m_judging->setAccessibleName(tr("Judging"));
    m_bar->setAccessibleName(tr("Progress of the report"));
    m_empty->setActions({m_toTrain});
    for (std::size_t run = 0; run < m_runKeys.size(); ++run)
        m_runKeys[run]->setText(tr("Held-out run %1").arg(run + 1));
    showState();
    if (context().workbench != nullptr)
        showPlan();
}

} // namespace driftbench
