// Which axes of a model may be compensated: those whose verdict is yes, the others only by force.
//
// Nothing asked, no force: every axis with a yes; the rest is left out, and a note says why. None with a yes:
// an error. Axes asked for: each must have a yes. With force: what was asked for, or all three axes.
// Errors: VerdictForbids with the verdict and its reason; InvalidOption if no axis was asked for.
#pragma once

#include "engine/base/result.h"
#include "engine/models/trained_model.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct AxisSelection
{
    std::array<bool, 3> compensated{};
    std::vector<std::string> notes; // axes left out or forced, each a sentence
};

Result<AxisSelection> selectAxes(const TrainedModel &model,
                                 const std::optional<std::array<bool, 3>> &wanted = std::nullopt,
                                 bool force = false);

// "yes", ..., or "never judged".
std::string verdictText(const std::optional<Verdict> &verdict);

} // namespace driftbench
