// Every decoder of device/ behind one door, for bytes that nobody vouches for: the first byte of the input
// says which decoder (modulo their number), the rest is what it gets. What a decoder takes is checked against
// its contract, and where the reference firmware decodes the same, against it; a broken contract ends the
// program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace driftbench::test {

enum class DeviceDecoder : std::uint8_t
{
    BridgeInfo,
    BridgeConfig,
    BridgeStatus,
    BridgeSamples,
    BridgeTablePart,
    BridgeStream, // u8 milliseconds of the host's clock and 64 bytes of a sample report, repeated
    DeviceImage,  // of a compensation table
    Firmware,     // 64 bytes of a report that the host sets, repeated
    Mcp2221a,
    Cp2112,
    Ft260,
    StGyro,
    Thermometers, // u16, repeated
    Count,
};

std::string_view decoderName(DeviceDecoder decoder); // "bridge_info"

// Whether the decoder took at least one value out of the bytes.
bool decodeUntrusted(std::span<const std::uint8_t> input);

} // namespace driftbench::test
