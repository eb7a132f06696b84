// The power series f_p(z) = sum over k >= 0 of z^k / (2k + p), |z| < 1, for p = 1 and 3.
//
//   f_1(z) = atanh(sqrt z) / sqrt z  for z > 0,  atan(sqrt -z) / sqrt -z  for z < 0,  1 at z = 0
//   f_3(z) = (f_1(z) - 1) / z
// One function each, analytic through zero: with them the closed form of the comb capacitor needs no cases.
// Relative error a few 1e-16, of the slopes up to 5e-14. The slopes come from 2 z f_p' + p f_p = 1 / (1 - z).
// No errors: the callers keep z inside the circle; z below -1 is taken by the same closed forms.
#pragma once

namespace driftbench {

double tangentSeries(int order, double z);
double tangentSeriesSlope(int order, double z);

} // namespace driftbench
