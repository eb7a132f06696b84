// The reference firmware on a flash in memory, driven as a host drives it: by reports.
#pragma once

#include "device/firmware/bridge_device.h"
#include "device/ram_flash.h"
#include "engine/compensation/compensation_table.h"
#include "engine/exports/device_image.h"

#include <array>
#include <optional>
#include <vector>

namespace driftbench::test {

using Bytes = std::vector<std::uint8_t>;
using Report = std::array<std::uint8_t, BRIDGE_REPORT_SIZE>;

struct BankStatus
{
    std::uint8_t state;
    std::uint32_t generation;
    std::uint32_t bytes;
    std::uint32_t crc;
    bool operator==(const BankStatus &) const = default;
};

struct DeviceStatus
{
    std::uint8_t command;
    std::uint8_t result;
    std::uint8_t active;
    std::uint32_t produced;
    std::uint32_t dropped;
    std::uint32_t received;
    std::array<BankStatus, BRIDGE_BANKS> banks;
};

class FirmwareDevice
{
public:
    static constexpr std::uint32_t kRingSize = 4;

    explicit FirmwareDevice(RamFlash &flash);

    void powerUp(); // also of the flash; as after a reset
    std::uint8_t set(const Report &report);
    Report get(std::uint8_t id); // one that the device gives
    DeviceStatus status();
    Bytes image(std::uint8_t bank); // by read reports
    std::uint8_t configure(bool stream, bool compensate);

    // Sends the reports until one is refused or the power goes; the number that were answered OK.
    int send(const std::vector<Report> &reports);
    // Uploads and activates; the result of what failed or OK.
    std::uint8_t install(const Bytes &image, std::uint16_t transaction);
    std::uint8_t rollback();

    bridge_identity identity;
    bridge_device device;
    std::array<bridge_report, kRingSize> ring;

private:
    RamFlash &m_flash;
};

Report makeReport(std::uint8_t id);
Report beginReport(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc);
Report chunkReport(std::uint16_t transaction, std::uint32_t offset, const Bytes &image);
Report transactionReport(std::uint8_t id, std::uint16_t transaction);             // verify, commit
Report generationReport(std::uint8_t id, std::uint32_t generation);               // activate, rollback
std::vector<Report> uploadReports(const Bytes &image, std::uint16_t transaction); // begin .. commit

// A table with random values for the sensor of FirmwareDevice, and its image.
CompensationTable randomTable(Random &random, int knots, double scaleDps = 1.0);
Bytes randomImage(Random &random, int knots, DeviceTableKind kind = DeviceTableKind::FixedPoint);
Bytes imageOf(const CompensationTable &table, DeviceTableKind kind,
              DeviceThermometer thermometer = DeviceThermometer::Die);

} // namespace driftbench::test
