// How the pages call the models, and which one they show as the result.
#pragma once

#include "app/campaign/calibration_result.h"

#include <QString>

#include <array>
#include <string>
#include <string_view>

namespace driftbench {

// "RBF, 11 centres (Novel)"; model: null where it is not trained yet.
QString modelTitle(std::string_view name, const TrainedModel *model);
QString modelInputs(std::string_view name, const std::array<bool, 3> &rbfInputs);

// "rbf" where it was trained, else the first of the others that depends on temperature; empty without any.
std::string mainModelName(const CalibrationResult &result);

// "8 to 11": the centres that the axes use; "11" where all use as many.
QString centresText(const std::array<int, 3> &centres);

} // namespace driftbench
