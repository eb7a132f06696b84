// Would dynamic quantities (dT/dt, lag) help? An experiment beside the comparison: its outcome is reported,
// never exported and never recommended.
//
// Each fold's model g of temperature alone gets two linear terms,  tde = g(dT) + a dT/dt + b (T -
// lowpass(T)), a and b by least squares on the training runs' residuals, per axis. The low-pass' time
// constant is the one, of those tried, that leaves least on training runs left out of the fit of a and b. The
// held-out run took no part in any of it. Folds of a single run are not tried: its blocks of temperature are
// no stretch of time.
#pragma once

#include "engine/evaluation/comparison.h"

#include <string>
#include <vector>

namespace driftbench {

struct DynamicExperimentOptions
{
    std::string model = "rbf"; // to which the terms are added
    double rateWindowS = 60.0;
    std::vector<double> lagTimeConstantsS{30.0, 100.0, 300.0, 1000.0};
};

struct DynamicOutcome
{
    std::string run;
    int axis = 0;
    double msdStatic = 0.0;  // dps^2, of the model alone on the held-out run
    double msdDynamic = 0.0; // dps^2, with the two terms
    double noiseFloor = 0.0; // dps^2
    double lagTimeConstantS = 0.0;
    double dpsPerCPerS = 0.0; // a
    double dpsPerLagC = 0.0;  // b
};

// One outcome for each fold and axis. Errc::InvalidOption if the model was not compared or there is one run
// only.
Result<std::vector<DynamicOutcome>> dynamicExperiment(const Comparison &comparison,
                                                      const DynamicExperimentOptions &options = {});

} // namespace driftbench
