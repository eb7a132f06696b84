// Samples that are selected in one plot and shown in all: stretches of time of the runs. A selection that was
// made by temperature or by value is the stretches in which all dots match.
#pragma once

#include "app/gui/inspect/inspection_data.h"

#include <functional>
#include <vector>

namespace driftbench {

struct SelectedStretch
{
    std::size_t run = 0;
    double startS = 0.0; // in the run's time
    double endS = 0.0;
};
using Selection = std::vector<SelectedStretch>;

Selection selectionOfStrip(const InspectionData &seen, double startS, double endS); // seconds of the strip

// By a property of the drawn dots.
Selection selectionWhere(const InspectionData &seen,
                         const std::function<bool(double deltaT, const Eigen::Vector3d &tdeDps)> &matches);

struct SelectedDots
{
    std::vector<std::size_t> run;
    std::vector<double> timeS; // in the run's time
    Eigen::VectorXd deltaT;
    Eigen::MatrixX3d tdeDps;
};
SelectedDots dotsIn(const InspectionData &seen, const Selection &selection);

} // namespace driftbench
