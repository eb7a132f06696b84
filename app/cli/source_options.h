// Options about the source to record from, for commands that record.
#pragma once

#include "app/cli/device_choice.h"
#include "engine/physics/test_plan.h"

#include <functional>
#include <optional>

namespace driftbench::cli {

struct SourceArguments
{
    std::string source;
    std::vector<std::string> usbIds;
    double rateHz = 0.0;
    double rangeDps = 0.0;
    std::string thermometer;
    bool compensate = false;
    std::optional<double> speed;
    std::optional<std::string> profile;
    std::optional<Eigen::Vector3d> referenceRateDps;
    // Of one kind of source; naming one for another kind is an error.
    struct ForKind
    {
        std::string option;
        std::string kind; // "simulated", as the choice's text begins
        std::function<void(SourceChoice &)> set;
    };
    std::vector<ForKind> given;
    ReadOptions read;
    std::vector<const CLI::Option *> readOptions; // those that fill `read`
};

void addSourceOptions(CLI::App &command, SourceArguments &arguments);

// InvalidOption. The chamber of the simulated bridge follows the plan, and its sampling rate is that of all
// sources but files unless one is given.
Result<SourceChoice> sourceChoiceOf(const SourceArguments &arguments, const std::optional<TestPlan> &plan);

} // namespace driftbench::cli
