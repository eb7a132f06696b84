// A plan that the simulated bridge goes through in seconds.
#pragma once

#include "engine/physics/test_plan.h"

namespace driftbench::test {

// 20 to 32 degrees, 240 s in all.
inline TestPlan shortPlan()
{
    TestPlan plan;
    plan.sensor = *namedSensor("I3G4250D");
    plan.chamber = *namedChamber("SET-Z-021");
    plan.lowestC = 20.0;
    plan.highestC = 32.0;
    plan.stepC = 0.5;
    plan.periodS = 5.0;
    plan.holdS = 60.0;
    plan.runs = 2;
    return plan;
}

} // namespace driftbench::test
