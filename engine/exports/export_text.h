// What the text formats say alike: where a table or a set of parameters comes from, line by line.
#pragma once

#include "engine/compensation/compensation_table.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

// Text of a user in one line of a comment: control characters become spaces, and what would open or close a
// C comment, or form a trigraph, is pulled apart.
std::string forComment(std::string_view text);

// Sensor, model, ranges, runs, axes and why one is not compensated; SIMULATED first where it applies.
std::vector<std::string> provenanceLines(const TableProvenance &provenance,
                                         const std::array<bool, 3> &compensated);

// Each line after the prefix, with a line end.
std::string commented(const std::vector<std::string> &lines, std::string_view prefix);

// A float so that it reads back to the same float.
std::string shortestFloat(float value);

} // namespace driftbench
