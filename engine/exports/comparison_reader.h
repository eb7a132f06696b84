// comparison.json (comparison_files.h) read back: what a comparison found, without what it was made from.
//
// A missing figure (null) reads as NaN; what files of the first version do not have is empty. Errors:
// FileNotFound, FileUnreadable, ModelDamaged (not JSON, a field is missing or of another kind).
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

struct ReadComparison
{
    bool simulated = false;
    std::string judging;
    std::uint64_t seed = 0;
    std::vector<std::string> holdOut; // empty: each run was left out in turn
    double referenceTemperatureC = 0.0;
    std::vector<ComparisonRow> rows;
    std::array<AxisVerdict, 3> verdicts;
    std::optional<RbfSelection> rbfSelection;
    Hysteresis hysteresis;
    Eigen::Vector3d repeatRmsDps = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    Eigen::Vector3d curveRmsDps = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    std::vector<std::string> warnings;
};

// name: where the text comes from, for messages.
Result<ReadComparison> comparisonFromJson(std::string_view json, const std::string &name);
Result<ReadComparison> readComparisonFile(const std::filesystem::path &file);

} // namespace driftbench
