// Where the Gaussians of an RBF network stand on the temperature axis, and how wide they are there. The
// network keeps both in the space of its standardised inputs; a centre of temperature d and half width w
// (degrees) has there the width sigma = |phi(d + w) - phi(d - w)| / 2, which is solved for w.
#pragma once

#include "engine/models/rbf_network.h"

#include <vector>

namespace driftbench {

struct RbfCentre
{
    double deltaT = 0.0;      // degrees Celsius
    double widthDeltaT = 0.0; // one sigma, degrees Celsius
};

// In the order of the network: axis a uses the first network.centreCount[a] of them.
std::vector<RbfCentre> rbfCentres(const RbfNetwork &network);

} // namespace driftbench
