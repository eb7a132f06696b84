#include "app/cli/device_text.h"

#include "app/cli/text_layout.h"
#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <array>
#include <cstdio>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMilli = 1000.0;

std::string inHex(std::uint32_t value)
{
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(value));
    return text.data();
}

std::string line(const std::string &name, const std::string &text)
{
    return wrapped(left(name, 13), text);
}

std::string rangeText(const BridgeRange &range)
{
    return "±" + std::to_string(range.fullScaleDps) + " dps (" + shortest(range.sensitivity / 100.0) +
           " mdps a count)";
}

std::string rangesText(const BridgeInfo &info)
{
    std::string text;
    for (const BridgeRange &range : info.ranges)
        text += (text.empty() ? "" : ", ") + rangeText(range);
    return text;
}

std::string tablesText(const BridgeInfo &info)
{
    std::string kinds = info.can(BRIDGE_CAN_FIXED) ? "fixed point" : "";
    if (info.can(BRIDGE_CAN_FLOAT))
        kinds += std::string(kinds.empty() ? "" : " or ") + "float32";
    const std::uint32_t knots = info.bankBytes > BRIDGE_TABLE_VALUES
                                    ? (info.bankBytes - BRIDGE_TABLE_VALUES) / BRIDGE_TABLE_KNOT_SIZE
                                    : 0;
    return kinds + ", up to " + std::to_string(knots) + " knots";
}

std::string configText(const BridgeConfig &config, const BridgeInfo &info)
{
    return shortest(config.rateMilliHz / kMilli) + " Hz, " +
           (config.range < info.ranges.size() ? rangeText(info.ranges[config.range]) : "unknown range") +
           ", " + (config.stream ? "streaming" : "not streaming") + ", " +
           (config.compensate ? "compensating" : "not compensating");
}

} // namespace

std::string banksAsText(const BridgeStatus &status)
{
    std::string text;
    for (std::uint8_t bank = 0; bank < BRIDGE_BANKS; ++bank) {
        const BridgeBank &each = status.banks[bank];
        std::string what = bridgeBankStateText(each.state);
        if (each.state != BRIDGE_BANK_EMPTY)
            what += ", generation " + std::to_string(each.generation) + ", " + std::to_string(each.bytes) +
                    " bytes, CRC " + inHex(each.crc);
        if (status.activeBank == bank)
            what += ", in use";
        text += line("bank " + std::to_string(bank), what);
    }
    return text;
}

Json banksAsJson(const BridgeStatus &status)
{
    Json banks = Json::array();
    for (std::uint8_t bank = 0; bank < BRIDGE_BANKS; ++bank) {
        const BridgeBank &each = status.banks[bank];
        Json json{{"state", bridgeBankStateText(each.state)}, {"in_use", status.activeBank == bank}};
        if (each.state != BRIDGE_BANK_EMPTY) {
            json["generation"] = each.generation;
            json["bytes"] = each.bytes;
            json["crc32"] = inHex(each.crc);
        }
        banks.push_back(std::move(json));
    }
    return banks;
}

std::string factsAsText(const DeviceFacts &facts)
{
    const BridgeInfo &info = facts.info;
    return line("device", facts.identity.path) + line("gyro", info.sensor.text()) +
           line("protocol", std::to_string(info.major) + "." + std::to_string(info.minor) + ", firmware " +
                                info.firmwareText()) +
           line("sampling", shortest(info.lowestRateMilliHz / kMilli) + " to " +
                                shortest(info.highestRateMilliHz / kMilli) + " Hz") +
           line("ranges", rangesText(info)) +
           line("thermometer", info.can(BRIDGE_CAN_EXTERNAL) ? "on the die, external" : "on the die") +
           line("tables", tablesText(info)) + line("set to", configText(facts.config, info)) +
           line("samples", std::to_string(facts.status.producedSamples) + " taken since power-up, " +
                               std::to_string(facts.status.droppedSamples) + " lost inside the device") +
           banksAsText(facts.status);
}

Json factsAsJson(const DeviceFacts &facts)
{
    const BridgeInfo &info = facts.info;
    Json ranges = Json::array();
    for (const BridgeRange &range : info.ranges)
        ranges.push_back(
            {{"full_scale_dps", range.fullScaleDps}, {"mdps_per_count", range.sensitivity / 100.0}});
    return {{"path", facts.identity.path},
            {"sensor", {{"model", info.sensor.model}, {"serial", info.sensor.serial}}},
            {"protocol", {{"major", info.major}, {"minor", info.minor}}},
            {"firmware", info.firmwareText()},
            {"lowest_rate_hz", info.lowestRateMilliHz / kMilli},
            {"highest_rate_hz", info.highestRateMilliHz / kMilli},
            {"ranges", ranges},
            {"external_thermometer", info.can(BRIDGE_CAN_EXTERNAL)},
            {"bank_bytes", info.bankBytes},
            {"config",
             {{"rate_hz", facts.config.rateMilliHz / kMilli},
              {"range", facts.config.range},
              {"streaming", facts.config.stream},
              {"compensating", facts.config.compensate}}},
            {"samples", facts.status.producedSamples},
            {"lost_inside", facts.status.droppedSamples},
            {"banks", banksAsJson(facts.status)}};
}

std::string checkText(const TableUploadReport &upload)
{
    if (!upload.check)
        return upload.activated ? "Its compensation was not compared: the device can't send raw samples "
                                  "beside compensated "
                                  "ones."
                                : "";
    const CompensationCheck &check = *upload.check;
    if (check.samples == 0)
        return "Nothing could be compared with the host's compensation: " +
               (check.rawSamples > 0 ? "the device sent " + std::to_string(check.rawSamples) +
                                           " samples raw, the table's thermometer is not read."
                                     : std::string("no samples came."));
    const std::string compared = std::to_string(check.samples) + " samples at " +
                                 forReading(check.lowestC, 2) + " to " + forReading(check.highestC, 2) +
                                 " °C, compared bit for bit with the host's compensation: ";
    if (check.differing > 0)
        return compared + std::to_string(check.differing) + " differ, by " +
               std::to_string(check.worstCounts) + " counts (" + shortest(check.worstDps) + " dps) at most.";
    return compared + (check.passed() ? "all equal."
                                      : "all equal, but " + std::to_string(check.wanted) + " were wanted.");
}

namespace {

Json checkAsJson(const TableUploadReport &upload)
{
    if (!upload.check)
        return nullptr;
    const CompensationCheck &check = *upload.check;
    return {{"passed", check.passed()},     {"samples", check.samples},
            {"wanted", check.wanted},       {"raw_samples", check.rawSamples},
            {"differing", check.differing}, {"worst_counts", check.worstCounts},
            {"worst_dps", check.worstDps},  {"lowest_c", check.lowestC},
            {"highest_c", check.highestC}};
}

} // namespace

std::string uploadAsText(const TableUploadReport &upload)
{
    const std::string outcome = upload.activated    ? "is in use now"
                                : upload.rolledBack ? "was rolled back"
                                                    : "is on the device and waits to be activated";
    const std::string check = checkText(upload);
    return "Before\n" + banksAsText(upload.before) + "After\n" + banksAsText(upload.after) + "The table of " +
           std::to_string(upload.bytes) + " bytes, generation " + std::to_string(upload.generation) +
           ", reads back as written and " + outcome + ".\n" + check + (check.empty() ? "" : "\n");
}

Json uploadAsJson(const TableUploadReport &upload)
{
    return {{"bank", upload.bank},
            {"generation", upload.generation},
            {"bytes", upload.bytes},
            {"crc32", inHex(upload.crc)},
            {"verified", true}, // else there is no report
            {"activated", upload.activated},
            {"rolled_back", upload.rolledBack},
            {"check", checkAsJson(upload)},
            {"before", banksAsJson(upload.before)},
            {"after", banksAsJson(upload.after)}};
}

std::string imageAsText(const DeviceImage &image)
{
    std::string axes;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        if (image.table.compensated[axis])
            axes += (axes.empty() ? "" : ", ") + std::string(kAxisNames[axis]);
    }
    return line("sensor", image.table.provenance.sensor.text()) + line("axes", axes) +
           line("kind", image.kind() == DeviceTableKind::FixedPoint ? "fixed point" : "float32") +
           line("thermometer", image.thermometer == DeviceThermometer::Die ? "on the die" : "external") +
           line("table", std::to_string(image.table.size()) + " knots from " +
                             forReading(image.table.firstTemperatureC(), 1) + " to " +
                             forReading(image.table.lastTemperatureC(), 1) + " °C");
}

} // namespace driftbench::cli
