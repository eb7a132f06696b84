// Test plans as JSON files, to be edited by hand as well, and as CSV for a chamber controller.
//
// The JSON file holds the fields of TestPlan and both datasheets, each with its unit in its name; it has no
// checksum. What a reader needs beside them (duration, samples) follows from them.
// Steps:     step,start_s,duration_s,setpoint_C             for controllers that jump
// Segments:  segment,kind,start_s,duration_s,from_C,to_C,rate_C_per_min   for controllers that ramp
//
// Errors: FileNotFound, FileUnreadable, PlanDamaged (not JSON, a field missing or of the wrong shape, a plan
// that can't be run), OutputNotWritable, OutputFull.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/test_plan.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace driftbench {

inline constexpr int kPlanFormatVersion = 1;

std::string planToJson(const TestPlan &plan);
// name: of the file, for messages.
Result<TestPlan> planFromJson(std::string_view json, const std::string &name);

Status writePlan(const TestPlan &plan, const std::filesystem::path &file);
Result<TestPlan> readPlan(const std::filesystem::path &file);

// Of one run. The plan must be one that checkTestPlan accepts.
std::string planStepsToCsv(const TestPlan &plan);
std::string planSegmentsToCsv(const TestPlan &plan);

} // namespace driftbench
