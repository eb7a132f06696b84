#include "app/session/session.h"

#include "app/session/session_file_state.h"
#include "app/session/session_source.h"
#include "engine/models/model_file.h"

#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kSource = "source";
constexpr const char *kPlan = "calibration-plan";
constexpr const char *kResult = "result"; // which comparison and models are those of the plan of now
constexpr const char *kEvaluation = "evaluation";
constexpr const char *kChoice = "export-choice";

bool sameMarks(const RunInPlan &a, const RunInPlan &b)
{
    const auto same = [](const Exclusion &one, const Exclusion &other) {
        return one.range.startS == other.range.startS && one.range.endS == other.range.endS &&
               one.note == other.note;
    };
    return std::equal(a.excluded.begin(), a.excluded.end(), b.excluded.begin(), b.excluded.end(), same);
}

struct StoredResult
{
    std::int64_t comparison = 0;
    std::vector<ModelId> models;
    std::vector<HeldOutModels> heldOut;
    std::map<std::string, double> trainingS;
};

std::string storedToJson(const StoredResult &stored)
{
    Json folds = Json::array();
    for (const HeldOutModels &fold : stored.heldOut) {
        Json models = Json::array();
        for (const TrainedModel &model : fold.models)
            models.push_back(modelToJson(model));
        folds.push_back({{"fold", fold.fold}, {"models", models}});
    }
    const Json json{{"comparison", stored.comparison},
                    {"models", stored.models},
                    {"held_out", folds},
                    {"training_s", stored.trainingS}};
    // Names of runs need not be valid UTF-8; JSON must be.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Throws Json::exception where the document is of another shape.
Result<StoredResult> storedFrom(const Json &json)
{
    StoredResult stored;
    stored.comparison = json.at("comparison").get<std::int64_t>();
    stored.models = json.at("models").get<std::vector<ModelId>>();
    stored.trainingS = json.at("training_s").get<std::map<std::string, double>>();
    for (const Json &fold : json.at("held_out")) {
        HeldOutModels &heldOut =
            stored.heldOut.emplace_back(HeldOutModels{fold.at("fold").get<std::string>(), {}});
        for (const Json &text : fold.at("models")) {
            auto model = modelFromJson(text.get<std::string>(), "A model in the session");
            if (!model)
                return model.error();
            heldOut.models.push_back(*std::move(model));
        }
    }
    return stored;
}

Result<StoredResult> storedFromJson(const std::string &text)
{
    try {
        return storedFrom(Json::parse(text));
    } catch (const Json::exception &problem) {
        return Error{Errc::SessionDamaged, std::string("The result in the session is damaged (") +
                                               problem.what() + "); train again."};
    }
}

} // namespace

Status Session::save(Part part)
{
    const Status written = write(part);
    if (written) {
        if (m_unsaved.erase(part) > 0 && m_unsaved.empty())
            emit savedAgain();
        return {};
    }
    m_unsaved.insert(part);
    emit savingFailed(QString::fromStdString(written.error().message));
    return written;
}

Status Session::saveAgain()
{
    const std::set<Part> parts = m_unsaved;
    for (const Part part : parts) {
        if (Status saved = save(part); !saved)
            return saved;
    }
    return {};
}

Status Session::write(Part part)
{
    switch (part) {
    case Part::Source:
        return m_file.setDocument(kSource, sourceChoiceToJson(*m_source));
    case Part::TestPlan:
        return m_file.setPlan(*m_testPlan);
    case Part::Plan:
        return writePlan();
    case Part::Result:
        return writeResult();
    case Part::Choice:
        return m_file.setDocument(kChoice, exportChoiceToJson(m_choice));
    }
    return {};
}

Status Session::writePlan()
{
    for (const RunInPlan &run : plan().runs) {
        const RunInPlan *written = m_writtenPlan.find(run.run);
        if (!written || !sameMarks(*written, run)) {
            if (Status set = m_file.setExclusions(run.run, run.excluded); !set)
                return set;
        }
        if (!written || written->referenceRateDps != run.referenceRateDps) {
            if (Status set = m_file.setReferenceRate(run.run, run.referenceRateDps); !set)
                return set;
        }
    }
    if (Status set = m_file.setDocument(kPlan, calibrationPlanToJson(plan())); !set)
        return set;
    m_writtenPlan = plan();
    return {};
}

Status Session::loadSource()
{
    const auto text = m_file.document(kSource);
    if (!text)
        return text.error();
    if (!*text)
        return {};
    auto choice = sourceChoiceFromJson(**text);
    if (!choice)
        return choice.error();
    m_source = *std::move(choice);
    return {};
}

Status Session::loadChoice()
{
    const auto text = m_file.document(kChoice);
    if (!text)
        return text.error();
    if (!*text)
        return {};
    auto choice = exportChoiceFromJson(**text);
    if (!choice)
        return choice.error();
    m_choice = *std::move(choice);
    return {};
}

Status Session::loadPlan()
{
    const auto text = m_file.document(kPlan);
    if (!text)
        return text.error();
    CalibrationPlan plan;
    Status damage;
    if (*text) {
        auto read = calibrationPlanFromJson(**text);
        if (read)
            plan = *std::move(read);
        else
            damage = read.error();
    }
    plan = fittedToRuns(std::move(plan), m_runs);
    for (RunInPlan &inPlan : plan.runs) {
        inPlan.referenceRateDps = run(inPlan.run)->description.referenceRateDps;
        auto excluded = m_file.exclusions(inPlan.run);
        if (!excluded)
            return excluded.error();
        inPlan.excluded = *std::move(excluded);
    }
    m_writtenPlan = plan;
    m_history.reset(std::move(plan));
    return damage;
}

Status Session::writeResult()
{
    m_modelIds.clear();
    if (!m_result)
        return m_file.removeDocument(kResult);
    StoredResult stored;
    for (const TrainedModel &model : m_result->models) {
        const auto id = m_file.addModel(model);
        if (!id)
            return id.error();
        m_modelIds[model.name] = *id;
        stored.models.push_back(*id);
    }
    const auto comparison = m_file.addComparison(m_result->comparisonJson, m_result->recommendationJson);
    if (!comparison)
        return comparison.error();
    stored.comparison = *comparison;
    stored.heldOut = m_result->heldOut;
    stored.trainingS = m_result->trainingS;
    return m_file.setDocument(kResult, storedToJson(stored));
}

Status Session::loadResult()
{
    if (auto evaluation = m_file.document(kEvaluation); !evaluation)
        return evaluation.error();
    else
        m_evaluation = evaluation->value_or("");
    const auto text = m_file.document(kResult);
    if (!text)
        return text.error();
    if (!*text)
        return {};
    auto stored = storedFromJson(**text);
    if (!stored)
        return stored.error();
    std::vector<TrainedModel> models;
    for (const ModelId id : stored->models) {
        auto model = m_file.model(id);
        if (!model)
            return model.error();
        m_modelIds[model->name] = id;
        models.push_back(*std::move(model));
    }
    const auto comparisons = m_file.comparisons();
    if (!comparisons)
        return comparisons.error();
    for (const ComparisonRecord &record : *comparisons) {
        if (record.id != stored->comparison)
            continue;
        auto result = resultFrom(record.comparisonJson, record.recommendationJson, std::move(models),
                                 std::move(stored->heldOut));
        if (!result)
            return result.error();
        result->trainingS = std::move(stored->trainingS);
        m_result = std::make_shared<const CalibrationResult>(*std::move(result));
        break;
    }
    return {};
}

Status Session::setResult(const std::shared_ptr<const CalibrationResult> &result)
{
    if (Status may = mayChange(); !may)
        return may;
    if (!m_prepared)
        return Error{
            Errc::InvalidOption,
            "The calibration plan or the runs were changed since this result was begun; train again."};
    m_result = result;
    const Status saved = save(Part::Result);
    emit resultChanged();
    return saved;
}

Status Session::setEvaluation(const std::string &json)
{
    if (Status set = m_file.setDocument(kEvaluation, json); !set)
        return set;
    m_evaluation = json;
    emit evaluationChanged();
    return {};
}

Status Session::addExport(ExportRecord made)
{
    if (Status added = m_file.addExport(made); !added)
        return added;
    auto exports = m_file.exports(); // with the time that the file gave it
    if (!exports)
        return exports.error();
    m_exports = *std::move(exports);
    emit exportsChanged();
    return {};
}

Status Session::addUpload(UploadRecord made)
{
    if (Status added = m_file.addUpload(made); !added)
        return added;
    auto uploads = m_file.uploads();
    if (!uploads)
        return uploads.error();
    m_uploads = *std::move(uploads);
    emit uploadsChanged();
    return {};
}

Status Session::addEvent(SessionEvent event)
{
    if (event.utc.empty())
        event.utc = utcNow();
    m_events.push_back(event);
    emit eventAdded(event);
    return isReadOnly() ? Status() : m_file.addEvent(event);
}

Status Session::addNote(const QString &text, std::optional<RunId> run)
{
    const auto added = m_file.addNote({0, {}, run, text.toStdString()});
    if (!added)
        return added.error();
    auto notes = m_file.notes();
    if (!notes)
        return notes.error();
    m_notes = *std::move(notes);
    emit notesChanged();
    return {};
}

} // namespace driftbench
