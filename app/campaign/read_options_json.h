// How a log is read (ReadOptions) as a JSON object, for whatever keeps it.
#pragma once

#include "engine/formats/read_options.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace driftbench {

nlohmann::ordered_json readOptionsToJson(const ReadOptions &read);
// Nothing where the object is of another shape.
std::optional<ReadOptions> readOptionsFromJson(const nlohmann::ordered_json &json);

} // namespace driftbench
