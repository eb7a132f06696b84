// The flash of a simulated board as a file: both banks, one behind the other.
#pragma once

#include "device/ram_flash.h"
#include "engine/base/result.h"

#include <filesystem>

namespace driftbench {

// A file that is not there: an erased flash. FileUnreadable; InvalidOption if it is of another size.
Status loadFlash(RamFlash &flash, const std::filesystem::path &file);

// As a whole or not at all. Errors of atomic_file.h.
Status saveFlash(RamFlash &flash, const std::filesystem::path &file);

} // namespace driftbench
