#include "app/gui/start/simulated_tour.h"

#include "app/gui/export/device_panel.h"
#include "app/gui/main_window.h"
#include "app/gui/pages/export_page.h"
#include "app/gui/pages/plan_page.h"
#include "app/gui/pages/record_page.h"
#include "app/gui/pages/source_page.h"
#include "app/gui/record/live_run.h"
#include "app/gui/source/source_form.h"
#include "app/gui/workbench.h"

#include <QAction>
#include <QCoreApplication>

#include <algorithm>
#include <memory>

namespace driftbench {

static constexpr double kTourSpeed = 1000.0;

static QString tourText(const char *english)
{
    return QCoreApplication::translate("SimulatedTour", english);
}

static int finishedRuns(const Session &session)
{
    return static_cast<int>(
        std::count_if(session.runs().begin(), session.runs().end(),
                      [](const RunRecord &run) { return run.state == RunState::Complete; }));
}

// Of work that is done at once or not at all.
static QString seeThePage()
{
    return tourText(
        QT_TRANSLATE_NOOP("SimulatedTour", "That did not work; the page says why. Try again, or skip it."));
}

static QString sourceMissing(const Workbench &bench)
{
    return bench.sourceChoice()
               ? QString()
               : tourText(QT_TRANSLATE_NOOP(
                     "SimulatedTour", "No bridge is chosen; choose the simulated one on the Source page."));
}

static TourStep connectStep(MainWindow &window, Workbench &bench)
{
    TourStep step{Step::Source};
    step.what = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Choose where the samples come from."));
    };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour",
                                          "The simulated bridge runs the firmware of a real one over a "
                                          "simulated gyro in a chamber. Next uses it."));
    };
    step.perform = [&window] {
        auto &page = static_cast<SourcePage &>(*window.page(Step::Source));
        SourceChoice choice = page.form().simulated().choice();
        choice.as<SimulatedChoice>()->speed = kTourSpeed;
        page.form().simulated().setChoice(choice);
        page.chooseSimulated();
        page.use();
    };
    step.isDone = [&bench] { return bench.session().source().has_value(); };
    step.trouble = seeThePage;
    return step;
}

static TourStep planStep(MainWindow &window, Workbench &bench)
{
    TourStep step{Step::Plan};
    step.what = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Plan how the temperature moves."));
    };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP(
            "SimulatedTour",
            "From −40 to 85 °C in steps that the datasheets allow. The tour takes three runs "
            "instead of five; each is judged by a model of the others."));
    };
    step.perform = [&window] {
        auto &page = static_cast<PlanPage &>(*window.page(Step::Plan));
        TestPlan plan = page.plan();
        plan.runs = kTourRuns;
        page.edit(plan);
        page.use();
    };
    step.isDone = [&bench] { return bench.session().testPlan().has_value(); };
    step.trouble = seeThePage;
    return step;
}

static TourStep recordStep(MainWindow &window, Workbench &bench)
{
    TourStep step{Step::Record};
    const auto record = [&window, &bench] {
        // One run after the other: the bridge stops by itself at the end of the plan.
        const bool idle = bench.acquisition().state() == Acquisition::State::Idle ||
                          (bench.acquisition().state() == Acquisition::State::Running &&
                           bench.sourceUse() == SourceUse::Watch);
        if (idle && !bench.acquisition().isRecording())
            QMetaObject::invokeMethod(window.page(Step::Record), "startRecording");
    };
    step.what = [] { return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Record the runs.")); };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour",
                                          "Three hours pass in about twelve seconds. Everything is in the "
                                          "session's file as it comes."));
    };
    step.perform = record;
    step.carryOn = record;
    step.isDone = [&bench] { return finishedRuns(bench.session()) >= kTourRuns; };
    step.trouble = [&window, &bench] {
        const auto &page = static_cast<RecordPage &>(*window.page(Step::Record));
        if (page.run().unpluggedAtS())
            return tourText(QT_TRANSLATE_NOOP(
                "SimulatedTour",
                "The bridge was unplugged. Plug it in and try again, or stop the run and end the tour."));
        return sourceMissing(bench);
    };
    step.state = [&bench] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Recording run %1 of %2."))
            .arg(std::min(finishedRuns(bench.session()) + 1, kTourRuns))
            .arg(kTourRuns);
    };
    return step;
}

static TourStep inspectStep()
{
    TourStep step{Step::Inspect};
    step.what = [] { return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Look at the drift.")); };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP(
            "SimulatedTour",
            "Each sample's error against temperature. Where they lie on one curve, a table can remove it."));
    };
    return step;
}

static TourStep trainStep(Workbench &bench)
{
    TourStep step{Step::Train};
    step.what = [] { return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Train the models.")); };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour",
                                          "An RBF network and its rivals. Each run is held out once, so "
                                          "that no model is judged on what it has seen."));
    };
    // The runs may still be being prepared for the page before.
    const auto asked = std::make_shared<bool>(false);
    step.carryOn = [&bench, asked] {
        if (*asked || bench.training().isRunning())
            return;
        const Status started = bench.train();
        *asked = started.ok();
        if (!started)
            emit bench.problem(started.error());
    };
    step.perform = [asked, train = step.carryOn] {
        *asked = false;
        train();
    };
    step.isDone = [&bench] { return bench.session().result() != nullptr; };
    step.state = [&bench] { return bench.training().stage(); };
    step.trouble = [&bench, asked] {
        return !*asked || bench.training().isRunning()
                   ? QString()
                   : tourText(QT_TRANSLATE_NOOP(
                         "SimulatedTour", "The training ended without a model. Try again, or skip it."));
    };
    return step;
}

static TourStep compareStep()
{
    TourStep step{Step::Compare};
    step.what = [] { return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Read the verdict.")); };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP(
            "SimulatedTour",
            "For each axis: write the table, only a constant, or nothing, with the reason."));
    };
    return step;
}

static TourStep exportStep(MainWindow &window, Workbench &bench)
{
    TourStep step{Step::Export};
    step.what = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour", "Write the table into the device."));
    };
    step.why = [] {
        return tourText(QT_TRANSLATE_NOOP("SimulatedTour",
                                          "Written to the spare bank, read back, verified, and only then "
                                          "made active. Cut off anywhere, the old table stays."));
    };
    // The table is made and the device looked at when the page is entered: it may take a moment.
    const auto write = [&window] {
        static_cast<ExportPage &>(*window.page(Step::Export)).writeAction()->trigger(); // if it is enabled
    };
    step.perform = [write, &window] {
        window.bringIntoView(static_cast<ExportPage &>(*window.page(Step::Export)).device());
        write();
    };
    step.carryOn = write;
    step.trouble = [&window, &bench] {
        const auto &page = static_cast<ExportPage &>(*window.page(Step::Export));
        if (bench.session().chosenModel() == nullptr)
            return tourText(QT_TRANSLATE_NOOP(
                "SimulatedTour", "There is no model to write; go back to Train, or end the tour."));
        const ExportPreview *preview = page.preview();
        if (preview != nullptr && preview->refusal)
            return QString::fromStdString(preview->refusal->message);
        if (preview != nullptr && preview->imageRefusal)
            return QString::fromStdString(preview->imageRefusal->message);
        const QString missing = sourceMissing(bench);
        return missing.isEmpty() ? page.device().problem() : missing;
    };
    step.isDone = [&bench] {
        const auto &uploads = bench.session().uploads();
        return !uploads.empty() && uploads.back().verified && uploads.back().activated;
    };
    return step;
}

void failWithTheWork(GuidedTour &tour, Workbench &bench)
{
    QObject::connect(&bench, &Workbench::problem, &tour,
                     [&tour](const Error &error) { tour.fail(QString::fromStdString(error.message)); });
    QObject::connect(
        &bench.upload(), &UploadJob::uploaded, &tour, [&tour](const Result<UploadOutcome> &outcome) {
            if (!outcome)
                tour.fail(QString::fromStdString(outcome.error().message));
            else if (outcome->report.rolledBack)
                tour.fail(tourText(QT_TRANSLATE_NOOP("SimulatedTour",
                                                     "The device computed something else with the new table "
                                                     "and has its old one again. Try again, or skip it.")));
        });
}

std::vector<TourStep> simulatedTour(MainWindow &window, Workbench &bench)
{
    return {connectStep(window, bench), planStep(window, bench), recordStep(window, bench), inspectStep(),
            trainStep(bench),           compareStep(),           exportStep(window, bench)};
}

} // namespace driftbench
