// What `reproduce` prints, for a terminal of kTextColumns columns (text_layout.h).
#pragma once

#include "app/cli/reproduction.h"

#include <string>

namespace driftbench::cli {

std::string reproductionToText(const Reproduction &reproduction);

} // namespace driftbench::cli
