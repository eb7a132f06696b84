#include "app/session/session.h"

#include <algorithm>
#include <array>

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
    auto recording = m_file.readRun(id);
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
    m_sensor = *std::move(sensor);
    return {};
}

Status Session::refreshRuns()
{
    if (Status read = readRuns(); !read)
        return read;
    // A run that grew is another recording.
    std::erase_if(m_recordings, [this](const auto &each) {
        const auto recording = each.second.lock();
        const RunRecord *now = run(each.first);
        return !recording || !now || recording->size() != now->samples;
    });
    m_history.fitToRuns(m_runs);
    bool hadPrepared = false;
    bool hadResult = false;
    dropComputed(hadPrepared, hadResult);
    Status saved = isReadOnly() ? Status() : save(Part::Plan);
    if (hadResult && !isReadOnly()) {
        if (Status cleared = save(Part::Result); !cleared)
            saved = cleared;
    }
    emit runsChanged();
    emit planChanged();
    if (hadPrepared)
        emit preparedChanged();
    if (hadResult)
        emit resultChanged();
    return saved;
}

void Session::dropComputed(bool &hadPrepared, bool &hadResult)
{
    hadPrepared = m_prepared != nullptr;
    hadResult = m_result != nullptr;
    m_prepared.reset();
    m_result.reset();
    m_modelIds.clear();
}

void Session::planHasChanged()
{
    bool hadPrepared = false;
    bool hadResult = false;
    dropComputed(hadPrepared, hadResult);
    emit planChanged();
    if (hadPrepared)
        emit preparedChanged();
    if (hadResult)
        emit resultChanged();
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
