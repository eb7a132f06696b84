// Text in columns of characters, where UTF-8 counts bytes; none of our characters is wider than one column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace driftbench::cli {

inline constexpr std::size_t kTextColumns = 120; // of a terminal that shows our tables unbroken

std::size_t widthOf(std::string_view text);
std::string left(const std::string &text, std::size_t width);  // filled on the right
std::string right(const std::string &text, std::size_t width); // filled on the left

// Broken between words at kTextColumns; lines after the first are indented as far as its lead is long.
std::string wrapped(const std::string &lead, const std::string &text);

} // namespace driftbench::cli
