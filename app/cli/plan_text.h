// What `plan` found, as text and as JSON.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/chamber_transient.h"
#include "engine/physics/control_figures.h"
#include "engine/physics/lag_estimate.h"
#include "engine/physics/test_plan.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace driftbench::cli {

struct PlanOutline
{
    TestPlan plan;
    std::vector<PlanFigure> interval;
    std::vector<PlanFigure> period;
    StillAirOutlook stillAir;
};

// Errc::InvalidOption as checkTestPlan says.
Result<PlanOutline> outlinePlan(const TestPlan &plan);

std::string planAsText(const PlanOutline &outline);
nlohmann::ordered_json planOutlineToJson(const PlanOutline &outline);

// setpoint: where it came from, "the column setpoint_C" or "plan.json".
std::string lagAsText(const std::string &log, const std::string &setpoint, const LagEstimate &lag);
nlohmann::ordered_json lagToJson(const std::string &log, const std::string &setpoint, const LagEstimate &lag);

} // namespace driftbench::cli
