#include "engine/features/run_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

static void fillCurve(RunFeatures &run)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < run.deltaT.size(); ++i) {
        if (run.usableForTraining[static_cast<std::size_t>(i)] != 0)
            lowest = std::min(lowest, run.deltaT[i]);
    }
    if (std::isfinite(lowest))
        run.curve.makeRoomFrom(lowest);
    for (Eigen::Index i = 0; i < run.deltaT.size(); ++i) {
        if (run.usableForTraining[static_cast<std::size_t>(i)] != 0)
            run.addTo(run.curve, i);
    }
}

std::int64_t RunFeatures::samples() const
{
    return points.empty() ? timeS.size() : points.samples.cast<std::int64_t>().sum();
}

void RunFeatures::addTo(ThermalCurve &cells, Eigen::Index row) const
{
    const Eigen::Vector3d tde = tdeDps.row(row).transpose();
    if (points.empty())
        cells.add(deltaT[row], tde);
    else
        cells.add(deltaT[row], tde, points.countAt(row), points.varianceAt(row));
}

Eigen::Vector3d RunFeatures::meanSquare(const Eigen::MatrixX3d &residualDps) const
{
    if (points.empty())
        return residualDps.colwise().squaredNorm().transpose() / static_cast<double>(residualDps.rows());
    const Eigen::VectorXd count = points.samples.cast<double>();
    const Eigen::MatrixX3d squares = residualDps.cwiseAbs2() + points.varianceDps2.cast<double>();
    return squares.transpose() * count / count.sum();
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
    std::vector<Eigen::Index> usableRows;
    usableRows.reserve(static_cast<std::size_t>(usable));
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (!run.mask.usableForJudging(i))
            continue;
        features.timeS[row] = recording.timeS[i];
        features.deltaT[row] = recording.temperatureC[i] - referenceTemperatureC;
        features.tdeDps.row(row) = recording.rateDps.row(i) - run.referenceRateDps.transpose();
        features.usableForTraining.push_back(run.mask.usableForTraining(i) ? 1 : 0);
        usableRows.push_back(i);
        ++row;
    }
    features.points = recording.points.rows(usableRows);
    fillCurve(features);
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
