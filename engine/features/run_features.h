// A run made ready for training and judging: time, dT and TDE of its usable samples.
//
// Of a long recording a row is the mean of several samples (block_means.h); counts, thermal curves and mean
// squares are of the samples all the same.
//
// TDE = measured rate - reference rate (dps). dT = T - Tref with the campaign's one reference temperature.
#pragma once

#include "engine/base/result.h"
#include "engine/features/thermal_curve.h"
#include "engine/recording/run.h"

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct RunFeatures
{
    std::string name;
    Eigen::VectorXd timeS;                       // M samples usable for judging
    Eigen::VectorXd deltaT;                      // M, degrees Celsius from the reference temperature
    Eigen::MatrixX3d tdeDps;                     // M x 3
    std::vector<std::uint8_t> usableForTraining; // M, 0 for outliers of the noise
    PointSamples points{};                       // M; no rows: each row is one sample
    ThermalCurve curve;                          // of the samples usable for training

    std::int64_t samples() const; // of all rows
    void addTo(ThermalCurve &cells, Eigen::Index row) const;
    // Mean over all samples of the squares of what is left of them; residualDps: M x 3, of the rows.
    Eigen::Vector3d meanSquare(const Eigen::MatrixX3d &residualDps) const;
};

// What every trainer gets: runs of one sensor over one reference temperature.
struct TrainingSet
{
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    double referenceTemperatureC = 0.0;

    // The same campaign without, or with only, some of its runs.
    TrainingSet without(std::size_t run) const;
    TrainingSet only(const std::vector<std::size_t> &kept) const;
};

// One reference temperature for the campaign: the mean T of the initial hold where the runs share it (their
// holds' means agree within 1 degree), else the lowest usable temperature, or `given`.
double chooseReferenceTemperature(const Campaign &campaign, std::optional<double> given);

RunFeatures makeRunFeatures(const Run &run, double referenceTemperatureC);

// All runs of the campaign.
TrainingSet makeTrainingSet(const Campaign &campaign, double referenceTemperatureC);

} // namespace driftbench
