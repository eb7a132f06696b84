#include "support/firmware_device.h"

#include <algorithm>
#include <cstring>

namespace driftbench::test {

FirmwareDevice::FirmwareDevice(RamFlash &flash) : m_flash(flash)
{
    identity = {};
    identity.firmware[0] = 1;
    identity.capabilities = BRIDGE_CAN_EXTERNAL | BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT | BRIDGE_CAN_PAIR;
    std::memcpy(identity.model, "L3GD20H", 7);
    std::memcpy(identity.serial, "SIM-0001", 8);
    identity.min_rate_mhz = 1000;
    identity.max_rate_mhz = 1000000;
    identity.ranges = 3;
    identity.range[0] = {245, 875};
    identity.range[1] = {500, 1750};
    identity.range[2] = {2000, 7000};
    powerUp();
}

void FirmwareDevice::powerUp()
{
    m_flash.powerUp();
    // Memory after a reset holds anything.
    std::memset(&device, 0xA5, sizeof device);
    bridge_device_start(&device, &identity, m_flash.flash(), ring.data(), kRingSize);
}

std::uint8_t FirmwareDevice::set(const Report &report)
{
    return bridge_device_set(&device, report.data(), BRIDGE_REPORT_SIZE);
}

Report FirmwareDevice::get(std::uint8_t id)
{
    Report report{};
    bridge_device_get(&device, id, report.data());
    return report;
}

DeviceStatus FirmwareDevice::status()
{
    const Report report = get(BRIDGE_REPORT_STATUS);
    const std::uint8_t *bytes = report.data();
    DeviceStatus status{bytes[BRIDGE_STATUS_COMMAND],
                        bytes[BRIDGE_STATUS_RESULT],
                        bytes[BRIDGE_STATUS_ACTIVE],
                        bridge_get_u32(bytes + BRIDGE_STATUS_PRODUCED),
                        bridge_get_u32(bytes + BRIDGE_STATUS_DROPPED),
                        bridge_get_u32(bytes + BRIDGE_STATUS_RECEIVED),
                        {}};
    for (std::size_t i = 0; i < BRIDGE_BANKS; ++i) {
        const std::uint8_t *at = bytes + BRIDGE_STATUS_BANKS + i * BRIDGE_STATUS_BANK_SIZE;
        status.banks[i] = {bytes[BRIDGE_STATUS_BANK_STATES + i], bridge_get_u32(at), bridge_get_u32(at + 4),
                           bridge_get_u32(at + 8)};
    }
    return status;
}

Bytes FirmwareDevice::image(std::uint8_t bank)
{
    Bytes image;
    for (;;) {
        Report choice = makeReport(BRIDGE_REPORT_READ);
        choice[BRIDGE_READ_BANK] = bank;
        bridge_put_u32(choice.data() + BRIDGE_READ_OFFSET, static_cast<std::uint32_t>(image.size()));
        choice[BRIDGE_READ_LENGTH] = BRIDGE_READ_BYTES;
        if (set(choice) != BRIDGE_RESULT_OK)
            return {};
        const Report answer = get(BRIDGE_REPORT_READ);
        const std::uint8_t length = answer[BRIDGE_READ_LENGTH];
        if (length == 0)
            return image;
        const std::uint8_t *data = answer.data() + BRIDGE_READ_DATA;
        image.insert(image.end(), data, data + length);
    }
}

std::uint8_t FirmwareDevice::configure(bool stream, bool compensate)
{
    Report config = get(BRIDGE_REPORT_CONFIG);
    config[BRIDGE_CONFIG_STREAM] = stream ? 1 : 0;
    config[BRIDGE_CONFIG_COMPENSATE] = compensate ? 1 : 0;
    return set(config);
}

int FirmwareDevice::send(const std::vector<Report> &reports)
{
    int answered = 0;
    for (const Report &report : reports) {
        if (set(report) != BRIDGE_RESULT_OK || !m_flash.hasPower())
            break;
        ++answered;
    }
    return answered;
}

std::uint8_t FirmwareDevice::install(const Bytes &image, std::uint16_t transaction)
{
    for (const Report &report : uploadReports(image, transaction)) {
        const std::uint8_t result = set(report);
        if (result != BRIDGE_RESULT_OK)
            return result;
    }
    const DeviceStatus now = status();
    const std::uint32_t newest = std::max(now.banks[0].generation, now.banks[1].generation);
    return set(generationReport(BRIDGE_REPORT_ACTIVATE, newest));
}

std::uint8_t FirmwareDevice::rollback()
{
    const DeviceStatus now = status();
    if (now.active == BRIDGE_NO_BANK)
        return BRIDGE_RESULT_NOTHING_THERE;
    return set(generationReport(BRIDGE_REPORT_ROLLBACK, now.banks[now.active].generation));
}

Report makeReport(std::uint8_t id)
{
    Report report{};
    report[0] = id;
    return report;
}

Report beginReport(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc)
{
    Report report = makeReport(BRIDGE_REPORT_BEGIN);
    bridge_put_u16(report.data() + BRIDGE_BEGIN_TRANSACTION, transaction);
    bridge_put_u32(report.data() + BRIDGE_BEGIN_BYTES, bytes);
    bridge_put_u32(report.data() + BRIDGE_BEGIN_CRC, crc);
    return report;
}

Report chunkReport(std::uint16_t transaction, std::uint32_t offset, const Bytes &image)
{
    Report report = makeReport(BRIDGE_REPORT_CHUNK);
    const std::size_t length = std::min<std::size_t>(BRIDGE_CHUNK_BYTES, image.size() - offset);
    bridge_put_u16(report.data() + BRIDGE_CHUNK_TRANSACTION, transaction);
    bridge_put_u32(report.data() + BRIDGE_CHUNK_OFFSET, offset);
    report[BRIDGE_CHUNK_LENGTH] = static_cast<std::uint8_t>(length);
    std::copy_n(image.begin() + offset, length, report.begin() + BRIDGE_CHUNK_DATA);
    return report;
}

Report transactionReport(std::uint8_t id, std::uint16_t transaction)
{
    Report report = makeReport(id);
    bridge_put_u16(report.data() + BRIDGE_VERIFY_TRANSACTION, transaction);
    return report;
}

Report generationReport(std::uint8_t id, std::uint32_t generation)
{
    Report report = makeReport(id);
    bridge_put_u32(report.data() + BRIDGE_ACTIVATE_GENERATION, generation);
    return report;
}

std::vector<Report> uploadReports(const Bytes &image, std::uint16_t transaction)
{
    std::vector<Report> reports{
        beginReport(transaction, static_cast<std::uint32_t>(image.size()), deviceImageCrc(image))};
    for (std::uint32_t offset = 0; offset < image.size(); offset += BRIDGE_CHUNK_BYTES)
        reports.push_back(chunkReport(transaction, offset, image));
    reports.push_back(transactionReport(BRIDGE_REPORT_VERIFY, transaction));
    reports.push_back(transactionReport(BRIDGE_REPORT_COMMIT, transaction));
    return reports;
}

CompensationTable randomTable(Random &random, int knots, double scaleDps)
{
    CompensationTable table;
    table.firstMilliC = static_cast<std::int32_t>(random.below(100000)) - 80000;
    table.lastMilliC = table.firstMilliC + (knots - 1) + static_cast<std::int32_t>(random.below(150000));
    table.compensated = {true, true, random.below(2) == 0};
    table.provenance.sensor = {"L3GD20H", "SIM-0001"};
    table.tdeDps = Eigen::MatrixX3d::Zero(knots, 3);
    for (int i = 0; i < knots; ++i) {
        table.tdeDps.row(i) << scaleDps * random.normal(), scaleDps * random.uniform(-1.0, 1.0),
            table.compensated[2] ? scaleDps * random.normal() : 0.0;
    }
    return table;
}

Bytes imageOf(const CompensationTable &table, DeviceTableKind kind, DeviceThermometer thermometer)
{
    return *encodeDeviceImage(table, kind, thermometer);
}

Bytes randomImage(Random &random, int knots, DeviceTableKind kind)
{
    return imageOf(randomTable(random, knots), kind);
}

} // namespace driftbench::test
