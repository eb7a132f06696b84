#include "app/session/session.h"

#include "app/session/session_lock.h"
#include "engine/recording/block_means.h"

#include <algorithm>
#include <array>
#include <utility>

namespace driftbench {

EventSeverity severityOf(const SessionEvent &event)
{
    constexpr std::array<std::string_view, 3> kProblems{"recorder", "recovery", "problem"};
    constexpr std::array<std::string_view, 3> kWarnings{"gap", "device", "warning"};
    const auto isOne = [&event](const auto &kinds) {
        return std::find(kinds.begin(), kinds.end(), event.kind) != kinds.end();
    };
    return isOne(kProblems)   ? EventSeverity::Problem
           : isOne(kWarnings) ? EventSeverity::Warning
                              : EventSeverity::Note;
}

namespace {

bool sameData(const RunRecord &a, const RunRecord &b)
{
    return a.id == b.id && a.samples == b.samples && a.description.name == b.description.name;
}

bool sameState(const RunRecord &a, const RunRecord &b)
{
    return a.state == b.state && a.endedUtc == b.endedUtc;
}

} // namespace

Status Session::mayChange() const
{
    if (isReadOnly())
        return Error{Errc::SessionReadOnly, m_file.readOnlyReason()};
    return {};
}

Status Session::setSource(const SourceChoice &choice)
{
    if (Status may = mayChange(); !may)
        return may;
    m_source = choice;
    const Status saved = save(Part::Source);
    emit sourceChanged();
    return saved;
}

Status Session::setTestPlan(const TestPlan &plan)
{
    if (Status may = mayChange(); !may)
        return may;
    if (Status valid = checkTestPlan(plan); !valid)
        return valid;
    m_testPlan = plan;
    const Status saved = save(Part::TestPlan);
    emit testPlanChanged();
    return saved;
}

const RunRecord *Session::run(RunId id) const
{
    const auto found =
        std::find_if(m_runs.begin(), m_runs.end(), [id](const RunRecord &each) { return each.id == id; });
    return found == m_runs.end() ? nullptr : &*found;
}

bool Session::isSimulated() const
{
    return std::any_of(m_runs.begin(), m_runs.end(),
                       [](const RunRecord &each) { return each.description.simulated; });
}

Result<std::shared_ptr<const Recording>> Session::recording(RunId id)
{
    if (auto known = m_recordings[id].lock())
        return known;
    auto recording = m_file.readRun(id, {.mostPoints = kMostPoints});
    if (!recording)
        return recording.error();
    auto shared = std::make_shared<const Recording>(*std::move(recording));
    m_recordings[id] = shared;
    return shared;
}

Status Session::renameRun(RunId id, const QString &name)
{
    if (Status may = mayChange(); !may)
        return may;
    if (Status renamed = m_file.renameRun(id, name.toStdString()); !renamed)
        return renamed;
    return refreshRuns();
}

Status Session::removeRun(RunId id)
{
    if (Status may = mayChange(); !may)
        return may;
    if (Status removed = m_file.removeRun(id); !removed)
        return removed;
    m_recordings.erase(id);
    return refreshRuns();
}

Status Session::readRuns()
{
    auto runs = m_file.runs();
    if (!runs)
        return runs.error();
    auto sensor = m_file.sensor();
    if (!sensor)
        return sensor.error();
    m_runs = *std::move(runs);
    // Who only reads does not mark what a killed program left, but should not call it being recorded either.
    const auto isRecording = [](const RunRecord &each) { return each.state == RunState::Recording; };
    if (isReadOnly() && std::any_of(m_runs.begin(), m_runs.end(), isRecording) &&
        SessionLock::acquire(path())) {
        for (RunRecord &each : m_runs)
            each.state = isRecording(each) ? RunState::Interrupted : each.state;
    }
    m_sensor = *std::move(sensor);
    return {};
}

Status Session::refreshRuns()
{
    const std::vector<RunRecord> before = m_runs;
    if (Status read = readRuns(); !read)
        return read;
    const bool otherData = !std::equal(before.begin(), before.end(), m_runs.begin(), m_runs.end(), sameData);
    const bool otherState =
        !std::equal(before.begin(), before.end(), m_runs.begin(), m_runs.end(), sameState);
    if (!otherData && !otherState)
        return {};
    if (!otherData) {
        emit runsChanged();
        return {};
    }
    // A run that grew is another recording.
    std::erase_if(m_recordings, [this](const auto &each) {
        const auto recording = each.second.lock();
        const RunRecord *now = run(each.first);
        return !recording || !now || recording->samples() != now->samples;
    });
    const CalibrationPlan planBefore = plan();
    m_history.fitToRuns(m_runs);
    return inputsChanged(true, !(plan() == planBefore));
}

Status Session::inputsChanged(bool runs, bool otherPlan)
{
    const bool hadPrepared = std::exchange(m_prepared, nullptr) != nullptr;
    const bool hadResult = std::exchange(m_result, nullptr) != nullptr;
    m_modelIds.clear();
    Status saved;
    if (otherPlan && !isReadOnly())
        saved = save(Part::Plan);
    if (hadResult && !isReadOnly()) {
        if (Status cleared = save(Part::Result); !cleared)
            saved = cleared;
    }
    if (runs)
        emit runsChanged();
    if (otherPlan)
        emit planChanged();
    if (hadPrepared)
        emit preparedChanged();
    if (hadResult)
        emit resultChanged();
    return saved;
}

// By a limit nothing is computed, so nothing is dropped.
Status Session::planEdited(const CalibrationPlan &before)
{
    if (!computesTheSame(before, plan()))
        return inputsChanged(false, true);
    const Status saved = save(Part::Plan);
    emit planChanged();
    return saved;
}

Status Session::editPlan(CalibrationPlan plan, const QString &text)
{
    if (Status may = mayChange(); !may)
        return may;
    const CalibrationPlan before = this->plan();
    if (!m_history.edit(fittedToRuns(std::move(plan), m_runs), text))
        return {};
    return planEdited(before);
}

Status Session::undo()
{
    if (Status may = mayChange(); !may)
        return may;
    const CalibrationPlan before = plan();
    return m_history.undo() ? planEdited(before) : Status();
}

Status Session::redo()
{
    if (Status may = mayChange(); !may)
        return may;
    const CalibrationPlan before = plan();
    return m_history.redo() ? planEdited(before) : Status();
}

bool Session::setPrepared(const std::shared_ptr<const PreparedCampaign> &prepared)
{
    if (!prepared || !computesTheSame(prepared->plan, plan()))
        return false;
    m_prepared = prepared;
    emit preparedChanged();
    return true;
}

Result<TrainingInput> Session::trainingInput(bool train) const
{
    auto file = anotherFile();
    if (!file)
        return file.error();
    TrainingInput input{plan(), {}, *std::move(file), m_prepared, train};
    for (const RunRecord &each : m_runs) {
        const auto known = m_recordings.find(each.id);
        if (known == m_recordings.end())
            continue;
        if (auto recording = known->second.lock())
            input.known.push_back({each, std::move(recording)});
    }
    return input;
}

Status Session::setExportChoice(const ExportChoice &choice)
{
    if (Status may = mayChange(); !may)
        return may;
    m_choice = choice;
    const Status saved = save(Part::Choice);
    emit exportChoiceChanged();
    return saved;
}

const TrainedModel *Session::chosenModel() const
{
    return m_result ? m_result->model(m_choice.model) : nullptr;
}

std::optional<ModelId> Session::modelId(const std::string &name) const
{
    const auto found = m_modelIds.find(name);
    return found == m_modelIds.end() ? std::nullopt : std::optional(found->second);
}

} // namespace driftbench
