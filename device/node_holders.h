// Who else has a device's node open.
#pragma once

#include <filesystem>

namespace driftbench {

// Whether a program other than this one has the file open, as /proc tells: root of all programs, a user of
// the user's own. Where /proc tells nothing: false. Takes a few milliseconds.
bool isHeldElsewhere(const std::filesystem::path &node);

} // namespace driftbench
