// Decimal text to the nearest double, fast for the numbers that logs hold.
//
// With up to 19 digits the text is m * 10^e with a 64-bit m. Where m <= 2^53 and |e| <= 22, both m and 10^|e|
// are doubles, so that one multiplication or division rounds once and gives the nearest double (W. D.
// Clinger, "How to read floating point numbers accurately", PLDI 1990). Everything else takes the library's
// slower way, which is exact as well. Never depends on the locale.
#pragma once

#include <array>
#include <cstdint>

namespace driftbench {

// Reads a number [+-]digits[.digits][(e|E)[+-]digits] that begins at `begin` into value and returns the byte
// behind it; nullptr if none begins there. There must be a byte before `end` that can't belong to a number (a
// line end, say). What is too large gives infinity, what is too small zero, each with its sign.
inline const char *scanDecimal(const char *begin, const char *end, double &value);

// The way without limits on digits and exponent.
const char *scanDecimalSlowly(const char *begin, const char *end, double &value);

namespace decimal_detail {

inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline const char *scanDigits(const char *at, std::uint64_t &digits)
{
    for (unsigned digit = 0; (digit = static_cast<unsigned char>(*at) - unsigned{'0'}) <= 9; ++at)
        digits = digits * 10 + digit;
    return at;
}

} // namespace decimal_detail

inline const char *scanDecimal(const char *begin, const char *end, double &value)
{
    using namespace decimal_detail;
    constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53;
    const bool negative = *begin == '-';
    const char *const first = begin + ((negative || *begin == '+') ? 1 : 0);
    std::uint64_t mantissa = 0;
    const char *at = scanDigits(first, mantissa);
    auto digitCount = at - first;
    std::ptrdiff_t decimals = 0;
    if (*at == '.') {
        const char *const fraction = at + 1;
        at = scanDigits(fraction, mantissa);
        decimals = at - fraction;
        digitCount += decimals;
    }
    if (digitCount == 0)
        return nullptr;
    if (digitCount > 19 || mantissa > kLargestExact || decimals > 22 || *at == 'e' || *at == 'E')
        return scanDecimalSlowly(begin, end, value);
    const double magnitude = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    value = negative ? -magnitude : magnitude;
    return at;
}

} // namespace driftbench
