// How far a table is from the model that it was made from, cell by cell: what interpolation costs, and what
// fixed point costs on top. Measured at whole millidegrees, about fifteen inside each cell and at its ends.
#pragma once

#include "engine/compensation/compensation_table.h"
#include "engine/compensation/fixed_point_table.h"

#include <Eigen/Core>

namespace driftbench {

struct TableErrors
{
    // n - 1 rows for n knots: cell i lies between knots i and i + 1. dps, largest absolute value in the cell;
    // 0 for an axis that is not compensated.
    Eigen::MatrixX3d interpolationDps; // of the table in real numbers against the model
    Eigen::MatrixX3d fixedPointDps;    // of the fixed-point table against the model
    Eigen::VectorXd middleC;           // of each cell

    double worstDps(Eigen::Index cell) const { return fixedPointDps.row(cell).maxCoeff(); }
};

TableErrors measureTableErrors(const TrainedModel &model, const CompensationTable &table,
                               const FixedPointTable &fixed);

// What a table says at a temperature, held at its ends. N -> N x 3, dps.
Eigen::MatrixX3d tableTde(const CompensationTable &table, const Eigen::VectorXd &temperatureC);

} // namespace driftbench
