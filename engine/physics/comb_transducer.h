// From capacitance to rate: what the capacitance error of the combs looks like in a gyro's output.
//
// A rate moves the combs by k per dps about a rest displacement r (the offset that the drive leaves). The
// gyro is calibrated at T0, where its scale factor is the slope of Eq. (4) at rest,
//   S = d(dC)/d(rate) = C(T0, r) k / (d0 - r)                                            in fF per dps
// and takes every capacitance for a rate. The rate error at a rate w is then
//   dE(T - T0, r + k w) / S                                                              in dps
// What the gap makes of S away from rest is no matter of temperature and is left out.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/comb_capacitor.h"

namespace driftbench {

struct CombTransducer
{
    double displacementUmPerDps = 1e-3;
    double restDisplacementUm = 0.1;
};

// Errc::InvalidOption for a displacement per dps that is zero or not finite, or a rest displacement that
// closes the gap.
Result<double> scaleFactorFfPerDps(const CombCapacitor &comb, const CombTransducer &transducer);

inline double equivalentRateDps(double errorFf, double scaleFactorFfPerDps)
{
    return errorFf / scaleFactorFfPerDps;
}

} // namespace driftbench
