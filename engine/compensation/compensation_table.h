// The temperature drift error as a table over temperature, made from any model of temperature alone.
//
// Knots: n rows of tde (dps) for x, y, z at
//   T_i = first + i (last - first) / (n - 1)     i = 0 .. n - 1
// where first and last are the ends of the trained range, rounded outwards to whole millidegrees, so that
// float and fixed-point tables share one grid exactly. Between knots the value is interpolated linearly,
// outside the value of the nearest end is held. An axis that is not compensated has zeros.
//
// Number of knots: about the smallest whose interpolation error stays below the bound. The error is measured
// against the model at seven points inside every cell, and more densely, down to distances of 1e-6 of a
// cell, around the reference temperature, where the signed root of dT has an infinite slope. What lies
// between the measured points is covered by a factor: a parabola's largest error is met exactly (the middle
// of a cell is among the points), a cubic's to within 2 %; 1.25 leaves room for features narrower than that.
// A uniform grid with knots at both ends has, in general, none at the reference temperature. A root of weight
// 1 that changes sign inside a cell of width h is then off by 0.18 sqrt(h) in the middle of the cell, 0.25
// sqrt(h) at a knot and up to 0.37 sqrt(h) between: so, of the sizes within 3 % of each other, the one is
// taken that puts the reference temperature closest to the middle of a cell.
//
// Errors: ModelNotUsableHere (no trained range, or the model gives no finite number), InvalidOption (a bound
// that can't be met with the allowed number of knots; names the one that can).
#pragma once

#include "engine/base/result.h"
#include "engine/models/trained_model.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// Where a table comes from: what its user must know before trusting it.
struct TableProvenance
{
    std::string modelName;
    SensorIdentity sensor;
    double referenceTemperatureC = 0.0;
    double lowestTemperatureC = 0.0; // trained range
    double highestTemperatureC = 0.0;
    bool simulated = false;
    std::vector<std::string> trainedOn;
    std::string judging;
    std::array<std::optional<Verdict>, 3> verdicts;
    std::array<std::string, 3> reasons;
};

TableProvenance provenanceOf(const TrainedModel &model);

struct CompensationTable
{
    std::int32_t firstMilliC = 0;
    std::int32_t lastMilliC = 0;
    Eigen::MatrixX3d tdeDps;                 // n x 3, n >= 2
    std::array<bool, 3> compensated{};       // false: zeros
    double measuredErrorDps = 0.0;           // largest interpolation error that was measured, over the axes
    double interpolationErrorBoundDps = 0.0; // stated bound, at least the measured error with its factor
    TableProvenance provenance;

    Eigen::Index size() const { return tdeDps.rows(); }
    double firstTemperatureC() const { return firstMilliC / 1000.0; }
    double lastTemperatureC() const { return lastMilliC / 1000.0; }
    double stepC() const { return (lastMilliC - firstMilliC) / (1000.0 * static_cast<double>(size() - 1)); }
    double temperatureC(Eigen::Index knot) const;
};

struct TableOptions
{
    static constexpr double kDefaultErrorDps = 0.001;
    static constexpr int kKnotLimit = 32768;
    // 2 x 500 degrees: leaves room for the products of the fixed-point table.
    static constexpr std::int32_t kLargestSpanMilliC = 1000000;

    // Unset: kDefaultErrorDps, or what the largest table reaches where the model is too steep for that.
    std::optional<double> maxInterpolationErrorDps{};
    int largestKnotCount = 4097; // 2 .. kKnotLimit
};

Result<CompensationTable> makeCompensationTable(const TrainedModel &model,
                                                const std::array<bool, 3> &compensated,
                                                const TableOptions &options = {});

// Is the model's trained range one that a table or an autopilot can cover, and its output finite there?
Status checkTabulable(const TrainedModel &model);

} // namespace driftbench
