#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/model_input.h"
#include "app/cli/progress_line.h"
#include "app/cli/record_text.h"
#include "app/cli/session_recording.h"
#include "app/cli/source_options.h"
#include "engine/base/text.h"
#include "engine/physics/plan_file.h"

#include <chrono>
#include <cmath>
#include <memory>

namespace driftbench::cli {

namespace {

constexpr std::chrono::milliseconds kBetweenSyncs{500};

struct RecordArguments
{
    SourceArguments source;
    std::string out;
    std::string events;
    std::optional<double> durationS;
    std::optional<std::string> plan;
    bool overwrite = false;
    std::string runName; // in a session
    bool goOn = false;
    bool json = false;
};

Result<std::optional<TestPlan>> planOf(const RecordArguments &arguments)
{
    if (!arguments.plan)
        return std::optional<TestPlan>();
    auto plan = readPlan(*arguments.plan);
    if (!plan)
        return plan.error();
    return std::optional<TestPlan>(*std::move(plan));
}

// The shorter of what was asked for.
Result<RecordingGoal> goalOf(const RecordArguments &arguments, const std::optional<TestPlan> &plan)
{
    RecordingGoal goal;
    if (arguments.durationS && !(*arguments.durationS > 0.0 && std::isfinite(*arguments.durationS)))
        return Error{Errc::InvalidOption, "The duration is " + shortest(*arguments.durationS) +
                                              " s; give more than 0, or leave it out."};
    goal.durationS = arguments.durationS.value_or(0.0);
    if (!plan)
        return goal;
    auto profile = plan->profile();
    if (!profile)
        return profile.error();
    goal.profile = *std::move(profile);
    const double planS = plan->runDurationS();
    goal.durationS = arguments.durationS ? std::min(goal.durationS, planS) : planS;
    return goal;
}

// Rates of devices are multiples of 10 udps, their times are known to microseconds; a log's are kept as they
// are.
CsvDecimals decimalsFor(const SourceChoice &choice)
{
    return choice.as<FileChoice>() ? CsvDecimals{} : CsvDecimals{6, std::nullopt, 5};
}

Result<CsvRecorder> recorderOf(const RecordArguments &arguments, const SourceChoice &choice,
                               const SourceInfo &info)
{
    CsvRecorderOptions options;
    options.out = arguments.out;
    options.events = arguments.events;
    options.replace = arguments.overwrite;
    options.decimals = decimalsFor(choice);
    if (const auto *simulated = choice.as<SimulatedChoice>())
        options.referenceRateDps = simulated->referenceRateDps;
    options.source = arguments.source.source;
    return CsvRecorder::create(info, std::move(options));
}

// On this thread, while the source runs on its own: shows how it goes, brings it to the disk, ends it.
RecordingTick ticker(ProgressLine &progress, const RecordingGoal &goal, const CsvRecorder &recorder,
                     Status &synced)
{
    auto nextSync = std::chrono::steady_clock::now() + kBetweenSyncs;
    return [&, nextSync](const RecordingState &state) mutable {
        progress.show(recordingLine(state, goal));
        if (std::chrono::steady_clock::now() >= nextSync) {
            synced = recorder.sync();
            nextSync = std::chrono::steady_clock::now() + kBetweenSyncs;
        }
        return interrupted() || !synced ? Flow::Stop : Flow::Continue;
    };
}

Status show(const RecordingOutcome &outcome, const CsvRecorder &recorder, bool json)
{
    return json ? printJson(recordingAsJson(outcome, recorder))
                : printResult(recordingAsText(outcome, recorder));
}

Status noSamples(const SourceInfo &info)
{
    return Error{Errc::TooFewSamples,
                 "No sample came from " + info.name + "; check that it measures, and record again."};
}

// A run of a session. Its recorder brings it to the disk by itself.
Status recordIntoSession(const RecordArguments &arguments, const std::optional<TestPlan> &plan,
                         const RecordingGoal &goal, const SourceChoice &choice)
{
    if (arguments.overwrite || !arguments.events.empty())
        return Error{Errc::InvalidOption,
                     "--overwrite and --events are for logs; a session keeps every run, and its "
                     "gaps and events beside the samples."};
    const auto opened = openSource(choice);
    if (!opened)
        return opened.error();
    const SourceInfo info = opened->source->info();
    auto recording = SessionRecording::begin(
        info, {arguments.out, arguments.runName, arguments.goOn, !opened->isRealTime, choice, plan});
    if (!recording)
        return recording.error();
    const RecordingOutcome outcome = [&] {
        ProgressLine progress;
        return record(*opened->source, **recording, {goal.durationS, opened->isRealTime},
                      [&](const RecordingState &state) {
                          progress.show(recordingLine(state, goal));
                          return interrupted() ? Flow::Stop : Flow::Continue;
                      });
    }();
    const Status finished = (*recording)->finish(outcome);
    const Status shown = arguments.json ? printJson((*recording)->asJson(outcome))
                                        : printResult((*recording)->asText(outcome));
    for (const Status &each : {outcome.status, finished, shown}) {
        if (!each)
            return each;
    }
    return outcome.state.samples > 0 ? Status() : noSamples(info);
}

Status recordIt(const RecordArguments &arguments)
{
    const auto plan = planOf(arguments);
    if (!plan)
        return plan.error();
    const auto goal = goalOf(arguments, *plan);
    if (!goal)
        return goal.error();
    const auto choice = sourceChoiceOf(arguments.source, *plan);
    if (!choice)
        return choice.error();
    if (isSessionPath(arguments.out))
        return recordIntoSession(arguments, *plan, *goal, *choice);
    if (arguments.goOn || !arguments.runName.empty())
        return Error{Errc::InvalidOption,
                     "--continue and --name are for sessions; end the name of --out in " +
                         std::string(kSessionEnding) + ", or leave them out."};
    const auto opened = openSource(*choice);
    if (!opened)
        return opened.error();
    auto recorder = recorderOf(arguments, *choice, opened->source->info());
    if (!recorder)
        return recorder.error();
    Status synced;
    const RecordingOutcome outcome = [&] {
        ProgressLine progress;
        return record(*opened->source, *recorder, {goal->durationS, opened->isRealTime},
                      ticker(progress, *goal, *recorder, synced));
    }();
    const Status finished = recorder->finish(outcome);
    const Status shown = show(outcome, *recorder, arguments.json);
    for (const Status &each : {outcome.status, finished, synced, shown}) {
        if (!each)
            return each;
    }
    return outcome.state.samples > 0 ? Status() : noSamples(opened->source->info());
}

} // namespace

void addRecordCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<RecordArguments>();
    CLI::App *command = addCommand(
        program, "record",
        "Records from a device, or from the simulated one, into a CSV log that every other command "
        "reads. What was recorded is kept whatever ends it; Ctrl-C ends it well.",
        "driftbench-cli record --source hid --plan plan.json --out run1.csv");
    command
        ->add_option(
            "--out", arguments->out,
            "The log, .meta.json and .events.csv are put beside it; or a session (.driftbench), which gets "
            "another run")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--duration", arguments->durationS,
                     "Ends after so many seconds (default: with the plan, the source or Ctrl-C)")
        ->type_name("S");
    command
        ->add_option("--plan", arguments->plan,
                     "Plan that the chamber follows, as driftbench-cli plan writes it: ends with its run")
        ->type_name("FILE");
    command->add_option("--events", arguments->events, "Gaps and events (default: FILE.events.csv)")
        ->type_name("FILE");
    command->add_option("--name", arguments->runName, "Name of the run in the session (default: run N)")
        ->type_name("NAME");
    command->add_flag("--continue", arguments->goOn,
                      "Go on with the session's interrupted run, behind a gap");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a log of that name");
    addJsonOption(*command, arguments->json);
    addSourceOptions(*command, arguments->source);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return recordIt(*arguments); }; });
}

} // namespace driftbench::cli
