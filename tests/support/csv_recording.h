// Reads the plain five-column CSVs of the shared data folder for tests that are not about reading files.
#pragma once

#include "engine/recording/recording.h"

#include <filesystem>

namespace driftbench::test {

Recording readPlainCsv(const std::filesystem::path &path);

} // namespace driftbench::test
