// The temperature a chamber is asked for over time, as a stair of set-points.
//
// A profile starts at a temperature and plays segments: a hold keeps the set-point for durationS; a ramp
// moves it by stepC towards targetC at the start of every period of periodS, the last step being shorter
// where the way is no multiple of stepC. The list of segments may be repeated; each repeat goes on from where
// the last one ended. Times in seconds from the start, temperatures in degrees Celsius.
//
// The profile `paper` is the experiment of section 4.1 of the paper: hold -40 C for 0.5 h, rise by 0.5 C
// every 30 s to 85 C, hold for 0.5 h; 11 100 s.
//
// Errors: Errc::InvalidOption where a temperature lies below absolute zero, a ramp has no step or no period,
// a duration is negative, or the whole is empty or endless.
#pragma once

#include "engine/base/result.h"

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace driftbench {

inline constexpr double kAbsoluteZeroC = -273.15;

struct HoldSegment
{
    double durationS = 0.0;
};

struct RampSegment
{
    double targetC = 0.0;
    double stepC = 0.0; // the size of a step, without sign
    double periodS = 0.0;
};

using ProfileSegment = std::variant<HoldSegment, RampSegment>;

// From startS on the set-point is setpointC, until the next step starts.
struct ProfileStep
{
    double startS = 0.0;
    double setpointC = 0.0;
};

inline constexpr std::array<std::string_view, 5> kProfileNames{"paper", "cooling", "cycle", "quick",
                                                               "warmup"};

inline constexpr double kMostProfileSteps = 1e6;

// Of a ramp; a way that is a whole number of steps gets no further step from rounding.
double rampSteps(double wayC, double stepC);

class TemperatureProfile
{
public:
    static Result<TemperatureProfile> build(std::string name, double startC,
                                            const std::vector<ProfileSegment> &segments, int repeats = 1);
    static Result<TemperatureProfile> named(std::string_view name); // one of kProfileNames

    const std::string &name() const { return m_name; }
    const std::vector<ProfileStep> &steps() const { return m_steps; } // ascending in time, never empty
    double durationS() const { return m_durationS; }
    double startC() const { return m_steps.front().setpointC; }
    double lowestC() const { return m_lowestC; }
    double highestC() const { return m_highestC; }

    double setpointC(double timeS) const; // before the start the first, after the end the last

private:
    TemperatureProfile() = default;
    Status append(const HoldSegment &hold);
    Status append(const RampSegment &ramp);
    void appendStep(double startS, double setpointC);

    std::string m_name;
    std::vector<ProfileStep> m_steps;
    double m_durationS = 0.0;
    double m_lowestC = 0.0;
    double m_highestC = 0.0;
};

} // namespace driftbench
