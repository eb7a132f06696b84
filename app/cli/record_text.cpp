#include "app/cli/record_text.h"

#include "app/cli/text_layout.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/formats/sidecar.h"

#include <cmath>

namespace driftbench::cli {

namespace {

std::string timeText(double seconds)
{
    if (seconds < 120.0)
        return fixed(seconds, 0) + " s";
    return seconds < 7200.0 ? fixed(seconds / 60.0, 0) + " min" : fixed(seconds / 3600.0, 1) + " h";
}

std::string goalText(double timeS, const RecordingGoal &goal)
{
    return fixed(100.0 * std::min(1.0, timeS / goal.durationS), 0) + " %  " +
           timeText(std::max(0.0, goal.durationS - timeS)) + " left  ";
}

std::string line(const std::string &name, const std::string &text)
{
    return wrapped(left(name, 13), text);
}

std::string endText(const RecordingOutcome &outcome)
{
    switch (outcome.end) {
    case RecordingEnd::Duration:
        return "as long as was wanted";
    case RecordingEnd::Source:
        return "the source ended";
    case RecordingEnd::Asked:
        return "stopped by you";
    case RecordingEnd::Sink:
        return "the file could not be written any more";
    case RecordingEnd::Error:
        return "an error of the source";
    }
    return {};
}

std::string lossText(const RecordingState &state)
{
    if (state.gaps == 0)
        return "none";
    return std::to_string(state.lostSamples) + " samples in " + std::to_string(state.gaps) +
           (state.gaps == 1 ? " gap of " : " gaps of ") + fixed(state.gapS, 2) + " s; nothing is filled in";
}

} // namespace

std::string recordingLine(const RecordingState &state, const RecordingGoal &goal)
{
    if (state.samples == 0)
        return "waiting for the first sample";
    std::string text =
        goal.durationS > 0.0 ? goalText(state.lastS, goal) : timeText(state.durationS()) + "  ";
    text += "T " + forReading(state.temperatureC, 2) + " °C";
    if (goal.profile)
        text += " (plan " + forReading(goal.profile->setpointC(state.lastS), 1) + ")";
    for (int axis = 0; axis < kAxisCount; ++axis)
        text += "  " + std::string(kAxisNames[axis]) + " " + forReading(state.rateDps[axis], 2);
    return text + " dps  " + fixed(state.measuredRateHz(), 1) + " Hz  " + std::to_string(state.samples) +
           " samples  " + std::to_string(state.lostSamples) + " lost";
}

std::string recordingAsText(const RecordingOutcome &outcome, const CsvRecorder &recorder)
{
    const RecordingState &state = outcome.state;
    std::string text = line("recorded", recorder.path().string());
    text += line("samples", std::to_string(state.samples) + " in " + fixed(state.durationS(), 1) + " s, " +
                                fixed(state.measuredRateHz(), 2) + " Hz");
    if (state.hasTemperature())
        text += line("temperature",
                     forReading(state.lowestC, 2) + " to " + forReading(state.highestC, 2) + " °C");
    text += line("lost", lossText(state));
    if (outcome.stats) {
        text += line("saturated", std::to_string(outcome.stats->saturatedSamples) + " samples");
        text += line("clock", forReading(outcome.stats->clockDriftPpm, 1) + " ppm against this computer");
    }
    text +=
        line("events", std::to_string(state.events) + " and the gaps in " + recorder.eventsPath().string());
    return text + line("ended", endText(outcome));
}

nlohmann::ordered_json recordingAsJson(const RecordingOutcome &outcome, const CsvRecorder &recorder)
{
    nlohmann::ordered_json json{{"file", recorder.path().string()},
                                {"sidecar", sidecarPath(recorder.path()).string()},
                                {"events", recorder.eventsPath().string()}};
    json.update(outcomeAsJson(outcome));
    return json;
}

} // namespace driftbench::cli
