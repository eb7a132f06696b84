#include "engine/formats/decimal.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>

namespace driftbench {

namespace {

// Whether a number that no double can hold is too large rather than too small: by the place of its first
// digit that is not zero, shifted by the exponent.
bool isHuge(std::string_view digits)
{
    constexpr long kExponentBound = 1000000000;
    const auto mark = digits.find_first_of("eE");
    const auto significand = digits.substr(0, mark);
    long exponent = 0;
    if (mark != std::string_view::npos) {
        auto text = digits.substr(mark + 1);
        const bool negative = text.front() == '-';
        if (negative || text.front() == '+')
            text.remove_prefix(1);
        if (std::from_chars(text.data(), text.data() + text.size(), exponent).ec != std::errc())
            exponent = kExponentBound;
        exponent = negative ? -exponent : exponent;
    }
    const auto point = static_cast<long>(std::min(significand.find('.'), significand.size()));
    const auto leading = static_cast<long>(significand.find_first_of("123456789"));
    return point - leading + std::clamp(exponent, -kExponentBound, kExponentBound) > 0;
}

} // namespace

const char *scanDecimalSlowly(const char *begin, const char *end, double &value)
{
    const bool negative = *begin == '-';
    const char *const first = begin + ((negative || *begin == '+') ? 1 : 0);
    const auto [behind, code] = std::from_chars(first, end, value);
    if (code == std::errc::invalid_argument)
        return nullptr;
    if (code == std::errc::result_out_of_range) {
        const std::string_view digits(first, static_cast<std::size_t>(behind - first));
        value = isHuge(digits) ? std::numeric_limits<double>::infinity() : 0.0;
    }
    value = negative ? -value : value;
    return behind;
}

} // namespace driftbench
