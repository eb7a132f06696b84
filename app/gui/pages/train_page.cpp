#include "app/gui/pages/train_page.h"

#include "app/gui/banner_of.h"
#include "app/gui/train/model_words.h"
#include "app/gui/train/train_figures.h"
#include "app/gui/train/train_options.h"
#include "app/gui/workbench.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/panel.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"
#include "widgets/tables/data_table.h"
#include "widgets/tables/models_table_model.h"
#include "widgets/views/centres_view.h"
#include "widgets/views/plot_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace driftbench {

static constexpr int kBarWidth = 160;
static constexpr int kBarHeight = 8;
static const QString kRefused = QStringLiteral("refused");

TrainPage::TrainPage(AppContext &context, QWidget *parent)
    : Page(context, parent)
    , m_options(new TrainOptions)
    , m_stack(new QStackedWidget)
    , m_empty(new EmptyState(stepIcon(Step::Train)))
    , m_losses(new CentresView(lightPalette(), nullptr, CentresView::Part::Losses))
    , m_curves(new CentresView(lightPalette(), nullptr, CentresView::Part::Curves))
    , m_table(new DataTable(QString()))
    , m_models(new ModelsTableModel(this))
{
    m_train = addPageAction(QKeySequence(Qt::CTRL | Qt::Key_R), QStringLiteral("play"), [this] { train(); });
    m_cancel = addPageAction(QKeySequence(Qt::Key_Escape), QStringLiteral("stop"), [this] { cancel(); });
    m_toInspect =
        addPageAction({}, QStringLiteral("inspect"), [this] { this->context().navigator.go(Step::Inspect); });
    setPrimaryAction(m_train);
    buildHead();
    auto *body = new QWidget;
    auto *columns = new QHBoxLayout(body);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    columns->addWidget(m_options);
    columns->addWidget(m_stack, 1);
    auto *emptyPanel = new Panel;
    emptyPanel->rows()->addWidget(m_empty);
    m_stack->addWidget(emptyPanel);
    m_stack->addWidget(buildResults());
    setBody(body);
    connect(m_options, &TrainOptions::edited, this, [this](const CalibrationPlan &plan, const QString &step) {
        if (const Status edited = this->context().workbench->session().editPlan(plan, step); !edited)
            emit this->context().workbench->problem(edited.error());
    });
    connect(m_losses, &CentresView::countPicked, this, &TrainPage::takeCentres);
    if (context.workbench != nullptr)
        connectSession();
}

TrainPage::~TrainPage() = default;

void TrainPage::buildHead()
{
    m_stage = new TextLabel(TextRole::Note);
    m_bar = new QProgressBar;
    m_bar->setFixedSize(kBarWidth, kBarHeight);
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_percent = new TextLabel(TextRole::StrongNote);
    auto *train = new ActionButton(m_train, ButtonSize::Head);
    train->setPrimary(true);
    auto *cancel = new ActionButton(m_cancel, ButtonSize::Head);
    for (QWidget *control : std::initializer_list<QWidget *>{m_stage, m_bar, m_percent, cancel, train})
        head().addControl(control);
}

QWidget *TrainPage::buildResults()
{
    auto *results = new QWidget;
    auto *rows = new QVBoxLayout(results);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    auto *splitter = new QSplitter(Qt::Vertical);
    splitter->setObjectName(QStringLiteral("trainSplitter"));
    splitter->setHandleWidth(kGap);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(new PlotPanel(m_losses));
    splitter->addWidget(new PlotPanel(m_curves));
    rows->addWidget(splitter, 1);
    m_losses->enablePicking();
    m_models->setLook(lookOf(palette()));
    m_table->setTableModel(m_models);
    m_table->setStretchColumn(0);
    m_table->setKeptInView(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tablePanel = new Panel;
    m_tablePanel->setFlush();
    m_tablePanel->rows()->addWidget(m_table);
    rows->addWidget(m_tablePanel);
    return results;
}

void TrainPage::connectSession()
{
    Workbench &bench = *context().workbench;
    connect(&bench, &Workbench::sessionReplaced, this, [this] {
        m_shown.reset();
        m_shownCampaign.reset();
        m_stopped = false;
        banners().withdraw(kRefused);
    });
    connect(&bench, &Workbench::runsChanged, this, &TrainPage::showPlan);
    connect(&bench, &Workbench::planChanged, this, &TrainPage::showPlan);
    connect(&bench, &Workbench::preparedChanged, this, &TrainPage::showRefusal);
    connect(&bench, &Workbench::resultChanged, this, &TrainPage::showResult);
    TrainingJob &job = bench.training();
    connect(&job, &TrainingJob::runningChanged, this, &TrainPage::runningChanged);
    connect(&job, &TrainingJob::progress, this, &TrainPage::showJob);
    connect(&job, &TrainingJob::modelTrained, this, [this](const QString &name, double seconds) {
        m_trainedS[name.toStdString()] = seconds;
        showTable();
    });
    connect(&job, &TrainingJob::trained, this,
            [this](const Result<std::shared_ptr<const CalibrationResult>> &outcome) {
                if (outcome || outcome.error().code == Errc::Cancelled)
                    return;
                banners().post(kRefused,
                               bannerOf(BannerKind::Bad, [] { return tr("The training was refused."); },
                                        QString::fromStdString(outcome.error().message), {m_toInspect}));
            });
    showPlan();
    showResult();
    runningChanged(job.isRunning());
}

void TrainPage::entered()
{
    if (context().workbench == nullptr)
        return;
    showPlan();
    showResult();
}

bool TrainPage::isOutdated() const
{
    return m_shown && context().workbench->session().result() != m_shown;
}

void TrainPage::train()
{
    banners().withdraw(kRefused);
    m_trainedS.clear();
    m_stopped = false;
    if (const Status started = context().workbench->train(); !started)
        banners().post(kRefused, bannerOf(
                                     BannerKind::Bad, [] { return tr("The training can't start."); },
                                     QString::fromStdString(started.error().message)));
}

void TrainPage::cancel()
{
    TrainingJob &job = context().workbench->training();
    if (!job.isRunning())
        return;
    m_stopped = true;
    job.cancel();
    m_cancel->setEnabled(false);
}

// One step that can be undone; the training follows at once, as the click asks for its curve.
void TrainPage::takeCentres(int centres)
{
    Workbench &bench = *context().workbench;
    if (bench.training().isRunning())
        return;
    CalibrationPlan plan = bench.session().plan();
    plan.rbf.centres = centres;
    if (const Status edited = bench.session().editPlan(plan, tr("take %n centres", nullptr, centres));
        !edited) {
        emit bench.problem(edited.error());
        return;
    }
    train();
}

void TrainPage::runningChanged(bool running)
{
    m_stage->setVisible(running);
    m_bar->setVisible(running);
    m_percent->setVisible(running);
    m_cancel->setVisible(running);
    m_train->setVisible(!running);
    m_cancel->setEnabled(running);
    m_options->setEnabled(!running);
    showJob();
    showTable();
    showPlan();
}

void TrainPage::showJob()
{
    const TrainingJob &job = context().workbench->training();
    if (job.isRunning()) {
        m_stage->setText(job.stage());
        m_bar->setValue(static_cast<int>(1000.0 * job.fraction()));
        m_percent->setText(tr("%1 %").arg(numberText(100.0 * job.fraction(), 0)));
        showTable();
    }
    emit stateChanged();
}

void TrainPage::showPlan()
{
    Workbench &bench = *context().workbench;
    const Session &session = bench.session();
    m_options->show(session.plan(), session.runs());
    const bool runs = !session.runs().empty();
    m_train->setEnabled(runs && !bench.training().isRunning() && !session.isReadOnly());
    m_stack->setCurrentIndex(m_shown || bench.training().isRunning() ? 1 : 0);
    setEmptyTexts();
    head().setOrigin(!runs ? Origin::None : session.isSimulated() ? Origin::Simulated : Origin::Real);
    showContext();
    showTable();
    emit stateChanged();
}

void TrainPage::showContext()
{
    const Session &session = context().workbench->session();
    if (context().workbench->training().isRunning())
        head().setContext(tr("Each run is held out once."));
    else if (isOutdated())
        head().setContext(tr("Shown is what was trained before the last change. Train again."));
    else if (session.runs().size() == 1)
        head().setContext(
            tr("Blocks of temperature are held out: one run can't show that another repeats it."));
    else
        head().setContext(tr("Each run is held out once. Held-out error counts, training error does not."));
    m_train->setText(m_shown ? tr("Train again") : tr("Train"));
}

void TrainPage::setEmptyTexts()
{
    if (context().workbench->session().runs().empty())
        m_empty->setTexts(tr("Nothing to train on"), tr("Record a run, or open a log file."));
    else
        m_empty->setTexts(tr("Not trained yet"), tr("Choose the models at the left and train them."));
}

void TrainPage::showRefusal()
{
    const auto &prepared = context().workbench->session().prepared();
    if (prepared && prepared->refusal)
        banners().post(kRefused,
                       bannerOf(BannerKind::Bad, [] { return tr("These runs can't be trained on."); },
                                QString::fromStdString(prepared->refusal->message), {m_toInspect}));
    else
        banners().withdraw(kRefused);
    showResult();
}

void TrainPage::showResult()
{
    const Session &session = context().workbench->session();
    if (session.result() && session.prepared() && !session.prepared()->refusal) {
        const bool fresh = m_shown != session.result() || m_shownCampaign != session.prepared();
        m_shown = session.result();
        m_shownCampaign = session.prepared();
        if (fresh)
            showFigures();
    } else if (session.result() && !session.prepared() && isVisible()) {
        // A session from a file has the figures; the plots need its runs.
        if (!context().workbench->training().isRunning())
            (void)context().workbench->prepare().ok();
    } else if (session.runs().empty()) {
        m_shown.reset();
        m_shownCampaign.reset();
    }
    showPlan();
}

void TrainPage::showFigures()
{
    const CentresData shown = centresData(*m_shownCampaign, *m_shown);
    const QString origin = m_shown->figures.simulated ? OriginChip::words(Origin::Simulated) : QString();
    for (CentresView *view : {m_losses, m_curves}) {
        view->setData(shown);
        view->setOrigin(origin);
    }
    m_options->setNote(shown.selection
                           ? tr("Centres: the fewest that do as well as the best on runs left out. Here %1.")
                                 .arg(centresText(shown.selection->chosen))
                           : QString());
}

void TrainPage::showTable()
{
    const Workbench &bench = *context().workbench;
    const TrainingJob &job = context().workbench->training();
    const TrainingProgress progress{job.isRunning(), job.fraction(), m_trainedS};
    const CalibrationPlan &plan =
        isOutdated() && !job.isRunning() && m_shownCampaign ? m_shownCampaign->plan : bench.session().plan();
    m_models->setData(modelsData(plan, m_shown.get(), progress, m_stopped));
    m_tablePanel->setFixedHeight(m_table->heightOfRows(m_models->rowCount()) + 2);
}

StepState TrainPage::stepState() const
{
    if (context().workbench == nullptr)
        return {};
    const TrainingJob &job = context().workbench->training();
    if (job.isRunning())
        return {tr("Training, %1 %").arg(numberText(100.0 * job.fraction(), 0)), true, StepMark::Working};
    const auto &result = context().workbench->session().result();
    if (!result)
        return {isOutdated() ? tr("Changed, train again") : QString(), isOutdated(), StepMark::None};
    const auto models = static_cast<int>(result->models.size()) - (result->model("auto") != nullptr ? 1 : 0);
    return {tr("%n model(s)", nullptr, models), true, StepMark::Done};
}

QString TrainPage::hints() const
{
    if (context().workbench != nullptr && context().workbench->training().isRunning())
        return tr("Esc cancel. What is finished is kept.");
    return tr("Ctrl+R train · Click the curve of the excess to take that number of centres · F fit");
}

std::vector<StatusPart> TrainPage::statusParts() const
{
    if (!m_shownCampaign)
        return {};
    std::int64_t samples = 0;
    for (const auto &run : m_shownCampaign->loaded.features.runs)
        samples += run->samples();
    const auto runs = static_cast<int>(m_shownCampaign->loaded.features.runs.size());
    return {{tr("%n run(s), %1 samples", nullptr, runs).arg(numberText(static_cast<double>(samples), 0))}};
}

void TrainPage::retranslate()
{
    head().setTitle(stepName(Step::Train));
    m_cancel->setText(tr("Cancel"));
    m_table->setAccessibleName(tr("Models"));
    m_bar->setAccessibleName(tr("Progress of the training"));
    m_toInspect->setText(tr("Look at the runs"));
    m_train->setToolTip(tr("Train the chosen models and judge them on runs held out"));
    m_options->retranslate();
    if (context().workbench != nullptr) {
        showContext();
        setEmptyTexts();
        showTable();
        if (m_shown && m_shownCampaign)
            showFigures();
    }
}

void TrainPage::changeEvent(QEvent *event)
{
    Page::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_models->setLook(lookOf(palette()));
}

} // namespace driftbench
