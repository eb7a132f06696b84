// The device behind its reports: what it says of itself, how it is configured, and that nothing which a host
// sends brings it down. Uploads are in tst_firmware_upload, the banks in tst_firmware_banks.
#include "support/firmware_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareDevice : public QObject
{
    Q_OBJECT

private slots:
    void start_powerUp_isAsDocumented();
    void info_get_saysWhatTheDeviceIs();
    void get_unknownReport_isRefused();
    void set_unknownOrShort_isRefused();
    void config_fields_areChecked();
    void config_whileStreaming_isBusyForRateAndRange();
    void set_randomReports_neverCrashNorLoseTheTable();
};

void TestFirmwareDevice::start_powerUp_isAsDocumented()
{
    FirmwareBench bench;
    const Report config = bench.device.get(BRIDGE_REPORT_CONFIG);
    QCOMPARE(bridge_get_u32(config.data() + BRIDGE_CONFIG_RATE), 1000000U);
    QCOMPARE(config[BRIDGE_CONFIG_RANGE], std::uint8_t(0));
    QCOMPARE(config[BRIDGE_CONFIG_STREAM], std::uint8_t(0));
    QCOMPARE(config[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(0));
    const DeviceStatus status = bench.device.status();
    QCOMPARE(status.active, std::uint8_t(BRIDGE_NO_BANK));
    QVERIFY(status.banks[0] == BankStatus{} && status.banks[1] == BankStatus{});
    QCOMPARE(bench.device.install(randomImage(bench.random, 9), 1), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(1));
    bench.device.configure(false, false);
    bench.device.powerUp();
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(1));
}

void TestFirmwareDevice::info_get_saysWhatTheDeviceIs()
{
    FirmwareBench bench;
    const Report info = bench.device.get(BRIDGE_REPORT_INFO);
    QCOMPARE(info[BRIDGE_INFO_MAJOR], std::uint8_t(BRIDGE_PROTOCOL_MAJOR));
    QCOMPARE(info[BRIDGE_INFO_MINOR], std::uint8_t(BRIDGE_PROTOCOL_MINOR));
    QCOMPARE(QByteArray(reinterpret_cast<const char *>(info.data()) + BRIDGE_INFO_MODEL),
             QByteArray("L3GD20H"));
    QCOMPARE(QByteArray(reinterpret_cast<const char *>(info.data()) + BRIDGE_INFO_SERIAL),
             QByteArray("SIM-0001"));
    QCOMPARE(bridge_get_u32(info.data() + BRIDGE_INFO_BANK_BYTES), kBankBytes - BRIDGE_BANK_IMAGE_AT);
    QCOMPARE(info[BRIDGE_INFO_RANGES], std::uint8_t(3));
    QCOMPARE(bridge_get_u16(info.data() + BRIDGE_INFO_RANGE_TABLE + 2 * BRIDGE_RANGE_SIZE),
             std::uint16_t(2000));
    QCOMPARE(bridge_get_u16(info.data() + BRIDGE_INFO_RANGE_TABLE + 2), std::uint16_t(875));
}

void TestFirmwareDevice::get_unknownReport_isRefused()
{
    FirmwareBench bench;
    for (int id = 0; id < 256; ++id) {
        Report report;
        const bool readable = id == BRIDGE_REPORT_INFO || id == BRIDGE_REPORT_CONFIG ||
                              id == BRIDGE_REPORT_STATUS || id == BRIDGE_REPORT_READ;
        QCOMPARE(bridge_device_get(&bench.device.device, static_cast<std::uint8_t>(id), report.data()),
                 readable);
    }
}

void TestFirmwareDevice::set_unknownOrShort_isRefused()
{
    FirmwareBench bench;
    for (const int id : {0x00, 0x01, 0x10, 0x12, 0x13, 0x27, 0xFF})
        EXPECT(makeReport(static_cast<std::uint8_t>(id)), UNKNOWN_COMMAND);
    const Report config = bench.device.get(BRIDGE_REPORT_CONFIG);
    for (std::uint32_t length = 0; length < BRIDGE_REPORT_SIZE; ++length) {
        QCOMPARE(bridge_device_set(&bench.device.device, config.data(), length),
                 std::uint8_t(BRIDGE_RESULT_BAD_LENGTH));
    }
    // A driver may pad.
    QCOMPARE(bridge_device_set(&bench.device.device, config.data(), BRIDGE_REPORT_SIZE),
             std::uint8_t(BRIDGE_RESULT_OK));
}

void TestFirmwareDevice::config_fields_areChecked()
{
    FirmwareBench bench;
    const Report good = bench.device.get(BRIDGE_REPORT_CONFIG);
    const auto with = [&](std::size_t at, std::uint8_t value) {
        Report report = good;
        report[at] = value;
        return report;
    };
    EXPECT(good, OK);
    EXPECT(with(BRIDGE_CONFIG_RANGE, 3), BAD_VALUE);
    EXPECT(with(BRIDGE_CONFIG_STREAM, 2), BAD_VALUE);
    EXPECT(with(BRIDGE_CONFIG_COMPENSATE, 2), BAD_VALUE);
    EXPECT(with(BRIDGE_CONFIG_COMPENSATE, 1), NOTHING_THERE);
    for (const std::uint32_t rateMilliHz : {0U, 999U, 1000001U, 0xFFFFFFFFU}) {
        Report report = good;
        bridge_put_u32(report.data() + BRIDGE_CONFIG_RATE, rateMilliHz);
        EXPECT(report, BAD_VALUE);
    }
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG), good);
    EXPECT(with(BRIDGE_CONFIG_RANGE, 2), OK);
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG), with(BRIDGE_CONFIG_RANGE, 2));
}

void TestFirmwareDevice::config_whileStreaming_isBusyForRateAndRange()
{
    FirmwareBench bench;
    Report config = bench.device.get(BRIDGE_REPORT_CONFIG);
    config[BRIDGE_CONFIG_STREAM] = 1;
    EXPECT(config, OK);
    Report changed = config;
    changed[BRIDGE_CONFIG_RANGE] = 1;
    EXPECT(changed, BUSY);
    changed = config;
    bridge_put_u32(changed.data() + BRIDGE_CONFIG_RATE, 500000);
    EXPECT(changed, BUSY);
    changed[BRIDGE_CONFIG_STREAM] = 0;
    EXPECT(changed, OK);
}

void TestFirmwareDevice::set_randomReports_neverCrashNorLoseTheTable()
{
    FirmwareBench bench;
    Random random = announced(20261242);
    const Bytes image = randomImage(random, 6);
    QCOMPARE(bench.device.install(image, 1), std::uint8_t(BRIDGE_RESULT_OK));
    const std::array<std::uint8_t, 9> ids{0x11, 0x20, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26, 0x7F};
    for (int i = 0; i < 300000; ++i) {
        Report report;
        for (std::uint8_t &byte : report)
            byte = static_cast<std::uint8_t>(random.below(4) == 0 ? random.bits() : random.below(3));
        if (random.below(50) != 0)
            report[0] = ids[random.below(ids.size())];
        // Half of the uploads say what a begin could mean, and half of the chunks what could follow.
        if (report[0] == BRIDGE_REPORT_BEGIN && random.below(2) == 0)
            report = beginFor(image, static_cast<std::uint16_t>(random.below(2)));
        if (report[0] == BRIDGE_REPORT_CHUNK && random.below(2) == 0)
            report = chunkReport(static_cast<std::uint16_t>(random.below(2)),
                                 static_cast<std::uint32_t>(56 * random.below(3)), image);
        // Nothing random may revoke the table.
        if (report[0] == BRIDGE_REPORT_ROLLBACK)
            report[BRIDGE_ROLLBACK_GENERATION + 3] |= 0x80;
        bench.device.set(report);
        bridge_sample sample{};
        sample.time_us = static_cast<std::uint32_t>(random.bits());
        sample.die_valid = true;
        sample.die_millic = static_cast<std::int32_t>(random.bits());
        bridge_device_sample(&bench.device.device, &sample);
        Report answer;
        bridge_device_get(&bench.device.device, static_cast<std::uint8_t>(random.bits()), answer.data());
        bridge_device_take(&bench.device.device, answer.data());
        const DeviceStatus status = bench.device.status();
        QVERIFY(status.active < BRIDGE_BANKS && status.banks[status.active].state == BRIDGE_BANK_ACTIVATED);
        QCOMPARE(status.banks[status.active].crc, deviceImageCrc(image));
    }
    QCOMPARE(bench.flash.violations(), 0);
    QCOMPARE(bench.device.image(bench.device.status().active), image);
}

QTEST_APPLESS_MAIN(TestFirmwareDevice)
#include "tst_firmware_device.moc"
