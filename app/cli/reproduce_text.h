// What `reproduce` prints, for a terminal of kReproduceColumns columns.
#pragma once

#include "app/cli/reproduction.h"

#include <string>

namespace driftbench::cli {

inline constexpr std::size_t kReproduceColumns = 120;

std::string reproductionToText(const Reproduction &reproduction);

} // namespace driftbench::cli
