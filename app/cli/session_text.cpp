#include "app/cli/session_text.h"

#include "app/cli/text_table.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string durationText(double seconds)
{
    if (seconds < 100.0)
        return fixed(seconds, 1) + " s";
    const auto minutes = static_cast<long>(seconds / 60.0);
    if (minutes < 100)
        return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

std::string stateText(const RunRecord &run)
{
    if (run.state == RunState::Interrupted)
        return "interrupted, can be continued";
    return std::string(runStateName(run.state));
}

std::string runsText(const Session &session)
{
    if (session.runs().empty())
        return "No runs yet.\n";
    TextTable table;
    table.addColumn("run", Align::Left);
    table.addColumn("samples", Align::Right);
    table.addColumn("length", Align::Right);
    table.addColumn("begun", Align::Left);
    table.addColumn("from", Align::Left);
    table.addColumn("state", Align::Left);
    for (const RunRecord &run : session.runs()) {
        const RunInPlan *inPlan = session.plan().find(run.id);
        std::string state = stateText(run);
        if (inPlan && !inPlan->takesPart)
            state += ", left out";
        table.addRow({run.description.name, std::to_string(run.samples),
                      durationText(run.lastTimeS - run.firstTimeS), run.description.startedUtc.substr(0, 19),
                      run.description.source, state});
    }
    return "Runs:\n" + table.text();
}

std::string resultText(const Session &session)
{
    if (!session.result())
        return "No models of these runs.\n";
    std::string text = "Models:";
    for (const TrainedModel &model : session.result()->models)
        text += " " + model.name;
    text += "\n";
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        const AxisVerdict &verdict = session.result()->figures.verdicts[axis];
        text += "  " + std::string(kAxisNames[axis]) + ": " + std::string(verdictName(verdict.verdict)) +
                ", " + verdict.model + ". " + verdict.reason + "\n";
    }
    return text;
}

std::string writtenText(const Session &session)
{
    std::string text;
    for (const ExportRecord &made : session.exports())
        text += "Exported " + made.utc.substr(0, 19) + ": " + made.path + " (" + made.format + ")\n";
    for (const UploadRecord &made : session.uploads())
        text += "Uploaded " + made.utc.substr(0, 19) + ": to " + made.device + ", " +
                (made.verified ? "verified" : "not verified") + (made.activated ? ", in use" : "") + "\n";
    return text;
}

std::string logText(const Session &session)
{
    constexpr std::size_t kShown = 20;
    const auto &events = session.events();
    if (events.empty())
        return {};
    const std::size_t first = events.size() > kShown ? events.size() - kShown : 0;
    std::string text = first > 0 ? "Log (the last " + std::to_string(kShown) + " of " +
                                       std::to_string(events.size()) + "):\n"
                                 : "Log:\n";
    for (std::size_t i = first; i < events.size(); ++i) {
        const RunRecord *run = events[i].run ? session.run(*events[i].run) : nullptr;
        text += "  " + events[i].utc.substr(0, 19) + "  " +
                (run ? run->description.name + ": " : std::string()) + events[i].text + "\n";
    }
    return text;
}

Json runJson(const Session &session, const RunRecord &run)
{
    const RunInPlan *inPlan = session.plan().find(run.id);
    const auto gaps = session.file().gaps(run.id);
    return {{"id", run.id},
            {"name", run.description.name},
            {"state", std::string(runStateName(run.state))},
            {"source", run.description.source},
            {"format", run.description.format},
            {"simulated", run.description.simulated},
            {"samples", run.samples},
            {"first_time_s", run.firstTimeS},
            {"last_time_s", run.lastTimeS},
            {"started_utc", run.description.startedUtc},
            {"ended_utc", run.endedUtc},
            {"gaps", gaps ? Json(gaps->size()) : Json()},
            {"takes_part", inPlan && inPlan->takesPart}};
}

} // namespace

std::string sessionAsText(const Session &session)
{
    std::string text = session.path().string() + "\n";
    text += "Sensor: " + session.sensor().text() + (session.isSimulated() ? " (simulated)" : "") + "\n";
    return text + runsText(session) + resultText(session) + writtenText(session) + logText(session);
}

Json sessionAsJson(const Session &session)
{
    Json runs = Json::array();
    for (const RunRecord &run : session.runs())
        runs.push_back(runJson(session, run));
    Json models = Json::array();
    if (session.result()) {
        for (const TrainedModel &model : session.result()->models)
            models.push_back(model.name);
    }
    Json events = Json::array();
    for (const SessionEvent &event : session.events())
        events.push_back({{"utc", event.utc}, {"kind", event.kind}, {"text", event.text}});
    return {{"file", session.path().string()},
            {"sensor", {{"model", session.sensor().model}, {"serial", session.sensor().serial}}},
            {"simulated", session.isSimulated()},
            {"runs", runs},
            {"models", models},
            {"exports", session.exports().size()},
            {"uploads", session.uploads().size()},
            {"events", events}};
}

} // namespace driftbench::cli
