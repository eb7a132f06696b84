// The exit codes of driftbench-cli: 0 to 2 here, the rest are the engine's error codes.
#pragma once

#include <string>

namespace driftbench::cli {

inline constexpr int kExitSuccess = 0;
inline constexpr int kExitUnexpected = 1;
inline constexpr int kExitUsage = 2;

// One line a code, for the help.
std::string exitCodeList();

} // namespace driftbench::cli
