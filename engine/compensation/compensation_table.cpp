#include "engine/compensation/compensation_table.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr int kPointsInCell = 8; // a cell's knot and seven points inside
constexpr double kSafetyFactor = 1.25;
constexpr int kProbeRows = 2001;
constexpr double kLargestTemperatureC = TableOptions::kLargestSpanMilliC / 2000.0;
// No gyro drifts by this much; larger figures come from a model that ran away.
constexpr double kLargestTdeDps = 1e6;

struct Grid
{
    std::int32_t firstMilliC;
    std::int32_t lastMilliC;
    int cells;

    double temperatureC(double position) const
    {
        return firstMilliC / 1000.0 + position * (lastMilliC - firstMilliC) / (1000.0 * cells);
    }
    double position(double temperatureC) const
    {
        return (temperatureC - firstMilliC / 1000.0) * (1000.0 * cells) / (lastMilliC - firstMilliC);
    }
};

class Tabulator
{
public:
    Tabulator(const TrainedModel &model, const std::array<bool, 3> &compensated)
        : m_model(model), m_compensated(compensated)
    {
    }

    Eigen::MatrixX3d values(const Grid &grid, const Eigen::VectorXd &positions) const;
    Eigen::MatrixX3d knots(const Grid &grid) const
    {
        return values(grid, Eigen::VectorXd::LinSpaced(grid.cells + 1, 0.0, grid.cells));
    }
    double largestError(const Grid &grid, const Eigen::MatrixX3d &knots) const;

private:
    Eigen::VectorXd probes(const Grid &grid) const;

    const TrainedModel &m_model;
    const std::array<bool, 3> &m_compensated;
};

Eigen::MatrixX3d Tabulator::values(const Grid &grid, const Eigen::VectorXd &positions) const
{
    const Eigen::VectorXd temperatureC =
        positions.unaryExpr([&](double position) { return grid.temperatureC(position); });
    Eigen::MatrixX3d tde = predictAtTemperature(m_model, temperatureC).tdeDps;
    for (std::size_t axis = 0; axis < m_compensated.size(); ++axis) {
        if (!m_compensated[axis])
            tde.col(static_cast<Eigen::Index>(axis)).setZero();
    }
    return tde;
}

Eigen::VectorXd Tabulator::probes(const Grid &grid) const
{
    std::vector<double> positions;
    for (int cell = 0; cell < grid.cells; ++cell) {
        for (int k = 1; k < kPointsInCell; ++k)
            positions.push_back(cell + k / static_cast<double>(kPointsInCell));
    }
    const double kink = grid.position(m_model.referenceTemperatureC);
    for (const double side : {-1.0, 1.0}) {
        for (double distance = 1.0; distance > 1e-6; distance *= 0.8)
            positions.push_back(kink + side * distance);
    }
    positions.push_back(kink);
    // The ends of the trained range need not be knots: those are rounded outwards.
    positions.push_back(grid.position(m_model.lowestTemperatureC));
    positions.push_back(grid.position(m_model.highestTemperatureC));
    std::erase_if(positions, [&](double position) { return position < 0.0 || position > grid.cells; });
    return Eigen::Map<const Eigen::VectorXd>(positions.data(), static_cast<Eigen::Index>(positions.size()));
}

double Tabulator::largestError(const Grid &grid, const Eigen::MatrixX3d &knots) const
{
    const Eigen::VectorXd positions = probes(grid);
    const Eigen::MatrixX3d truth = values(grid, positions);
    double largest = 0.0;
    for (Eigen::Index i = 0; i < positions.size(); ++i) {
        const Eigen::Index cell =
            std::min<Eigen::Index>(static_cast<Eigen::Index>(positions[i]), grid.cells - 1);
        const double fraction = positions[i] - static_cast<double>(cell);
        const Eigen::RowVector3d line = (1.0 - fraction) * knots.row(cell) + fraction * knots.row(cell + 1);
        largest = std::max(largest, (truth.row(i) - line).cwiseAbs().maxCoeff());
    }
    return largest;
}

struct Fitted
{
    Grid grid;
    Eigen::MatrixX3d knots;
    double errorDps;

    bool within(double boundDps) const { return errorDps * kSafetyFactor <= boundDps; }
};

Fitted tabulate(const Tabulator &tabulator, Grid grid, int cells)
{
    grid.cells = cells;
    Fitted fitted{grid, tabulator.knots(grid), 0.0};
    fitted.errorDps = tabulator.largestError(grid, fitted.knots);
    return fitted;
}

// The size of about 97 to 100 % of `cells` whose grid has the reference temperature nearest to the middle of
// a cell. At an end of the table, or outside, there is nothing to align.
int aligned(const Grid &range, int cells, double referenceTemperatureC)
{
    const double share = range.position(referenceTemperatureC);
    if (!(share * cells >= 1.0) || !(share * cells <= cells - 1.0))
        return cells;
    const auto offCentre = [share](int size) {
        const double position = share * size;
        return std::abs(position - std::floor(position) - 0.5);
    };
    int best = cells;
    for (int size = cells - cells / 32; size < cells; ++size) {
        if (offCentre(size) < offCentre(best))
            best = size;
    }
    return best;
}

// About the smallest grid within the bound; the one with the smallest error if there is none.
Fitted search(const Tabulator &tabulator, const Grid &range, int largestCells, double boundDps,
              double referenceTemperatureC)
{
    int cells = 1;
    Fitted best = tabulate(tabulator, range, cells);
    while (!best.within(boundDps) && cells < largestCells) {
        cells = std::min(2 * cells, largestCells);
        Fitted next = tabulate(tabulator, range, aligned(range, cells, referenceTemperatureC));
        if (next.errorDps < best.errorDps)
            best = std::move(next);
    }
    // Between the last size that was too small and this one, in steps of about 3 %.
    for (int smaller = cells / 2 + 1; best.within(boundDps) && smaller < best.grid.cells;
         smaller += std::max(1, smaller / 32)) {
        Fitted next = tabulate(tabulator, range, aligned(range, smaller, referenceTemperatureC));
        if (next.within(boundDps))
            return next;
    }
    return best;
}

Status checkOptions(const TableOptions &options)
{
    if (options.largestKnotCount < 2 || options.largestKnotCount > TableOptions::kKnotLimit) {
        return Error{Errc::InvalidOption, "A table of at most " + std::to_string(options.largestKnotCount) +
                                              " knots can't be made; choose a number between 2 and " +
                                              std::to_string(TableOptions::kKnotLimit) + "."};
    }
    const double bound = options.maxInterpolationErrorDps.value_or(TableOptions::kDefaultErrorDps);
    if (!(bound > 0.0) || !std::isfinite(bound)) {
        return Error{Errc::InvalidOption,
                     "The largest interpolation error must be a number above 0 dps, not " + shortest(bound) +
                         "."};
    }
    return {};
}

Error boundNotReached(const TrainedModel &model, double boundDps, int largestCells, const Fitted &best)
{
    // Rounded up, so that the named bound can be typed in and is met.
    const double reachable = std::ceil(best.errorDps * kSafetyFactor * 1e6) / 1e6;
    return {Errc::InvalidOption, "A table of model " + model.name + " with up to " +
                                     std::to_string(largestCells + 1) +
                                     " knots can't keep the interpolation error below " + shortest(boundDps) +
                                     " dps; ask for " + shortest(reachable) + " dps or allow more knots."};
}

} // namespace

double CompensationTable::temperatureC(Eigen::Index knot) const
{
    return knot == size() - 1 ? lastTemperatureC()
                              : firstTemperatureC() + static_cast<double>(knot) * stepC();
}

TableProvenance provenanceOf(const TrainedModel &model)
{
    return {model.name,
            model.sensor,
            model.referenceTemperatureC,
            model.lowestTemperatureC,
            model.highestTemperatureC,
            model.simulated,
            model.trainedOn,
            model.judging,
            model.verdicts,
            model.reasons};
}

Status checkTabulable(const TrainedModel &model)
{
    const double low = model.lowestTemperatureC;
    const double high = model.highestTemperatureC;
    if (!(low < high) || !(low >= -kLargestTemperatureC) || !(high <= kLargestTemperatureC)) {
        return Error{Errc::ModelNotUsableHere, "Model " + model.name + " has no usable trained range (" +
                                                   shortest(low) + " to " + shortest(high) +
                                                   " \u00b0C); train it on runs that span some degrees."};
    }
    const Eigen::VectorXd temperatureC = Eigen::VectorXd::LinSpaced(kProbeRows, low, high);
    const Eigen::MatrixX3d tde = predictAtTemperature(model, temperatureC).tdeDps;
    for (Eigen::Index i = 0; i < tde.rows(); ++i) {
        if (!(tde.row(i).array().abs() < kLargestTdeDps).all()) {
            return Error{Errc::ModelNotUsableHere, "Model " + model.name + " gives no usable rate at " +
                                                       forReading(temperatureC[i], 2) +
                                                       " \u00b0C; train it again."};
        }
    }
    return {};
}

Result<CompensationTable> makeCompensationTable(const TrainedModel &model,
                                                const std::array<bool, 3> &compensated,
                                                const TableOptions &options)
{
    if (const Status status = checkOptions(options); !status)
        return status.error();
    if (const Status status = checkTabulable(model); !status)
        return status.error();

    const Grid range{static_cast<std::int32_t>(std::floor(model.lowestTemperatureC * 1000.0)),
                     static_cast<std::int32_t>(std::ceil(model.highestTemperatureC * 1000.0)), 1};
    // No cell is narrower than the millidegree in which the fixed-point table counts.
    const int largestCells = std::min(options.largestKnotCount - 1, range.lastMilliC - range.firstMilliC);
    const double bound = options.maxInterpolationErrorDps.value_or(TableOptions::kDefaultErrorDps);
    const Fitted fitted =
        search(Tabulator(model, compensated), range, largestCells, bound, model.referenceTemperatureC);
    if (!fitted.within(bound) && options.maxInterpolationErrorDps)
        return boundNotReached(model, bound, largestCells, fitted);

    CompensationTable table;
    table.firstMilliC = range.firstMilliC;
    table.lastMilliC = range.lastMilliC;
    table.tdeDps = fitted.knots;
    table.compensated = compensated;
    table.measuredErrorDps = fitted.errorDps;
    table.interpolationErrorBoundDps = std::max(bound, fitted.errorDps * kSafetyFactor);
    table.provenance = provenanceOf(model);
    return table;
}

} // namespace driftbench
