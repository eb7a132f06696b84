// How many numbers a model learned: its size, for whoever weighs models against each other.
#pragma once

#include "engine/models/trained_model.h"

namespace driftbench {

// All three axes. Of an RBF network: the weights that its axes use, place and width of each centre, constants
// and linear terms. Figures of the standardisation and fixed centres of polynomials are not learned.
int parameterCount(const AnyModel &model);

} // namespace driftbench
