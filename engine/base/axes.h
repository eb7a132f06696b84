// The three axes of a gyro, in the order of every N x 3 matrix here.
#pragma once

#include <array>
#include <string_view>

namespace driftbench {

inline constexpr int kAxisCount = 3;
inline constexpr std::array<std::string_view, kAxisCount> kAxisNames{"x", "y", "z"};

inline constexpr double kDegreesPerRadian = 57.295779513082320876798154814105;

} // namespace driftbench
