// ArduPilot parameters, as AP_InertialSensor_tempcal reads them (INS_TCALn, IMU n = 1 to 3):
//   P(T) = (c1 d + c2 d^2 + c3 d^3) 1e-6 rad/s,  d = clamp(T, TMIN, TMAX) - 35 C
//   corrected = raw - P(T) + P(CALTEMP) - offset
// all in 32-bit floats; TMIN and TMAX are documented for -70 to 80 C and at least 10 C apart.
// P has no constant term. The model's is carried by the gyro offset: at the anchor temperature
// INS_GYRn_CALTEMP (the model's reference temperature, or the nearest inside TMIN..TMAX) the offset is the
// whole TDE, so that corrected = raw - tde(T). ArduPilot measures offset and CALTEMP anew at every start
// unless INS_GYR_CAL is 0; the two belong together, so that stays right. An axis that is not compensated gets
// zero coefficients and no offset line: what the autopilot has for it stays.
// File: lines "NAME VALUE", comments with #.
//
// Errors: InvalidOption (no such IMU), ModelNotUsableHere (under 10 C of the trained range can be used).
#pragma once

#include "engine/compensation/axis_selection.h"
#include "engine/exports/export_model.h"

namespace driftbench {

Result<Exported> exportForArduPilot(const TrainedModel &model, const ExportOptions &options,
                                    const AxisSelection &selection);

} // namespace driftbench
