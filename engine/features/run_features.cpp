#include "engine/features/run_features.h"

namespace driftbench {

TrainingSet TrainingSet::without(std::size_t run) const
{
    TrainingSet rest{{}, referenceTemperatureC};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (i != run)
            rest.runs.push_back(runs[i]);
    }
    return rest;
}

TrainingSet TrainingSet::only(const std::vector<std::size_t> &kept) const
{
    TrainingSet some{{}, referenceTemperatureC};
    for (const std::size_t i : kept)
        some.runs.push_back(runs[i]);
    return some;
}

RunFeatures makeRunFeatures(const Run &run, double referenceTemperatureC)
{
    const Recording &recording = *run.recording;
    const Eigen::Index usable = run.mask.countUsableForJudging();
    RunFeatures features;
    features.name = run.name;
    features.timeS.resize(usable);
    features.deltaT.resize(usable);
    features.tdeDps.resize(usable, 3);
    features.usableForTraining.reserve(static_cast<std::size_t>(usable));
    std::vector<Eigen::Index> trainingRows;
    trainingRows.reserve(static_cast<std::size_t>(usable));
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (!run.mask.usableForJudging(i))
            continue;
        features.timeS[row] = recording.timeS[i];
        features.deltaT[row] = recording.temperatureC[i] - referenceTemperatureC;
        features.tdeDps.row(row) = recording.rateDps.row(i) - run.referenceRateDps.transpose();
        const bool train = run.mask.usableForTraining(i);
        features.usableForTraining.push_back(train ? 1 : 0);
        if (train)
            trainingRows.push_back(row);
        ++row;
    }
    features.curve.add(features.deltaT(trainingRows), features.tdeDps(trainingRows, Eigen::all));
    return features;
}

TrainingSet makeTrainingSet(const Campaign &campaign, double referenceTemperatureC)
{
    TrainingSet set{{}, referenceTemperatureC};
    for (const Run &run : campaign.runs)
        set.runs.push_back(std::make_shared<const RunFeatures>(makeRunFeatures(run, referenceTemperatureC)));
    return set;
}

} // namespace driftbench
