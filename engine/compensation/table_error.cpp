#include "engine/compensation/table_error.h"

#include "engine/compensation/table_apply.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace driftbench {

namespace {

constexpr int kPlacesACell = 16; // steps from one end to the other

// Whole millidegrees from one end of a cell to the other, the ends among them.
std::vector<std::int32_t> placesIn(const CompensationTable &table, Eigen::Index cell)
{
    std::vector<std::int32_t> places;
    const double from = 1000.0 * table.temperatureC(cell);
    const double to = 1000.0 * table.temperatureC(cell + 1);
    for (int step = 0; step <= kPlacesACell; ++step) {
        const auto milliC = static_cast<std::int32_t>(std::lround(from + (to - from) * step / kPlacesACell));
        const auto held = std::clamp(milliC, table.firstMilliC, table.lastMilliC);
        if (places.empty() || places.back() != held)
            places.push_back(held);
    }
    return places;
}

Eigen::MatrixX3d fixedTde(const FixedPointTable &fixed, const std::vector<std::int32_t> &milliC)
{
    Eigen::MatrixX3d tde(static_cast<Eigen::Index>(milliC.size()), 3);
    for (std::size_t i = 0; i < milliC.size(); ++i) {
        const auto units = tdeUnits(fixed, milliC[i]);
        for (std::size_t axis = 0; axis < units.size(); ++axis)
            tde(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis)) =
                units[axis] * fixed.dpsPerUnit();
    }
    return tde;
}

} // namespace

Eigen::MatrixX3d tableTde(const CompensationTable &table, const Eigen::VectorXd &temperatureC)
{
    return TableApply<double>(table).tde(temperatureC);
}

TableErrors measureTableErrors(const TrainedModel &model, const CompensationTable &table,
                               const FixedPointTable &fixed)
{
    const Eigen::Index cells = table.size() - 1;
    TableErrors errors;
    errors.interpolationDps.setZero(cells, 3);
    errors.fixedPointDps.setZero(cells, 3);
    errors.middleC.resize(cells);
    std::vector<std::int32_t> milliC;
    std::vector<Eigen::Index> firstOf;
    for (Eigen::Index cell = 0; cell < cells; ++cell) {
        errors.middleC[cell] = 0.5 * (table.temperatureC(cell) + table.temperatureC(cell + 1));
        firstOf.push_back(static_cast<Eigen::Index>(milliC.size()));
        const auto places = placesIn(table, cell);
        milliC.insert(milliC.end(), places.begin(), places.end());
    }
    firstOf.push_back(static_cast<Eigen::Index>(milliC.size()));
    Eigen::VectorXd temperatureC(static_cast<Eigen::Index>(milliC.size()));
    for (std::size_t i = 0; i < milliC.size(); ++i)
        temperatureC[static_cast<Eigen::Index>(i)] = milliC[i] / 1000.0;
    const Eigen::MatrixX3d wanted = predictAtTemperature(model, temperatureC).tdeDps;
    const Eigen::MatrixX3d real = (tableTde(table, temperatureC) - wanted).cwiseAbs();
    const Eigen::MatrixX3d whole = (fixedTde(fixed, milliC) - wanted).cwiseAbs();
    for (Eigen::Index cell = 0; cell < cells; ++cell) {
        const Eigen::Index first = firstOf[static_cast<std::size_t>(cell)];
        const Eigen::Index count = firstOf[static_cast<std::size_t>(cell) + 1] - first;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            if (!table.compensated[static_cast<std::size_t>(axis)])
                continue;
            errors.interpolationDps(cell, axis) = real.col(axis).segment(first, count).maxCoeff();
            errors.fixedPointDps(cell, axis) = whole.col(axis).segment(first, count).maxCoeff();
        }
    }
    return errors;
}

} // namespace driftbench
