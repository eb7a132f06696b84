// Programs of Driftbench that lie beside this one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace driftbench::cli {

// The program of that name in this program's folder; nothing if there is none or the folder is not known.
std::optional<std::filesystem::path> siblingProgram(const std::string &name);

// Runs it to its end without a word. Its exit code, -1 if it did not
// start or was ended by a signal.
int runQuietly(const std::filesystem::path &program, const std::vector<std::string> &arguments);

} // namespace driftbench::cli
