#include "app/gui/train/train_figures.h"

#include "app/gui/train/model_words.h"
#include "engine/evaluation/comparison.h"
#include "engine/models/parameter_count.h"
#include "widgets/style/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace driftbench {

namespace {

class TrainFigures
{
    Q_DECLARE_TR_FUNCTIONS(driftbench::TrainFigures)
};

using Figure = double ComparisonRow::*;

std::array<double, 3> meansOf(const std::vector<ComparisonRow> &rows, const std::string &model, Figure figure)
{
    std::array<double, 3> sum{};
    std::array<int, 3> count{};
    for (const ComparisonRow &row : rows) {
        if (row.model != model)
            continue;
        sum[static_cast<std::size_t>(row.axis)] += row.*figure;
        ++count[static_cast<std::size_t>(row.axis)];
    }
    for (std::size_t axis = 0; axis < sum.size(); ++axis)
        sum[axis] = count[axis] > 0 ? sum[axis] / count[axis] : NAN;
    return sum;
}

std::array<double, 3> inPercent(std::array<double, 3> values)
{
    for (double &value : values)
        value *= 100.0;
    return values;
}

// As the table lists them: the paper's novel model first, the simplest last.
std::vector<std::string> listed(const CalibrationPlan &plan)
{
    std::vector<std::string> names;
    for (const char *name : {"rbf", "rbf-paper", "bpnn", "cubic", "cubic-ardupilot", "linear", "constant"}) {
        if (std::find(plan.models.begin(), plan.models.end(), name) != plan.models.end())
            names.emplace_back(name);
    }
    return names;
}

std::string recommendedOnMost(const CalibrationResult &result)
{
    std::map<std::string, int> axes;
    for (const AxisVerdict &verdict : result.figures.verdicts)
        ++axes[verdict.model];
    const auto most = std::max_element(axes.begin(), axes.end(), [](const auto &left, const auto &right) {
        return left.second < right.second;
    });
    return most == axes.end() ? std::string() : most->first;
}

void fillFigures(ModelLine &line, const CalibrationResult &result)
{
    const TrainedModel *model = result.model(line.name);
    if (model == nullptr)
        return;
    line.state = ModelLine::State::Finished;
    line.label = modelTitle(line.name, model);
    line.parameters = parameterCount(model->model);
    const auto time = result.trainingS.find(line.name);
    line.timeS = time == result.trainingS.end() ? NAN : time->second;
    line.msd = meansOf(result.figures.rows, line.name, &ComparisonRow::msdAfter);
    line.excessPercent = inPercent(meansOf(result.figures.rows, line.name, &ComparisonRow::excessOverFloor));
}

// Models are trained one after the other, in the order of the plan.
void fillProgress(ModelLine &line, const CalibrationPlan &plan, const TrainingProgress &progress, bool &found)
{
    const auto trained = progress.trainedS.find(line.name);
    if (trained != progress.trainedS.end()) {
        line.timeS = trained->second;
        line.note = TrainFigures::tr("Trained. Judged once all are.");
        line.state = ModelLine::State::Waiting;
        return;
    }
    const auto models = static_cast<double>(plan.models.size());
    const double done = progress.fraction / kComparisonTrainingShare * models;
    const auto finished = static_cast<double>(progress.trainedS.size());
    std::string running;
    for (const std::string &name : plan.models) {
        if (progress.trainedS.count(name) == 0) {
            running = name;
            break;
        }
    }
    if (line.name != running) {
        line.note = TrainFigures::tr("Waiting.");
        line.state = ModelLine::State::Waiting;
        return;
    }
    found = true;
    line.state = ModelLine::State::Running;
    line.progress = std::clamp(done - finished, 0.0, 1.0);
    line.note = TrainFigures::tr("Training on each set of runs.");
}

} // namespace

CentresData centresData(const PreparedCampaign &prepared, const CalibrationResult &result)
{
    CentresData data;
    const std::string name = result.model("rbf") != nullptr ? "rbf" : "rbf-paper";
    const TrainedModel *model = result.model(name);
    const auto *network = model != nullptr ? std::get_if<RbfNetwork>(&model->model) : nullptr;
    if (network == nullptr)
        return data;
    if (name == "rbf")
        data.selection = result.figures.rbfSelection;
    data.curve = modelCurve(*model);
    data.centres = rbfCentres(*network);
    data.centreCount = network->centreCount;
    data.runs = prepared.loaded.features.runs;
    data.referenceTemperatureC = result.figures.referenceTemperatureC;
    for (const char *other : {"linear", "cubic", "bpnn"}) {
        if (result.model(other) != nullptr)
            data.levels.push_back(
                {other, inPercent(meansOf(result.figures.rows, other, &ComparisonRow::excessOverFloor))});
    }
    return data;
}

ModelsTableData modelsData(const CalibrationPlan &plan, const CalibrationResult *result,
                           const TrainingProgress &progress, bool stopped)
{
    ModelsTableData data;
    const std::string recommended = result != nullptr ? recommendedOnMost(*result) : std::string();
    bool running = false;
    for (const std::string &name : listed(plan)) {
        ModelLine line;
        line.name = name;
        line.label = modelTitle(name, nullptr);
        line.inputs = modelInputs(name, plan.rbf.inputs);
        if (progress.running) {
            fillProgress(line, plan, progress, running);
        } else if (result != nullptr) {
            fillFigures(line, *result);
            line.recommended = name == recommended;
        }
        if (line.state == ModelLine::State::Waiting && line.note.isEmpty() && stopped) {
            line.state = ModelLine::State::Stopped;
            line.note = TrainFigures::tr("Cancelled before it was finished.");
        }
        data.models.push_back(std::move(line));
    }
    if (result != nullptr && !progress.running && !result->figures.rows.empty())
        data.floor =
            meansOf(result->figures.rows, result->figures.rows.front().model, &ComparisonRow::noiseFloor);
    return data;
}

} // namespace driftbench
