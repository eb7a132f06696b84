#include "support/device_decoders.h"

#include "device/bridge/bridge_assembler.h"
#include "device/bridge/bridge_codec.h"
#include "device/firmware/bridge_device.h"
#include "device/gyros/st_gyro_registers.h"
#include "device/gyros/thermometers.h"
#include "device/i2c/cp2112_codec.h"
#include "device/i2c/ft260_codec.h"
#include "device/i2c/mcp2221a_codec.h"
#include "device/ram_flash.h"
#include "engine/exports/device_compensation.h"
#include "engine/exports/device_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace driftbench::test {

namespace {

using Input = std::span<const std::uint8_t>;

void require(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "broken contract of a decoder: %s\n", what);
    std::abort();
}

template <class T>
bool taken(const Result<T> &result)
{
    require(result.ok() || !result.error().message.empty(), "an error has a sentence");
    return result.ok();
}

bool bridgeInfo(Input bytes)
{
    const auto info = decodeBridgeInfo(bytes);
    if (!taken(info))
        return false;
    require(!info->ranges.empty() && info->ranges.size() <= BRIDGE_RANGES, "info has ranges");
    require(info->lowestRateMilliHz > 0 && info->lowestRateMilliHz <= info->highestRateMilliHz,
            "info has rates");
    require(info->sensor.model.size() <= BRIDGE_MODEL_SIZE &&
                info->sensor.serial.size() <= BRIDGE_SERIAL_SIZE,
            "info has names");
    return true;
}

bool bridgeConfig(Input bytes)
{
    const auto config = decodeBridgeConfig(bytes);
    if (!taken(config))
        return false;
    require(*decodeBridgeConfig(encodeBridgeConfig(*config)) == *config,
            "a configuration makes the round trip");
    return true;
}

bool bridgeStatus(Input bytes)
{
    const auto status = decodeBridgeStatus(bytes);
    if (!taken(status))
        return false;
    require(!status->activeBank || *status->activeBank < BRIDGE_BANKS, "the active bank is one");
    require(!bridgeResultText(status->result).empty() && !bridgeCommandText(status->command).empty() &&
                !bridgeBankStateText(status->banks[0].state).empty(),
            "every number has a text");
    return true;
}

bool bridgeSamples(Input bytes)
{
    const auto samples = decodeBridgeSamples(bytes);
    if (!taken(samples))
        return false;
    require(samples->count >= 1 && samples->count <= static_cast<int>(BRIDGE_SAMPLES_PER_REPORT) &&
                (samples->saturated >> samples->count) == 0,
            "a report has its samples");
    return true;
}

bool bridgeTablePart(Input bytes)
{
    const auto part = decodeBridgeTablePart(bytes);
    if (!taken(part))
        return false;
    require(part->bank < BRIDGE_BANKS && part->bytes.size() <= BRIDGE_READ_BYTES, "a part is of a bank");
    return true;
}

// Counts what it is given and sees that it is in order.
class CheckingSink final : public SampleSink
{
public:
    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        require(count > 0 && count <= block.size(), "a block has its rows");
        require(block.firstSample == given, "blocks follow each other");
        for (Eigen::Index i = 0; i < count; ++i) {
            require(std::isfinite(block.timeS[i]) && block.timeS[i] >= lastS, "time does not go back");
            require(block.rateDps.row(i).allFinite(), "rates are numbers");
            lastS = block.timeS[i];
        }
        given += count;
        return Flow::Continue;
    }
    void gap(const SampleGap &gap) override
    {
        require(gap.lostSamples >= 0 && gap.startS <= gap.endS && gap.startS == lastS,
                "a gap lies in between");
        lost += gap.lostSamples;
    }
    void event(const std::string &sentence) override
    {
        require(!sentence.empty(), "an event has a sentence");
    }

    std::int64_t given = 0;
    std::int64_t lost = 0;
    double lastS = 0.0;
};

bool bridgeStream(Input bytes)
{
    CheckingSink sink;
    BridgeAssembler assembler({{245, 875}, 1000.0, 0.04, false, false}, sink);
    double hostS = 5.0;
    for (; bytes.size() > BRIDGE_REPORT_SIZE; bytes = bytes.subspan(1 + BRIDGE_REPORT_SIZE)) {
        // 255: the device was away.
        hostS += bytes[0] * 0.001;
        if (bytes[0] == 255)
            assembler.restart();
        if (const auto report = decodeBridgeSamples(bytes.subspan(1, BRIDGE_REPORT_SIZE)))
            assembler.add(*report, hostS);
    }
    assembler.flush();
    const SourceStats stats = assembler.stats();
    require(stats.samples == sink.given && stats.lostSamples == sink.lost, "what was counted was given");
    return stats.samples > 0;
}

// What the firmware's own arithmetic takes off.
std::array<std::int32_t, 3> firmwareCounts(Input image, const bridge_table &table, std::uint16_t sensitivity,
                                           std::int32_t milliC)
{
    const bridge_scale scale = bridge_scale_of(&table, sensitivity);
    const bridge_place place = bridge_table_locate(&table, milliC);
    const std::uint8_t *knots = image.data() + BRIDGE_TABLE_VALUES + place.cell * BRIDGE_TABLE_KNOT_SIZE;
    std::array<std::int32_t, 3> counts{};
    std::array<std::int32_t, 3> units{};
    std::array<float, 3> dps{};
    if (table.kind == BRIDGE_TABLE_FIXED)
        bridge_table_units(place, knots, units.data());
    else
        bridge_table_dps(place, knots, dps.data());
    for (std::size_t axis = 0; axis < 3; ++axis)
        counts[axis] = table.kind == BRIDGE_TABLE_FIXED ? bridge_counts_of_units(scale, units[axis])
                                                        : bridge_counts_of_dps(scale, dps[axis]);
    return counts;
}

bool deviceImage(Input bytes)
{
    const auto image = decodeDeviceImage(bytes, "the input");
    if (!taken(image))
        return false;
    bridge_table table;
    require(bridge_table_read(&table, bytes.data()) && bridge_table_bytes(&table) == bytes.size(),
            "the firmware reads what the host reads");
    const std::int32_t middle = static_cast<std::int32_t>(
        (static_cast<std::int64_t>(image->table.firstMilliC) + image->table.lastMilliC) / 2);
    for (const std::uint16_t sensitivity : {std::uint16_t{1}, std::uint16_t{875}, std::uint16_t{65535}}) {
        const DeviceCompensation host(*image, sensitivity);
        for (const std::int32_t milliC : {image->table.firstMilliC, image->table.firstMilliC + 1, middle,
                                          image->table.lastMilliC, INT32_MIN, 0, INT32_MAX})
            require(host.tdeCounts(milliC) == firmwareCounts(bytes, table, sensitivity, milliC),
                    "host and firmware take off the same");
    }
    return true;
}

bool firmware(Input bytes)
{
    bridge_identity identity{};
    identity.capabilities = BRIDGE_CAN_EXTERNAL | BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT | BRIDGE_CAN_PAIR;
    std::copy_n("L3GD20H", 7, identity.model);
    std::copy_n("SIM-0001", 8, identity.serial);
    identity.min_rate_mhz = 1000;
    identity.max_rate_mhz = 1000000;
    identity.ranges = 1;
    identity.range[0] = {245, 875};
    RamFlash flash(512);
    std::array<bridge_report, 3> ring;
    bridge_device device;
    bridge_device_start(&device, &identity, flash.flash(), ring.data(), ring.size());
    bool any = false;
    bridge_sample sample{0, {100, -200, 300}, true, true, 20000, 21000};
    BridgeReport report;
    for (; bytes.size() >= BRIDGE_REPORT_SIZE; bytes = bytes.subspan(BRIDGE_REPORT_SIZE)) {
        any = bridge_device_set(&device, bytes.data(), BRIDGE_REPORT_SIZE) == BRIDGE_RESULT_OK || any;
        sample.time_us += 1000;
        bridge_device_sample(&device, &sample);
        while (bridge_device_take(&device, report.data()))
            require(decodeBridgeSamples(report).ok(), "the host reads the firmware's samples");
        require(bridge_device_get(&device, BRIDGE_REPORT_STATUS, report.data()) &&
                    decodeBridgeStatus(report).ok(),
                "the host reads the firmware's status");
        require(bridge_device_get(&device, BRIDGE_REPORT_READ, report.data()) &&
                    decodeBridgeTablePart(report).ok(),
                "the host reads the firmware's banks");
    }
    require(flash.violations() == 0, "the flash is used as it allows");
    return any;
}

bool within(std::span<const std::uint8_t> part, Input whole)
{
    return part.empty() ||
           (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

bool mcp2221aReplies(Input bytes)
{
    using namespace mcp2221a;
    const auto data = decodeData(bytes);
    require(!data || (within(data->bytes, bytes) && data->bytes.size() <= kDataPerReport),
            "data lie in their report");
    bool accepted = false;
    for (const Command command :
         {Command::Write, Command::Read, Command::ReadAfterRepeatedStart, Command::WriteWithoutStop})
        accepted = decodeAccepted(bytes, command).has_value() || accepted;
    return decodeStatus(bytes).has_value() || data || accepted;
}

bool cp2112Reports(Input bytes)
{
    const auto data = cp2112::decodeData(bytes);
    require(!data || (within(*data, bytes) && data->size() <= cp2112::kDataPerReport),
            "data lie in their report");
    return cp2112::decodeStatus(bytes).has_value() || data;
}

bool ft260Reports(Input bytes)
{
    const auto data = ft260::decodeData(bytes);
    require(!data || (within(*data, bytes) && data->size() <= ft260::kDataPerReport),
            "data lie in their report");
    const bool known = ft260::isFt260(bytes);
    return ft260::decodeSettings(bytes).has_value() || ft260::decodeStatus(bytes).has_value() || data ||
           known;
}

bool stGyro(Input bytes)
{
    using namespace st_gyro;
    for (const std::uint8_t byte : bytes) {
        const FifoState fifo = decodeFifoState(byte);
        require(fifo.samples >= 0 && fifo.samples <= kFifoSamples, "a FIFO holds up to 32 samples");
        require(std::abs(decodeDieCount(byte)) <= 128, "a die count is a byte");
        static_cast<void>(modelOfWhoAmI(byte));
    }
    const std::size_t samples = bytes.size() / kBytesPerSample;
    for (std::size_t i = 0; i < samples; ++i)
        static_cast<void>(saturated(decodeCounts(bytes, i)));
    return samples > 0;
}

bool thermometers(Input bytes)
{
    bool any = false;
    for (; bytes.size() >= 2; bytes = bytes.subspan(2)) {
        const auto value = static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
        const auto fine = tmp117::decodeTemperatureC(value);
        require(!fine || (*fine > -256.0 && *fine < 256.0), "a TMP117 reads below 256 degrees");
        require(std::abs(mcp9808::decodeTemperatureC(value)) <= 256.0, "an MCP9808 reads up to 256 degrees");
        any = true;
    }
    return any;
}

struct Entry
{
    std::string_view name;
    bool (*decode)(Input);
};

constexpr std::array<Entry, static_cast<std::size_t>(DeviceDecoder::Count)> kDecoders{{
    {"bridge_info", bridgeInfo},
    {"bridge_config", bridgeConfig},
    {"bridge_status", bridgeStatus},
    {"bridge_samples", bridgeSamples},
    {"bridge_table_part", bridgeTablePart},
    {"bridge_stream", bridgeStream},
    {"device_image", deviceImage},
    {"firmware", firmware},
    {"mcp2221a", mcp2221aReplies},
    {"cp2112", cp2112Reports},
    {"ft260", ft260Reports},
    {"st_gyro", stGyro},
    {"thermometers", thermometers},
}};

} // namespace

std::string_view decoderName(DeviceDecoder decoder)
{
    return kDecoders[static_cast<std::size_t>(decoder)].name;
}

bool decodeUntrusted(std::span<const std::uint8_t> input)
{
    return !input.empty() && kDecoders[input[0] % kDecoders.size()].decode(input.subspan(1));
}

} // namespace driftbench::test
