// Numbers as they lie in binary logs: little-endian, at any address.
#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace driftbench {

// bytes must hold the whole number at `offset`. Both log formats and every machine we build for are
// little-endian; the assertion below guards the second half of that.
template <class Number>
Number littleEndian(std::string_view bytes, std::size_t offset)
{
    static_assert(std::is_arithmetic_v<Number>);
#if defined(__BYTE_ORDER__)
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary logs are read as they lie in memory");
#endif
    Number number;
    std::memcpy(&number, bytes.data() + offset, sizeof(number));
    return number;
}

} // namespace driftbench
