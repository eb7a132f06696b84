// Set-point and measured temperature of a chamber, for the estimate of its lag: both columns of a CSV, or the
// temperature of any log and a plan that started with it. Columns that are not named are found by spelling;
// rates are not needed.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/physics/test_plan.h"

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace driftbench::cli {

struct SetpointColumns
{
    std::string time;
    std::string temperature;
    std::string setpoint; // empty: the plan says
};

struct SetpointLog
{
    std::vector<ProfileStep> setpoint;
    Eigen::VectorXd timeS;
    Eigen::VectorXd temperatureC;
};

// Samples without a temperature or set-point are left out. Errors as readLog says, and TooFewSamples.
Result<SetpointLog> readSetpointLog(const std::filesystem::path &file, const SetpointColumns &columns,
                                    const TestPlan &plan, const ProgressHook &hook);

} // namespace driftbench::cli
