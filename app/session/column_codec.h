// A column of doubles as few bytes, and back bit for bit (docs/session-format.md, "Columns").
//
// Measured values are rarely arbitrary doubles: counts times a sensitivity, decimals of a text file, float32
// of a flight log, times on a clock. Each column takes the smallest form that gives back every bit, 8 bytes a
// value where none does:
//
//   raw      value[i] = f64
//   float32  value[i] = f32
//   grid     value[i] = (offset + n[i] step) / divisor         offset, step whole; divisor 10^d
//   scaled   value[i] = (offset + n[i]) scale
//   line     bits(value[i]) = bits(first + i step) + offset + n[i]     the doubles as 64-bit integers
//
// with n[i] of 1, 2 or 4 bytes, unsigned. Everything is little-endian; products and sums are those of IEEE
// doubles, rounded after each operation.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace driftbench {

std::string encodeColumn(std::span<const double> values);

// False unless the bytes are a whole column of values.size() values.
bool decodeColumn(std::string_view bytes, std::span<double> values);

} // namespace driftbench
