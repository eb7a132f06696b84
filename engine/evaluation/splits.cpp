#include "engine/evaluation/splits.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kBlocksPerSpan = 64.0;
constexpr double kSmallestBlockC = 4 * 0.26;

std::vector<std::string> namesOf(const TrainingSet &set)
{
    std::vector<std::string> names;
    for (const auto &run : set.runs)
        names.push_back(run->name);
    return names;
}

void addTraining(Splits &result, TrainingSet set)
{
    result.trainedOn.push_back(namesOf(set));
    result.trainings.push_back(std::move(set));
}

std::string listed(const std::vector<std::string> &names)
{
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

Splits leaveOneRunOut(const TrainingSet &set)
{
    Splits result;
    result.leftOutRuns = true;
    for (std::size_t i = 0; i < set.runs.size(); ++i) {
        addTraining(result, set.without(i));
        result.splits.push_back({set.runs[i]->name, set.runs[i], set.runs[i], i});
    }
    result.everything = result.trainings.size();
    addTraining(result, set);
    return result;
}

Splits temperatureBlocks(const TrainingSet &set)
{
    const auto &run = set.runs.front();
    const double lowest = run->deltaT.minCoeff();
    const double block = temperatureBlockC(run->deltaT.maxCoeff() - lowest);
    Splits result;
    result.blocks = true;
    for (int fold = 0; fold < kBlockFolds; ++fold) {
        const auto samples = static_cast<std::size_t>(run->deltaT.size());
        std::vector<std::uint8_t> held(samples);
        std::vector<std::uint8_t> kept(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            const double deltaT = run->deltaT[static_cast<Eigen::Index>(i)];
            const auto index = static_cast<std::int64_t>(std::floor((deltaT - lowest) / block));
            held[i] = index % kBlockFolds == fold ? 1 : 0;
            kept[i] = held[i] != 0 ? 0 : 1;
        }
        auto judged = std::make_shared<const RunFeatures>(partOf(*run, held));
        auto rest = std::make_shared<const RunFeatures>(partOf(*run, kept));
        if (judged->deltaT.size() < 2 || rest->curve.empty())
            continue;
        result.splits.push_back(
            {run->name + ", block " + std::to_string(fold + 1), judged, run, result.trainings.size()});
        addTraining(result, {{rest}, set.referenceTemperatureC});
    }
    result.everything = result.trainings.size();
    addTraining(result, set);
    return result;
}

Result<Splits> holdOutRuns(const TrainingSet &set, const std::vector<std::string> &holdOut)
{
    for (const std::string &name : holdOut) {
        if (std::none_of(set.runs.begin(), set.runs.end(),
                         [&](const auto &run) { return run->name == name; }))
            return Error{Errc::InvalidOption, "No run is called " + name +
                                                  " that should be held out; there are " +
                                                  listed(namesOf(set)) + "."};
    }
    Splits result;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < set.runs.size(); ++i) {
        const auto &run = set.runs[i];
        if (std::find(holdOut.begin(), holdOut.end(), run->name) == holdOut.end())
            kept.push_back(i);
        else
            result.splits.push_back({run->name, run, run, 0});
    }
    if (kept.empty())
        return Error{Errc::InvalidOption,
                     "All runs are held out and none is left to train on; hold out fewer runs."};
    addTraining(result, set.only(kept));
    return result;
}

} // namespace

double temperatureBlockC(double spanC)
{
    return std::max(spanC / kBlocksPerSpan, kSmallestBlockC);
}

RunFeatures partOf(const RunFeatures &run, const std::vector<std::uint8_t> &keep)
{
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i] != 0)
            rows.push_back(static_cast<Eigen::Index>(i));
    }
    RunFeatures part;
    part.name = run.name;
    part.timeS = run.timeS(rows);
    part.deltaT = run.deltaT(rows);
    part.tdeDps = run.tdeDps(rows, Eigen::all);
    part.points = run.points.rows(rows);
    part.usableForTraining.reserve(rows.size());
    for (Eigen::Index row = 0; row < part.deltaT.size(); ++row) {
        const auto from = static_cast<std::size_t>(rows[static_cast<std::size_t>(row)]);
        part.usableForTraining.push_back(run.usableForTraining[from]);
        if (run.usableForTraining[from] != 0)
            part.addTo(part.curve, row);
    }
    return part;
}

Result<Splits> makeSplits(const TrainingSet &set, const std::vector<std::string> &holdOut)
{
    for (const auto &run : set.runs) {
        if (run->deltaT.size() < 2 || run->curve.empty())
            return Error{Errc::NothingUsable,
                         "Run " + run->name + " has no usable samples; leave it out or look at its mask."};
    }
    if (set.runs.empty())
        return Error{Errc::NothingUsable, "There is no run to train on; give at least one."};
    if (!holdOut.empty())
        return holdOutRuns(set, holdOut);
    return set.runs.size() == 1 ? temperatureBlocks(set) : leaveOneRunOut(set);
}

} // namespace driftbench
