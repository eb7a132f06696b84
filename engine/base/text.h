// Numbers to text and back, independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace driftbench {

std::string shortest(double value);                 // fewest digits that read back to the same double
std::string fixed(double value, int decimals);      // for files: "-3.99"
std::string forReading(double value, int decimals); // for sentences: with a real minus sign, U+2212

// The whole of text as a number: "1", "-2.5e-3", "inf", "nan". Nothing if anything is left over.
std::optional<double> parseNumber(std::string_view text);

std::string_view trimmed(std::string_view text); // without white space at both ends
std::string lowered(std::string_view text);      // ASCII letters in lower case

} // namespace driftbench
