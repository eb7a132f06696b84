// The outcome of the experiment with dynamic quantities, as text and as JSON.
#pragma once

#include "engine/evaluation/dynamic_experiment.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace driftbench::cli {

std::string dynamicAsText(const std::vector<DynamicOutcome> &outcomes);
nlohmann::ordered_json dynamicToJson(const std::vector<DynamicOutcome> &outcomes);

} // namespace driftbench::cli
