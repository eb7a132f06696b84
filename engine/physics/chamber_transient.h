// The air of a chamber when nothing but conduction moves heat: a cube of edge L whose walls all step at once.
//
//   v_t = a (v_xx + v_yy + v_zz),  a = k_h / (C rho);  v = 1 inside at t = 0, 0 at the walls
//   v(x, y, z, t) = p(x) p(y) p(z): what is still missing of a step of the walls, 1 ... 0
// with F = a t / L^2, s = x / L and two forms of the same p:
//   series  p = sum over odd n of 4/(n pi) sin(n pi s) exp(-n^2 pi^2 F)                  quick for large F
//   images  p = 1 - sum over k >= 0 of (-1)^k [erfc((k + s)/(2 sqrt F)) + erfc((k + 1 - s)/(2 sqrt F))]
//                                                                                        quick for small F
// (Carslaw & Jaeger, Conduction of Heat in Solids, 2nd ed., sections 3.3 and 1.15.) The slowest mode decays
// with L^2 / (3 pi^2 a). Behind walls that rise at a steady rate r the centre lags by r times
//   rampLagS = phi L^2 / a,  phi the centre of: Laplacian phi = -1 in the unit cube, 0 at its faces
// A stair of set-points is a superposition of steps. Lengths in metres, times in seconds.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/datasheets.h"
#include "engine/physics/temperature_profile.h"
#include "engine/physics/test_plan.h"

#include <Eigen/Core>

namespace driftbench {

// p of one direction; place 0 ... 1 between the walls, fourier = F > 0.
double slabRemainingBySeries(double place, double fourier);
double slabRemainingByImages(double place, double fourier);
double slabRemaining(double place, double fourier); // the quicker of both; 1 inside for F <= 0

class ChamberTransient
{
public:
    // Errc::InvalidOption as checkDatasheet says.
    static Result<ChamberTransient> create(const ChamberDatasheet &chamber);

    double diffusivityM2PerS() const { return m_diffusivityM2PerS; }
    double slowestModeS() const;
    double rampLagS() const;

    // v at a position measured from a corner, 0 ... L each; 0 on the walls and beyond.
    double remaining(double timeS, const Eigen::Vector3d &positionM) const;
    double remainingAtCentre(double timeS) const;

    // How long the centre is further than accuracyC (> 0) from its new temperature after a step of the walls.
    double settlingTimeS(double stepC, double accuracyC) const;

    // Temperature at a position while the walls play the profile; the cube starts at its first set-point.
    double temperatureC(const TemperatureProfile &profile, double timeS,
                        const Eigen::Vector3d &positionM) const;
    // Set-point less temperature at the centre.
    double centreLagC(const TemperatureProfile &profile, double timeS) const;

private:
    ChamberTransient(double edgeM, double diffusivityM2PerS)
        : m_edgeM(edgeM), m_diffusivityM2PerS(diffusivityM2PerS)
    {
    }

    double fourier(double timeS) const { return m_diffusivityM2PerS * timeS / (m_edgeM * m_edgeM); }

    double m_edgeM;
    double m_diffusivityM2PerS;
};

// What a plan must reckon with if nothing stirs the chamber's air.
struct StillAirOutlook
{
    double slowestModeS = 0.0;
    double settlingS = 0.0;     // of the centre after one step, to within the thermometer's accuracy
    double rampLagS = 0.0;      // of the centre behind a ramp that is long enough
    double rampLagC = 0.0;      // the same at the plan's rate
    double lagAfterRampC = 0.0; // of the centre at the end of a run's first ramp, without sign
    double lagAtEndC = 0.0;     // at the end of the run
};

// Errc::InvalidOption as checkTestPlan says.
Result<StillAirOutlook> stillAirOutlook(const TestPlan &plan);

} // namespace driftbench
