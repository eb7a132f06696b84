#include "engine/physics/temperature_profile.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

bool isTemperature(double temperatureC)
{
    return std::isfinite(temperatureC) && temperatureC >= kAbsoluteZeroC;
}

Error noTemperature(double temperatureC)
{
    return invalidOption("The profile asks for " + shortest(temperatureC) +
                         " °C; give a temperature above absolute zero (−273.15 °C).");
}

} // namespace

double rampSteps(double wayC, double stepC)
{
    constexpr double kRoundingSlack = 1e-9;
    return std::ceil(std::abs(wayC) / stepC - kRoundingSlack);
}

Result<TemperatureProfile> TemperatureProfile::build(std::string name, double startC,
                                                     const std::vector<ProfileSegment> &segments, int repeats)
{
    if (!isTemperature(startC))
        return noTemperature(startC);
    if (repeats < 1)
        return invalidOption("The profile is repeated " + std::to_string(repeats) +
                             " times; repeat it at least once.");
    TemperatureProfile profile;
    profile.m_name = std::move(name);
    profile.m_lowestC = profile.m_highestC = startC;
    profile.m_steps.push_back({0.0, startC});
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (const ProfileSegment &segment : segments) {
            const Status appended =
                std::visit([&profile](const auto &kind) { return profile.append(kind); }, segment);
            if (!appended)
                return appended.error();
        }
    }
    if (!(profile.m_durationS > 0.0))
        return invalidOption("The profile lasts 0 s; give it a hold or a ramp.");
    return profile;
}

Status TemperatureProfile::append(const HoldSegment &hold)
{
    if (!std::isfinite(hold.durationS) || hold.durationS < 0.0)
        return invalidOption("A hold of the profile lasts " + shortest(hold.durationS) +
                             " s; give 0 s or more.");
    m_durationS += hold.durationS;
    return {};
}

Status TemperatureProfile::append(const RampSegment &ramp)
{
    if (!isTemperature(ramp.targetC))
        return noTemperature(ramp.targetC);
    if (!std::isfinite(ramp.stepC) || ramp.stepC <= 0.0)
        return invalidOption("A ramp of the profile moves by " + shortest(ramp.stepC) +
                             " °C a step; give a step above 0 °C.");
    if (!std::isfinite(ramp.periodS) || ramp.periodS <= 0.0)
        return invalidOption("A ramp of the profile takes " + shortest(ramp.periodS) +
                             " s a step; give a period above 0 s.");
    const double fromC = m_steps.back().setpointC;
    const double wayC = ramp.targetC - fromC;
    const double count = rampSteps(wayC, ramp.stepC);
    if (count + static_cast<double>(m_steps.size()) > kMostProfileSteps)
        return invalidOption("The profile has more than a million steps; take larger ones than " +
                             shortest(ramp.stepC) + " °C.");
    const double startS = m_durationS;
    for (double step = 1.0; step <= count; ++step) {
        const double setpointC =
            step == count ? ramp.targetC : fromC + std::copysign(step * ramp.stepC, wayC);
        appendStep(startS + (step - 1.0) * ramp.periodS, setpointC);
    }
    m_durationS = startS + std::max(count, 0.0) * ramp.periodS;
    return {};
}

void TemperatureProfile::appendStep(double startS, double setpointC)
{
    if (m_steps.back().startS == startS)
        m_steps.back().setpointC = setpointC;
    else
        m_steps.push_back({startS, setpointC});
    m_lowestC = std::min(m_lowestC, setpointC);
    m_highestC = std::max(m_highestC, setpointC);
}

double TemperatureProfile::setpointC(double timeS) const
{
    const auto after = std::upper_bound(m_steps.begin(), m_steps.end(), timeS,
                                        [](double t, const ProfileStep &step) { return t < step.startS; });
    return after == m_steps.begin() ? m_steps.front().setpointC : std::prev(after)->setpointC;
}

Result<TemperatureProfile> TemperatureProfile::named(std::string_view name)
{
    constexpr HoldSegment kHalfHour{1800.0};
    constexpr RampSegment kUp{85.0, 0.5, 30.0};
    constexpr RampSegment kDown{-40.0, 0.5, 30.0};
    if (name == "paper")
        return build("paper", -40.0, {kHalfHour, kUp, kHalfHour});
    if (name == "cooling")
        return build("cooling", 85.0, {kHalfHour, kDown, kHalfHour});
    if (name == "cycle")
        return build("cycle", -40.0, {kHalfHour, kUp, kHalfHour, kDown, kHalfHour});
    if (name == "quick")
        return build("quick", -40.0, {HoldSegment{60.0}, RampSegment{85.0, 0.5, 1.0}, HoldSegment{60.0}});
    if (name == "warmup")
        return build("warmup", 20.0, {HoldSegment{60.0}, RampSegment{55.0, 0.5, 15.0}, HoldSegment{300.0}});
    std::string known;
    for (const std::string_view each : kProfileNames)
        known += (known.empty() ? "" : ", ") + std::string(each);
    return invalidOption("There is no temperature profile \"" + std::string(name) + "\"; choose one of " +
                         known + ".");
}

} // namespace driftbench
