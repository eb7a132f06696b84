#include "app/gui/pages/plan_page.h"

#include "app/gui/event_log.h"
#include "app/gui/file_dialogs.h"
#include "app/gui/plan/control_panels.h"
#include "app/gui/plan/plan_form.h"
#include "app/gui/workbench.h"
#include "engine/base/atomic_file.h"
#include "engine/physics/chamber_transient.h"
#include "engine/physics/plan_file.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/duration_field.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"
#include "widgets/views/profile_view.h"
#include "widgets/views/transient_view.h"

#include <QEvent>
#include <QGridLayout>
#include <QMenu>
#include <QUndoCommand>
#include <QUndoStack>

namespace driftbench {

static constexpr int kFormWidth = 280;
static const QString kStillAir = QStringLiteral("stillAir");

// One step of the page's own undo: a whole plan before and after. Edits of one field that follow each other
// are one step.
class PlanEdit : public QUndoCommand
{
public:
    PlanEdit(PlanPage &page, const TestPlan &before, const TestPlan &after)
        : QUndoCommand(PlanPage::tr("edit of the plan")), m_page(page), m_before(before), m_after(after)
    {
    }
    void undo() override { m_page.show(m_before); }
    void redo() override { m_page.show(m_after); }

private:
    PlanPage &m_page;
    TestPlan m_before;
    TestPlan m_after;
};

static TestPlan firstPlan()
{
    return *makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
}

PlanPage::PlanPage(AppContext &context, QWidget *parent)
    : Page(context, parent), m_plan(firstPlan()), m_undo(new QUndoStack(this)), m_form(new PlanForm)
{
    buildActions();
    auto *body = new QWidget;
    auto *columns = new QHBoxLayout(body);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(kWideGap);
    m_form->setFixedWidth(kFormWidth);
    columns->addWidget(m_form);
    columns->addWidget(buildFigures(), 1);
    setBody(body);
    connect(m_form, &PlanForm::edited, this, [this] { edit(m_form->plan()); });
    connect(&banners(), &BannerSlot::dismissed, this,
            [this](const QString &) { m_dismissed = banners().banner().content().what; });
    Workbench &bench = *this->context().workbench;
    connect(&bench, &Workbench::sessionReplaced, this, [this] {
        m_undo->clear();
        takeSession();
    });
    connect(&bench, &Workbench::testPlanChanged, this, &PlanPage::takeSession);
    connect(&bench, &Workbench::sourceChanged, this, &PlanPage::takeSession);
    connect(&bench, &Workbench::runsChanged, this, &Page::stateChanged);
    takeSession();
}

PlanPage::~PlanPage() = default;

void PlanPage::buildActions()
{
    m_open = addPageAction({}, QStringLiteral("open"), [this] { askOpen(); });
    m_save = addPageAction({}, QStringLiteral("file"), [this] { askSave(); });
    m_steps = addPageAction({}, {}, [this] { askController(false); });
    m_ramps = addPageAction({}, {}, [this] { askController(true); });
    m_use = addPageAction(QKeySequence(Qt::CTRL | Qt::Key_Return), {}, [this] { use(); });
    m_use->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Return), QKeySequence(Qt::CTRL | Qt::Key_Enter)});
    m_files = new QAction(this);
    setActionIcon(*m_files, QStringLiteral("file"));
    auto *files = new ActionButton(m_files, ButtonSize::Head);
    auto *menu = new QMenu(files);
    menu->addActions({m_open, m_save});
    menu->addSeparator();
    menu->addActions({m_steps, m_ramps});
    files->setMenu(menu);
    head().addControl(files);
    auto *use = new ActionButton(m_use, ButtonSize::Head);
    use->setPrimary(true);
    head().addControl(use);
}

QWidget *PlanPage::buildFigures()
{
    auto *figures = new QWidget;
    auto *grid = new QGridLayout(figures);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kWideGap);
    grid->setVerticalSpacing(kGap);
    m_runHead = new SectionHead;
    m_intervalHead = new SectionHead;
    m_periodHead = new SectionHead;
    m_profile = new ProfileView(lookOf(palette()));
    m_profile->followTheme();
    m_interval = new IntervalPanel;
    m_period = new PeriodPanel;
    auto *profilePanel = new Panel;
    profilePanel->setFlush();
    profilePanel->rows()->addWidget(m_profile);
    grid->addWidget(m_runHead, 0, 0, 1, 2);
    grid->addWidget(profilePanel, 1, 0, 1, 2);
    grid->addWidget(m_intervalHead, 2, 0);
    grid->addWidget(m_periodHead, 2, 1);
    grid->addWidget(m_interval, 3, 0);
    grid->addWidget(m_period, 3, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    for (const int row : {1, 3}) {
        grid->setRowStretch(row, 1);
        grid->setRowMinimumHeight(row, 200);
    }
    for (QWidget *panel : {static_cast<QWidget *>(profilePanel), static_cast<QWidget *>(m_interval),
                           static_cast<QWidget *>(m_period)})
        panel->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    return figures;
}

StepState PlanPage::stepState() const
{
    const Session &session = context().workbench->session();
    if (const auto &plan = session.testPlan()) {
        return {tr("%1 to %2 °C").arg(numberText(plan->lowestC, 0), numberText(plan->highestC, 0)), true,
                StepMark::Done};
    }
    const auto &runs = session.runs();
    if (!runs.empty() && runs.front().state == RunState::Imported)
        return {tr("None, from a log"), false, StepMark::None};
    return {};
}

QString PlanPage::hints() const
{
    return tr("Tab next field · Up, Down change a value · Ctrl+Z undo · Ctrl+Enter record");
}

void PlanPage::retranslate()
{
    head().setTitle(stepName(Step::Plan));
    m_use->setProperty("shownShortcut",
                       QKeySequence(Qt::CTRL | Qt::Key_Enter).toString(QKeySequence::NativeText));
    m_use->setText(tr("Use this plan"));
    m_files->setText(tr("Plan file"));
    m_open->setText(tr("Open plan…"));
    m_save->setText(tr("Save plan…"));
    m_steps->setText(tr("Save steps for a chamber controller…"));
    m_ramps->setText(tr("Save ramps for a chamber controller…"));
    m_runHead->setTitle(tr("One run"));
    m_intervalHead->setTitle(tr("Control interval"));
    m_intervalHead->setNote(tr("Eqs. 13, 14, 26, 27"));
    m_periodHead->setTitle(tr("Control period"));
    m_periodHead->setNote(tr("Eqs. 25, 28, and the transient"));
    m_form->retranslate();
    showFigures();
}

void PlanPage::edit(const TestPlan &plan)
{
    m_undo->push(new PlanEdit(*this, m_plan, plan));
}

void PlanPage::show(const TestPlan &plan)
{
    m_plan = plan;
    m_form->setPlan(plan);
    showFigures();
}

void PlanPage::takeSession()
{
    const Workbench &bench = *context().workbench;
    if (const auto &plan = bench.session().testPlan())
        m_plan = *plan;
    else if (bench.sourceChoice() && bench.sourceChoice()->rateHz > 0.0)
        m_plan.sampleRateHz = bench.sourceChoice()->rateHz;
    m_form->setPlan(m_plan);
    showFigures();
    emit stateChanged();
}

void PlanPage::showFigures()
{
    const Status checked = checkTestPlan(m_plan);
    m_form->showError(checked);
    m_use->setEnabled(checked.ok() && !context().workbench->session().isReadOnly());
    for (QAction *action : {m_save, m_steps, m_ramps})
        action->setEnabled(checked.ok());
    m_use->setToolTip(checked ? QString() : QString::fromStdString(checked.error().message));
    m_interval->setPlan(m_plan);
    m_period->setPlan(m_plan);
    m_profile->setPlan(checked ? std::optional(m_plan) : std::nullopt);
    m_runHead->setNote({});
    if (checked) {
        const double allS = m_plan.runs * m_plan.runDurationS();
        QString note = tr("%1 a run, %2 samples at %3 Hz · %4 for %n runs", nullptr, m_plan.runs)
                           .arg(durationText(m_plan.runDurationS()),
                                numberText(static_cast<double>(m_plan.samplesPerRun()), 0),
                                numberText(m_plan.sampleRateHz, 0), durationText(allS));
        if (m_plan.kind == PlanKind::Heating)
            note += tr(", without cooling back");
        m_runHead->setNote(note);
    }
    showStillAir();
    const Workbench &bench = *context().workbench;
    head().setOrigin(bench.isSourceSimulated()   ? Origin::Simulated
                     : bench.isSourcePluggedIn() ? Origin::Device
                     : bench.sourceChoice()      ? Origin::Real
                                                 : Origin::None);
    head().setContext(tr("What the chamber does in each run, and for how long"));
}

static QString lengthText(double seconds)
{
    return seconds < 120.0    ? PlanPage::tr("%1 s").arg(numberText(seconds, 0))
           : seconds < 7200.0 ? PlanPage::tr("%1 min").arg(numberText(seconds / 60.0, 0))
                              : PlanPage::tr("%1 h").arg(numberText(seconds / 3600.0, 1));
}

void PlanPage::showStillAir()
{
    const auto transient = ChamberTransient::create(m_plan.chamber);
    const bool settles = transient && m_plan.stepC > m_plan.chamber.thermometerAccuracyC;
    const double settlingS =
        settles ? transient->settlingTimeS(m_plan.stepC, m_plan.chamber.thermometerAccuracyC) : 0.0;
    if (settlingS <= m_plan.periodS) {
        banners().withdraw(kStillAir);
        return;
    }
    const QString what = tr("A step of %1 is shorter than still air needs to settle: %2.")
                             .arg(lengthText(m_plan.periodS), lengthText(settlingS));
    if (what == m_dismissed)
        return;
    banners().post(kStillAir, {BannerKind::Caution,
                               what,
                               tr("Stir the air, or place the thermometer on the sensor."),
                               {},
                               {},
                               {},
                               true});
}

void PlanPage::use()
{
    const Status set = context().workbench->session().setTestPlan(m_plan);
    if (!set)
        return tell(set, {});
    context().navigator.go(Step::Record);
}

// What came of a file, in the event log; what failed, also as a banner.
void PlanPage::tell(const Status &outcome, const QString &what)
{
    if (outcome) {
        banners().withdraw(QStringLiteral("file"));
        if (!what.isEmpty())
            context().events.add(EventKind::Info, what);
        return;
    }
    const QString sentence = QString::fromStdString(outcome.error().message);
    context().events.add(EventKind::Bad, sentence);
    banners().post(QStringLiteral("file"), {BannerKind::Bad, sentence, {}, {}, {}, {}, true});
}

Status PlanPage::openPlan(const std::filesystem::path &file)
{
    const auto plan = readPlan(file);
    if (!plan)
        return plan.error();
    edit(*plan);
    return {};
}

Status PlanPage::savePlan(const std::filesystem::path &file) const
{
    return writePlan(m_plan, file);
}

Status PlanPage::saveControllerFile(const std::filesystem::path &file, bool ramps) const
{
    return writeFileAtomically(file, ramps ? planSegmentsToCsv(m_plan) : planStepsToCsv(m_plan));
}

void PlanPage::askOpen()
{
    askOpenFile(*this, *context().workbench, tr("Open plan"), tr("Plans (*.json)"),
                [this](const std::filesystem::path &file) {
                    tell(openPlan(file), tr("Plan read from %1.").arg(QString::fromStdString(file.string())));
                });
}

void PlanPage::askSave()
{
    askSaveFile(*this, *context().workbench, tr("Save plan"), tr("Plans (*.json)"),
                QStringLiteral("plan.json"), [this](const std::filesystem::path &file) {
                    tell(savePlan(file),
                         tr("Plan written to %1.").arg(QString::fromStdString(file.string())));
                });
}

void PlanPage::askController(bool ramps)
{
    const QString name = ramps ? QStringLiteral("ramps.csv") : QStringLiteral("steps.csv");
    askSaveFile(*this, *context().workbench, tr("Save controller file"), tr("Tables (*.csv)"), name,
                [this, ramps](const std::filesystem::path &file) {
                    tell(saveControllerFile(file, ramps),
                         tr("Controller file written to %1.").arg(QString::fromStdString(file.string())));
                });
}

} // namespace driftbench
