// What the program prints: results on standard output, everything else on standard error.
#pragma once

#include "engine/base/result.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace driftbench::cli {

inline constexpr std::string_view kProgramName = "driftbench-cli";

void printError(std::string_view sentence);  // "driftbench-cli: ..."
void printNotice(std::string_view sentence); // the same, for what is not wrong but worth knowing

// To standard output; an error if that can't be written to, such as a file on a full disk.
Status printResult(std::string_view text);
Status printJson(const nlohmann::ordered_json &json);

} // namespace driftbench::cli
