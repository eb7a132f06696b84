// What comparison.json says: rows, verdicts, and the choice of the number of centres.
//
//   { "simulated", "judging", "reference_temperature_C",
//     "verdicts": [{ "axis", "verdict", "model", "gain", "gain_model_free", "reason" }],
//     "rbf_selection": { "left_out_runs",
//                        "x": { "chosen", "held_out_loss": [..], "training_loss": [..] }, "y", "z" } or null,
//     "rows": [{ "run", "axis", "model", "msd_before", "msd_after", "q", "noise_floor", "excess_over_floor",
//                "rms10s_dps", "samples" }] }
// A missing figure (null) reads as NaN. Errors: FileNotFound, FileUnreadable, ModelDamaged (not JSON, a field
// is missing or of another kind).
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/comparison.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct ComparisonFile
{
    bool simulated = false;
    std::string judging;
    double referenceTemperatureC = 0.0;
    std::vector<ComparisonRow> rows;
    std::array<AxisVerdict, 3> verdicts;
    std::optional<RbfSelection> rbfSelection;
};

Result<ComparisonFile> readComparisonFile(const std::filesystem::path &file);

} // namespace driftbench
