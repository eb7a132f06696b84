// Places for labels in a margin, so that none covers another.
#pragma once

#include <vector>

namespace driftbench {

// Where labels at the wanted heights go so that no two are closer than `distance`, each as near to its own
// height as that allows, all within low..high as far as they fit. The order of the wanted heights is kept.
std::vector<double> pushedApart(const std::vector<double> &wanted, double distance, double low, double high);

} // namespace driftbench
