// What a session holds, to be read or as JSON.
#pragma once

#include "app/session/session.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace driftbench::cli {

std::string sessionAsText(const Session &session);
nlohmann::ordered_json sessionAsJson(const Session &session);

} // namespace driftbench::cli
