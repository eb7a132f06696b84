// PX4 parameters, as its module temperature_compensation reads them (TC_G*, gyro n = 0 to 3):
//   d = clamp(T, TMIN, TMAX) - TREF,  offset = X0 + X1 d + X2 d^2 + X3 d^3 in rad/s,  corrected = raw -
//   offset
// all in 32-bit floats. TREF is the middle of the trained range, as in PX4's own fit.
// File: lines "1<TAB>1<TAB>NAME<TAB>VALUE<TAB>TYPE" (type 6: int32, 9: float) that QGroundControl loads.
//
// PX4 picks the set of a gyro by TC_Gn_ID alone. Without an id it would ignore the file, with a wrong one it
// would correct another gyro, so an unknown id is an error (InvalidOption), not a guess.
#pragma once

#include "engine/compensation/axis_selection.h"
#include "engine/exports/export_model.h"

namespace driftbench {

Result<Exported> exportForPx4(const TrainedModel &model, const ExportOptions &options,
                              const AxisSelection &selection);

} // namespace driftbench
