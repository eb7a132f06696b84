// The rows of Driftbench's own CSV: time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps, numbers with the
// fewest digits that read back to the same double, so that no information is lost and files stay small.
#pragma once

#include "engine/physics/gyro_simulator.h"

#include <string>
#include <string_view>

namespace driftbench::cli {

inline constexpr std::string_view kCsvHeader = "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps\n";

// Replaces text by the first count rows of the block.
void formatCsvRows(const SampleBlock &block, Eigen::Index count, std::string &text);

} // namespace driftbench::cli
