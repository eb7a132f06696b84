// The sentence for a file that can't be written, from the system's error number: OutputFull where no room is
// left, else OutputNotWritable.
#pragma once

#include "engine/base/result.h"

#include <filesystem>

namespace driftbench {

Error outputError(const std::filesystem::path &target, int errorNumber);

} // namespace driftbench
