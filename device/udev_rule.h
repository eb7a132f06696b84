// Where the udev rule lies that permits the user at the screen to open the devices, and what to do with it.
#pragma once

#include <filesystem>
#include <string>

namespace driftbench {

// One sentence, to follow another one behind a semicolon. If the rule lies where udev reads it, it only has
// to be brought into force; else it is named where it lies beside the program: in the folder that it was
// installed into, or among the sources that it was built from.
//
// root: where the folders of udev are looked for; program: the running program's file, empty: not known.
std::string udevRuleHint(const std::filesystem::path &root, const std::filesystem::path &program);

// On this computer, for this program.
std::string udevRuleHint();

} // namespace driftbench
