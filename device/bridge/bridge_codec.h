// The reports of the native gyro bridge (bridge_protocol.h, docs/bridge-protocol.md) as values, and commands
// as reports. Pure: bytes in, values out, no device.
//
// A report starts with its id and has 64 bytes; longer ones (drivers pad) are read as far as byte 63. What
// newer minor versions add is ignored: unknown flags, results and states pass through.
//
// Rates: counts x sensitivity / 100 000 in dps, the sensitivity being that of the range in use in 10 udps a
// count. Temperatures: millidegrees / 1000 in degrees Celsius.
//
// Errors: DamagedReport with the byte and its value; decodeBridgeInfo also ProtocolVersion.
#pragma once

#include "device/bridge/bridge_protocol.h"
#include "engine/base/result.h"
#include "engine/recording/recording.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace driftbench {

using BridgeReport = std::array<std::uint8_t, BRIDGE_REPORT_SIZE>;

struct BridgeRange
{
    std::uint16_t fullScaleDps = 0;
    std::uint16_t sensitivity = 0; // 10 udps a count

    double rateDps(std::int32_t counts) const { return counts * static_cast<double>(sensitivity) / 100000.0; }
    bool operator==(const BridgeRange &) const = default;
};

struct BridgeInfo
{
    int major = 0;
    int minor = 0;
    std::uint8_t capabilities = 0; // BRIDGE_CAN_*
    std::array<std::uint8_t, 3> firmware{};
    SensorIdentity sensor;
    std::uint32_t lowestRateMilliHz = 0;
    std::uint32_t highestRateMilliHz = 0;
    std::uint32_t bankBytes = 0;     // the longest table image that a bank takes
    std::vector<BridgeRange> ranges; // 1 .. BRIDGE_RANGES

    bool can(std::uint8_t capability) const { return (capabilities & capability) != 0; }
    std::string firmwareText() const; // "1.0.3"
};

struct BridgeConfig
{
    std::uint32_t rateMilliHz = 0;
    std::uint8_t range = 0; // index into BridgeInfo::ranges
    bool stream = false;
    bool compensate = false;
    bool pair = false; // a raw twin after every compensated report; only with BRIDGE_CAN_PAIR
    bool operator==(const BridgeConfig &) const = default;
};

struct BridgeBank
{
    std::uint8_t state = BRIDGE_BANK_EMPTY; // BRIDGE_BANK_*
    std::uint32_t generation = 0;
    std::uint32_t bytes = 0;
    std::uint32_t crc = 0;
    bool operator==(const BridgeBank &) const = default;
};

struct BridgeStatus
{
    std::uint8_t command = 0;
    std::uint8_t result = 0;                // BRIDGE_RESULT_*
    std::optional<std::uint8_t> activeBank; // below BRIDGE_BANKS
    std::uint32_t producedSamples = 0;      // wraps
    std::uint32_t droppedSamples = 0;       // wraps
    std::uint32_t receivedBytes = 0;
    std::array<BridgeBank, BRIDGE_BANKS> banks;
    bool operator==(const BridgeStatus &) const = default;
};

struct BridgeSamples
{
    std::uint8_t flags = 0;     // BRIDGE_FLAG_*
    std::uint8_t saturated = 0; // bit i: sample i
    int count = 0;              // 1 .. BRIDGE_SAMPLES_PER_REPORT
    std::uint16_t sequence = 0;
    std::uint32_t timeUs = 0;
    std::uint32_t intervalNs = 0;
    std::optional<std::int32_t> dieMilliC;
    std::optional<std::int32_t> externalMilliC;
    std::array<std::array<std::int16_t, 3>, BRIDGE_SAMPLES_PER_REPORT> counts{};

    bool has(std::uint8_t flag) const { return (flags & flag) != 0; }
    bool isSaturated(int sample) const { return ((saturated >> sample) & 1) != 0; }
};

// Bytes of a bank as a read gives them.
struct BridgeTablePart
{
    std::uint8_t bank = 0;
    std::uint32_t offset = 0;
    std::vector<std::uint8_t> bytes; // up to BRIDGE_READ_BYTES; none past the end of the image
};

Result<BridgeInfo> decodeBridgeInfo(std::span<const std::uint8_t> report);
Result<BridgeConfig> decodeBridgeConfig(std::span<const std::uint8_t> report);
Result<BridgeStatus> decodeBridgeStatus(std::span<const std::uint8_t> report);
Result<BridgeSamples> decodeBridgeSamples(std::span<const std::uint8_t> report);
Result<BridgeTablePart> decodeBridgeTablePart(std::span<const std::uint8_t> report);

BridgeReport encodeBridgeConfig(const BridgeConfig &config);
BridgeReport encodeBridgeBegin(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc);
// bytes: 1 .. BRIDGE_CHUNK_BYTES.
BridgeReport encodeBridgeChunk(std::uint16_t transaction, std::uint32_t offset,
                               std::span<const std::uint8_t> bytes);
// length: 1 .. BRIDGE_READ_BYTES.
BridgeReport encodeBridgeRead(std::uint8_t bank, std::uint32_t offset, std::uint8_t length);
BridgeReport encodeBridgeVerify(std::uint16_t transaction);
BridgeReport encodeBridgeCommit(std::uint16_t transaction);
BridgeReport encodeBridgeActivate(std::uint32_t generation);
BridgeReport encodeBridgeRollback(std::uint32_t generation);

std::string bridgeCommandText(std::uint8_t reportId); // "begin a table", for sentences: "refused to ..."
std::string bridgeResultText(std::uint8_t result);   // why, and what to do: "the image is for another sensor"
std::string bridgeBankStateText(std::uint8_t state); // "empty", "committed", ...

} // namespace driftbench
