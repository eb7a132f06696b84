#include "engine/physics/chamber_transient.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace driftbench {

namespace {

constexpr double kPi = std::numbers::pi;

// Where both forms need about as many terms.
constexpr double kSeriesFromFourier = 0.1;
// exp(-40) of a mode is below the rounding of what it is added to.
constexpr double kNegligibleExponent = 40.0;
// erfc(6.5) < 4e-20
constexpr double kNegligibleErfc = 6.5;

// The centre of phi in the unit cube: one direction solved in closed form over a double sine series, whose
// own sum without the cosh is that of the square.
double unitCubeCentre()
{
    constexpr int kHighestMode = 25; // the next term is below 1e-17
    double sum = 0.125;
    for (int m = 1; m <= kHighestMode; m += 2) {
        const double signM = m % 4 == 1 ? 1.0 : -1.0;
        sum -= 4.0 * signM / (std::pow(kPi * m, 3) * std::cosh(0.5 * kPi * m));
        for (int n = 1; n <= kHighestMode; n += 2) {
            const double signN = n % 4 == 1 ? 1.0 : -1.0;
            const double square = m * m + n * n;
            sum -= 16.0 * signM * signN /
                   (std::pow(kPi, 4) * m * n * square * std::cosh(0.5 * kPi * std::sqrt(square)));
        }
    }
    return sum;
}

} // namespace

double slabRemainingBySeries(double place, double fourier)
{
    double sum = 0.0;
    for (int n = 1;; n += 2) {
        const double exponent = n * n * kPi * kPi * fourier;
        if (n > 1 && exponent > kNegligibleExponent)
            return sum;
        sum += 4.0 / (n * kPi) * std::sin(n * kPi * place) * std::exp(-exponent);
    }
}

double slabRemainingByImages(double place, double fourier)
{
    const double reach = 2.0 * std::sqrt(fourier);
    double sum = 1.0;
    for (int k = 0; k <= kNegligibleErfc * reach; ++k) {
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        sum -= sign * (std::erfc((k + place) / reach) + std::erfc((k + 1 - place) / reach));
    }
    return sum;
}

double slabRemaining(double place, double fourier)
{
    if (place <= 0.0 || place >= 1.0)
        return 0.0;
    if (fourier <= 0.0)
        return 1.0;
    return fourier < kSeriesFromFourier ? slabRemainingByImages(place, fourier)
                                        : slabRemainingBySeries(place, fourier);
}

Result<ChamberTransient> ChamberTransient::create(const ChamberDatasheet &chamber)
{
    if (const Status ok = checkDatasheet(chamber); !ok)
        return ok.error();
    return ChamberTransient(chamber.edgeM, chamber.conductivityWPerMK /
                                               (chamber.specificHeatJPerKgK * chamber.densityKgPerM3));
}

double ChamberTransient::slowestModeS() const
{
    return m_edgeM * m_edgeM / (3.0 * kPi * kPi * m_diffusivityM2PerS);
}

double ChamberTransient::rampLagS() const
{
    return unitCubeCentre() * m_edgeM * m_edgeM / m_diffusivityM2PerS;
}

double ChamberTransient::remaining(double timeS, const Eigen::Vector3d &positionM) const
{
    double product = 1.0;
    for (const double along : positionM)
        product *= slabRemaining(along / m_edgeM, fourier(timeS));
    return product;
}

double ChamberTransient::remainingAtCentre(double timeS) const
{
    const double slab = slabRemaining(0.5, fourier(timeS));
    return slab * slab * slab;
}

double ChamberTransient::settlingTimeS(double stepC, double accuracyC) const
{
    const double wanted = accuracyC / std::abs(stepC);
    if (!(wanted < 1.0))
        return 0.0;
    double early = 0.0;
    double late = slowestModeS();
    while (remainingAtCentre(late) > wanted)
        late *= 2.0;
    while (late - early > 1e-12 * late) {
        const double middle = 0.5 * (early + late);
        if (middle <= early || middle >= late)
            break;
        (remainingAtCentre(middle) > wanted ? early : late) = middle;
    }
    return late;
}

double ChamberTransient::temperatureC(const TemperatureProfile &profile, double timeS,
                                      const Eigen::Vector3d &positionM) const
{
    const double forgottenS = kNegligibleExponent * slowestModeS();
    const auto &steps = profile.steps();
    double missingC = 0.0;
    for (std::size_t i = steps.size() - 1; i > 0; --i) {
        const double ageS = timeS - steps[i].startS;
        if (ageS > forgottenS)
            break;
        if (ageS >= 0.0)
            missingC += (steps[i].setpointC - steps[i - 1].setpointC) * remaining(ageS, positionM);
    }
    return profile.setpointC(timeS) - missingC;
}

double ChamberTransient::centreLagC(const TemperatureProfile &profile, double timeS) const
{
    return profile.setpointC(timeS) - temperatureC(profile, timeS, Eigen::Vector3d::Constant(0.5 * m_edgeM));
}

Result<StillAirOutlook> stillAirOutlook(const TestPlan &plan)
{
    const auto profile = plan.profile();
    if (!profile)
        return profile.error();
    const auto chamber = ChamberTransient::create(plan.chamber);
    if (!chamber)
        return chamber.error();
    const std::vector<PlanSegment> segments = plan.segments();
    const auto ramp = std::find_if(segments.begin(), segments.end(),
                                   [](const PlanSegment &segment) { return !segment.isHold(); });
    // Before whatever starts there.
    const double rampEndS = std::nextafter(ramp->startS + ramp->durationS, 0.0);
    StillAirOutlook outlook;
    outlook.slowestModeS = chamber->slowestModeS();
    outlook.settlingS = chamber->settlingTimeS(plan.stepC, plan.chamber.thermometerAccuracyC);
    outlook.rampLagS = chamber->rampLagS();
    outlook.rampLagC = outlook.rampLagS * plan.stepC / plan.periodS;
    outlook.lagAfterRampC = std::abs(chamber->centreLagC(*profile, rampEndS));
    outlook.lagAtEndC = std::abs(chamber->centreLagC(*profile, profile->durationS()));
    return outlook;
}

} // namespace driftbench
