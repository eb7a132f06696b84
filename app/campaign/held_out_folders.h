// Where a fit keeps the models that were trained without a run: held-out/<folder>/<model>.json.
#pragma once

#include <string>
#include <vector>

namespace driftbench {

// Folders below held-out for the folds of these names, each another: the name itself where it can be the name
// of a folder.
std::vector<std::string> heldOutFolders(const std::vector<std::string> &foldNames);

} // namespace driftbench
