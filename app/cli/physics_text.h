// A study of the combs as a table for people, as JSON for machines and plots, and as CSV.
//
// JSON, in fF, um, C and dps; "curve", "gap" and the residuals are for plots:
//   { "formula": "corrected", "combs": {..}, "displacement_um", "displacement_um_per_dps",
//     "scale_factor_fF_per_dps", "contact_C" (null: never), "ends_at_contact",
//     "thinnest_comb_um" (by Eq. (8); below zero the formula no longer holds),
//     "rows": [{ "temperature_C", "delta_T_C", "rest_change_fF", "change_fF", "error_fF", "rate_dps",
//                "printed_change_fF_um" (null where Eq. (10) as printed has no value) }],
//     "sensitivities": { "temperature_C", "parameters": [{ "symbol", "name", "unit", "value",
//                        "slope_fF_per_unit", "relative" }] },
//     "quantities": [{ "set", "terms", "explained", "unexplained", "rms_fF", "largest_fF",
//                      "residual_fF": [..] }],
//     "curve": { "temperature_C": [..], "rest_change_fF", "change_fF": [..], "error_fF": [..] },
//     "gap": { "x_um": [..], "profiles": [{ "temperature_C", "gap_um": [..] }] } }
#pragma once

#include "app/cli/physics_study.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace driftbench::cli {

std::string physicsAsText(const PhysicsStudy &study, bool asPrinted);
std::string physicsAsCsv(const PhysicsStudy &study, bool asPrinted); // the table
nlohmann::ordered_json physicsToJson(const PhysicsStudy &study);

} // namespace driftbench::cli
