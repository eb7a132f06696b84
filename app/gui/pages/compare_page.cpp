#include "app/gui/pages/compare_page.h"

#include "app/gui/banner_of.h"
#include "app/gui/compare/report_writer.h"
#include "app/gui/event_log.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "engine/evaluation/axis_finding.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/empty_state.h"
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
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace driftbench {

static constexpr int kMostRunButtons = 6;
static constexpr int kRunKeys = 9;
static constexpr int kCardHeight = 96;
static constexpr double kMostLimitDps = 1000.0;
static constexpr double kNoLimitDps = 0.0;
static const char *const kReport = "report";

ComparePage::ComparePage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(stepIcon(Step::Compare)))
    , m_runs(new SegmentedButtons({}, ButtonSize::Small))
    , m_manyRuns(new QComboBox)
    , m_plots(new JudgedRunView)
    , m_model(new ComparisonTableModel(this))
    , m_table(new DataTable(QString()))
    , m_reports(new ReportWriter(this))
{
    m_report = addPageAction(QKeySequence::Print, QStringLiteral("report"), [this] { askReport(); });
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
    m_bar->hide();
    for (QWidget *control : std::initializer_list<QWidget *>{limit, m_judging, m_bar, m_reportButton})
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
    m_report->setEnabled(false);
    m_report->setProperty("file", QString::fromStdString(file.string()));
}

void ComparePage::reportEnded(const Status &outcome)
{
    m_bar->hide();
    m_report->setEnabled(result() != nullptr);
    if (outcome) {
        const QString file = m_report->property("file").toString();
        context().events.add(EventKind::Info, tr("Report written to %1.").arg(file));
        banners().post(QString::fromLatin1(kReport),
                       bannerOf(
                           BannerKind::Info, [] { return tr("The report is written."); }, file));
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

void ComparePage::showResult()
{
    const CalibrationResult *found = result();
    m_stack->setCurrentIndex(found != nullptr ? 1 : 0);
    m_report->setEnabled(found != nullptr && !m_reports->isRunning());
    head().setOrigin(found == nullptr           ? Origin::None
                     : found->figures.simulated ? Origin::Simulated
                                                : Origin::Real);
    setEmptyTexts();
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

void ComparePage::setEmptyTexts()
{
    if (context().workbench != nullptr && context().workbench->training().isRunning())
        m_empty->setTexts(tr("Being judged"), tr("The models are trained and judged on runs held out."));
    else
        m_empty->setTexts(tr("Nothing to judge"), tr("Train a model first."));
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
    setEmptyTexts();
    if (context().workbench != nullptr)
        showPlan();
}

} // namespace driftbench
