// What `reproduce` writes: tables.md to be read, tables.csv (a line a cell) and tables.json at full
// precision.
#pragma once

#include "app/cli/reproduction.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace driftbench::cli {

nlohmann::ordered_json reproductionToJson(const Reproduction &reproduction);
std::string reproductionToCsv(const Reproduction &reproduction);
std::string reproductionToMarkdown(const Reproduction &reproduction);

// All three into the folder, all or none. Errc: OutputNotWritable, OutputFull.
Status writeReproduction(const Reproduction &reproduction, const std::filesystem::path &folder);

} // namespace driftbench::cli
