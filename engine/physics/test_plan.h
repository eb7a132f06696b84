// A plan for a temperature test of a gyro: what the chamber is asked for, how often it is sampled, how often
// it is run. The plan of the paper (section 2.2.1) is makeTestPlan(L3GD20H, SET-Z-021): hold -40 C for 0.5 h,
// 0.5 C every 30 s up to 85 C, hold 0.5 h, 10 Hz, five runs.
//
//   heating  hold at lowestC, steps of stepC every periodS up to highestC, hold
//   cooling  the same from highestC down to lowestC
//   cycle    hold at lowestC, then `cycles` times: up, hold, down, hold
//
// Every run is one such profile and one log. Times in seconds, temperatures in degrees Celsius.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/datasheets.h"
#include "engine/physics/temperature_profile.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class PlanKind
{
    Heating,
    Cooling,
    Cycle
};

inline constexpr std::array<std::string_view, 3> kPlanKindNames{"heating", "cooling", "cycle"};

std::string_view planKindName(PlanKind kind);
std::optional<PlanKind> planKindNamed(std::string_view name); // one of kPlanKindNames

// A stretch of a run as a chamber controller takes it that knows ramps.
struct PlanSegment
{
    double startS = 0.0;
    double durationS = 0.0;
    double fromC = 0.0;
    double toC = 0.0; // fromC: a hold

    bool isHold() const { return fromC == toC; }
    double rateCPerMin() const { return (toC - fromC) / durationS * 60.0; }
};

struct TestPlan
{
    SensorDatasheet sensor;
    ChamberDatasheet chamber;
    PlanKind kind = PlanKind::Heating;
    double lowestC = -40.0;
    double highestC = 85.0;
    double stepC = 0.5;
    double periodS = 30.0;
    double holdS = 1800.0;
    double sampleRateHz = 10.0;
    int cycles = 1; // of a run; 1 unless kind is Cycle
    int runs = 5;

    // The set-points of one run. Errc::InvalidOption as checkTestPlan says.
    Result<TemperatureProfile> profile() const;
    // The same run as holds and ramps; the plan must be one that checkTestPlan accepts, as for all below.
    std::vector<PlanSegment> segments() const;

    double runDurationS() const;
    std::int64_t samplesPerRun() const; // as many as the simulator makes: at i / sampleRateHz
    std::int64_t samplesInAll() const { return runs * samplesPerRun(); }
};

// With the recommended step and period (control_figures.h) over the gyro's operating range.
// Errc::InvalidOption as controlInterval and controlPeriod say.
Result<TestPlan> makeTestPlan(const SensorDatasheet &sensor, const ChamberDatasheet &chamber);

// Errc::InvalidOption with the first figure that can't be: what it is and what it must be. A run of more than
// a hundred days, or of more than a million steps, is endless.
Status checkTestPlan(const TestPlan &plan);

} // namespace driftbench
