#include "engine/base/checksum.h"

#include <array>

namespace driftbench {

namespace {

constexpr std::size_t kAtOnce = 8;

// [k][b]: the remainder of byte b with k zero bytes behind it, so that eight bytes are taken in one step
// ("slicing by 8", Kounavis & Berry 2005).
constexpr auto makeTables()
{
    std::array<std::array<std::uint32_t, 256>, kAtOnce> tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder & 1U) != 0 ? (remainder >> 1) ^ 0xEDB88320U : remainder >> 1;
        tables[0][byte] = remainder;
    }
    for (std::size_t zeros = 1; zeros < kAtOnce; ++zeros) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[zeros - 1][byte];
            tables[zeros][byte] = tables[0][before & 0xffU] ^ (before >> 8);
        }
    }
    return tables;
}

constexpr auto kTables = makeTables();

std::uint32_t littleEndian(const char *bytes)
{
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = (value << 8) | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

} // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t previous)
{
    std::uint32_t crc = ~previous;
    std::size_t at = 0;
    for (; at + kAtOnce <= bytes.size(); at += kAtOnce) {
        const std::uint32_t low = crc ^ littleEndian(bytes.data() + at);
        const std::uint32_t high = littleEndian(bytes.data() + at + 4);
        crc = 0;
        for (std::size_t byte = 0; byte < 4; ++byte)
            crc ^= kTables[7 - byte][(low >> (8 * byte)) & 0xffU] ^
                   kTables[3 - byte][(high >> (8 * byte)) & 0xffU];
    }
    for (; at < bytes.size(); ++at)
        crc = kTables[0][(crc ^ static_cast<std::uint8_t>(bytes[at])) & 0xffU] ^ (crc >> 8);
    return ~crc;
}

} // namespace driftbench
