// The 95 % band of the curve, from the residuals of leave-one-run-out.
//
// Each held-out run's residual (its mean TDE minus the model that never saw it) is taken in 64 bins of dT,
// averaged over +-5 degrees with weight n / (1 + n / median n), then squared; with k runs in a bin
// s^2 = (k - 1) / k^2 * sum e^2, again averaged over +-5 degrees. A new run's curve lies within
// +- t_{k-1, 0.975} sqrt(s^2 (1 + 1/k)); for a new sample (1.96 sigma)^2 is added in quadrature.
// The noise is not subtracted. Two runs leave one degree of freedom, t = 12.7: that is no band.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"

#include <vector>

namespace driftbench {

// heldOutModels[i] was trained without set.runs[i], of which there are two or more. `runs` of the band is the
// most that share a bin. With fewer than three runs the curve's half width is NaN and the sample's is of
// noise only; else both are NaN in bins that fewer than three runs reach.
UncertaintyBand uncertaintyBand(const TrainingSet &set, const std::vector<AnyModel> &heldOutModels);

} // namespace driftbench
