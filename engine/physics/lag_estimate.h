// How a chamber really follows its set-point, from a recording of both: first order with dead time, gain 1.
//
//   tau dx/dt = u(t - theta) - x,   y = x + offset + noise
// u is the set-point, constant between its steps; y the measured temperature. What x was off at the start is
// estimated as well (it decays with tau). Between steps x is an exponential, so it is exact however the
// samples lie in time. Least squares: the best nodes of a grid over (theta, tau) on a part of the samples,
// then Levenberg-Marquardt with exact derivatives on all,
//   dx/dtheta = -(u(t - theta) - x)/tau,   d/dt(dx/dtau) = -(dx/dtau)/tau - (u(t - theta) - x)/tau^2
//
// Standard deviations come from the residual and its correlation from sample to sample. Times in seconds, in
// one time base; temperatures in degrees Celsius.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/temperature_profile.h"

#include <Eigen/Core>
#include <vector>

namespace driftbench {

struct LagEstimate
{
    double deadTimeS = 0.0; // theta
    double deadTimeSdS = 0.0;
    double timeConstantS = 0.0; // tau
    double timeConstantSdS = 0.0;
    double offsetC = 0.0;
    double residualRmsC = 0.0;
    Eigen::Index samples = 0;
};

// A set-point that was logged with the samples, as steps.
std::vector<ProfileStep> setpointSteps(const Eigen::VectorXd &timeS, const Eigen::VectorXd &setpointC);

// setpoint: ascending in time, not empty; before its first step it was what that says. Errors:
//   TooFewSamples        under 20
//   NonFiniteValue, TimeBackwards
//   ConstantTemperature  the set-point does not change while the recording lasts
//   TooShort             the lag is longer than the recording can show
//   NothingUsable        the temperature does not follow the set-point, or too little happens to tell theta
//                        from tau
Result<LagEstimate> estimateLag(const std::vector<ProfileStep> &setpoint, const Eigen::VectorXd &timeS,
                                const Eigen::VectorXd &temperatureC);

} // namespace driftbench
