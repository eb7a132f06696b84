// The device behind its reports: every result code is reached by what it stands for, and nothing that a host
// sends brings it down.
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>
#include <cstring>

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
    void upload_wrongOrder_isRefused();
    void upload_wrongLengths_areRefused();
    void upload_repeatedChunk_isARepeatIfBytesAgree();
    void upload_flashRefusal_endsIt();
    void upload_otherSensor_isRefusedBeforeErasing();
    void upload_unusableTable_isRefusedBeforeErasing_data();
    void upload_unusableTable_isRefusedBeforeErasing();
    void verify_otherBytesThanAnnounced_isBadCrc();
    void verify_badKnot_isBadTable();
    void commit_repeated_isHarmless();
    void activate_and_rollback_followGenerations();
    void begin_lastGeneration_isFull();
    void read_bankAndLimits_areChecked();
    void read_flashFailure_isTold();
    void bank_ofAnotherSensor_isForeign();
    void set_randomReports_neverCrashNorLoseTheTable();
};

namespace {

constexpr std::uint32_t kBankBytes = 4096;

struct Bench
{
    RamFlash flash{kBankBytes};
    FirmwareDevice device{flash};
    Random random{20261241};
};

int result(FirmwareDevice &device, const Report &report)
{
    const int given = device.set(report);
    const DeviceStatus status = device.status();
    return status.result == given && status.command == report[0] ? given : -1;
}

Report verify(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_VERIFY, transaction);
}

Report commit(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_COMMIT, transaction);
}

Report beginFor(const Bytes &image, std::uint16_t transaction)
{
    return beginReport(transaction, static_cast<std::uint32_t>(image.size()), deviceImageCrc(image));
}

Report activate(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ACTIVATE, generation);
}

Report rollback(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ROLLBACK, generation);
}

} // namespace

#define EXPECT(report, code) QCOMPARE(result(bench.device, report), int(BRIDGE_RESULT_##code))

void TestFirmwareDevice::start_powerUp_isAsDocumented()
{
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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

void TestFirmwareDevice::upload_wrongOrder_isRefused()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 20);
    EXPECT(chunkReport(7, 0, image), NO_UPLOAD);
    EXPECT(verify(7), NO_UPLOAD);
    EXPECT(commit(7), NO_UPLOAD);
    EXPECT(beginFor(image, 7), OK);
    EXPECT(verify(7), INCOMPLETE);
    EXPECT(commit(7), NOT_VERIFIED);
    EXPECT(chunkReport(8, 0, image), WRONG_UPLOAD);
    EXPECT(verify(8), WRONG_UPLOAD);
    EXPECT(commit(8), WRONG_UPLOAD);
    EXPECT(chunkReport(7, 56, image), WRONG_OFFSET);
    EXPECT(chunkReport(7, 0, image), OK);
    EXPECT(chunkReport(7, 112, image), WRONG_OFFSET);
    QCOMPARE(bench.device.status().received, 56U);
    EXPECT(commit(7), NOT_VERIFIED);
    EXPECT(verify(7), INCOMPLETE);
    // Another begin starts anew.
    EXPECT(beginFor(image, 9), OK);
    QCOMPARE(bench.device.status().received, 0U);
    EXPECT(chunkReport(7, 56, image), WRONG_UPLOAD);
    EXPECT(chunkReport(9, 56, image), WRONG_OFFSET);
}

void TestFirmwareDevice::upload_wrongLengths_areRefused()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 20);
    const std::uint32_t most = kBankBytes - BRIDGE_BANK_IMAGE_AT;
    for (const std::uint32_t bytes : {0U, 55U, 56U, 68U, 81U, most + 1, 0xFFFFFFFFU})
        EXPECT(beginReport(1, bytes, 0), BAD_LENGTH);
    EXPECT(beginFor(image, 1), OK);
    for (const int length : {0, 8, 55, 57, 255}) {
        Report chunk = chunkReport(1, 0, image);
        chunk[BRIDGE_CHUNK_LENGTH] = static_cast<std::uint8_t>(length);
        EXPECT(chunk, BAD_LENGTH);
    }
    Report odd = chunkReport(1, 0, image);
    EXPECT(odd, OK);
    bridge_put_u32(odd.data() + BRIDGE_CHUNK_OFFSET, 8);
    EXPECT(odd, WRONG_OFFSET);
}

void TestFirmwareDevice::upload_repeatedChunk_isARepeatIfBytesAgree()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 20);
    Bytes other = image;
    other[60] ^= 1;
    EXPECT(beginFor(image, 1), OK);
    EXPECT(chunkReport(1, 0, image), OK);
    EXPECT(chunkReport(1, 0, image), OK);
    EXPECT(chunkReport(1, 56, image), OK);
    EXPECT(chunkReport(1, 56, image), OK);
    EXPECT(chunkReport(1, 0, image), OK);
    EXPECT(chunkReport(1, 56, other), WRONG_OFFSET);
    QCOMPARE(bench.device.status().received, 112U);
    for (std::uint32_t offset = 112; offset < image.size(); offset += 56)
        EXPECT(chunkReport(1, offset, image), OK);
    EXPECT(verify(1), OK);
    EXPECT(chunkReport(1, 56, image), OK);
    Report past = chunkReport(1, 0, image);
    bridge_put_u32(past.data() + BRIDGE_CHUNK_OFFSET, 56 * 6);
    EXPECT(past, WRONG_OFFSET);
    EXPECT(commit(1), OK);
    EXPECT(chunkReport(1, 56, image), NO_UPLOAD);
    QCOMPARE(bench.device.image(0), image);
    QCOMPARE(bench.flash.violations(), 0);
}

void TestFirmwareDevice::upload_flashRefusal_endsIt()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 20);
    EXPECT(beginFor(image, 1), OK);
    EXPECT(chunkReport(1, 0, image), OK);
    bench.flash.refuseAt(3);
    EXPECT(chunkReport(1, 56, image), FLASH);
    QCOMPARE(bench.device.status().received, 0U);
    // Half of that chunk stands there and can't be programmed again.
    EXPECT(chunkReport(1, 56, image), NO_UPLOAD);
    QCOMPARE(bench.device.install(image, 2), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(bench.flash.violations(), 0);
}

void TestFirmwareDevice::upload_otherSensor_isRefusedBeforeErasing()
{
    Bench bench;
    const Bytes first = randomImage(bench.random, 5);
    const Bytes second = randomImage(bench.random, 5);
    QCOMPARE(bench.device.install(first, 1), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(bench.device.install(second, 2), std::uint8_t(BRIDGE_RESULT_OK));
    for (const std::size_t at : {BRIDGE_TABLE_MODEL, BRIDGE_TABLE_SERIAL, BRIDGE_TABLE_SERIAL + 15U}) {
        Bytes image = randomImage(bench.random, 5);
        image[at] ^= 1;
        EXPECT(beginFor(image, 3), OK);
        EXPECT(chunkReport(3, 0, image), OTHER_SENSOR);
        EXPECT(chunkReport(3, 56, image), NO_UPLOAD);
    }
    // The table of before is still there to go back to.
    QCOMPARE(bench.device.rollback(), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(bench.device.image(bench.device.status().active), first);
}

void TestFirmwareDevice::upload_unusableTable_isRefusedBeforeErasing_data()
{
    QTest::addColumn<int>("at");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("capabilities");
    const int all = BRIDGE_CAN_EXTERNAL | BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT;
    QTest::newRow("magic") << int(BRIDGE_TABLE_MAGIC) << 0 << all;
    QTest::newRow("newer version") << int(BRIDGE_TABLE_VERSION) << 2 << all;
    QTest::newRow("no axis") << int(BRIDGE_TABLE_AXES) << 0 << all;
    QTest::newRow("more knots than announced") << int(BRIDGE_TABLE_KNOTS) << 6 << all;
    QTest::newRow("float where only fixed point runs") << -1 << 0 << int(BRIDGE_CAN_FIXED);
    QTest::newRow("no external thermometer")
        << int(BRIDGE_TABLE_THERMOMETER) << 1 << int(BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT);
}

void TestFirmwareDevice::upload_unusableTable_isRefusedBeforeErasing()
{
    QFETCH(int, at);
    QFETCH(int, value);
    QFETCH(int, capabilities);
    Bench bench;
    bench.device.identity.capabilities = static_cast<std::uint8_t>(capabilities);
    bench.device.powerUp();
    Bytes image = randomImage(bench.random, 5, DeviceTableKind::Float);
    if (at >= 0)
        image[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
    const int operations = bench.flash.operations();
    EXPECT(beginFor(image, 1), OK);
    EXPECT(chunkReport(1, 0, image), BAD_TABLE);
    QCOMPARE(bench.flash.operations(), operations);
}

void TestFirmwareDevice::verify_otherBytesThanAnnounced_isBadCrc()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 5);
    EXPECT(beginReport(1, static_cast<std::uint32_t>(image.size()), deviceImageCrc(image) ^ 1), OK);
    for (std::uint32_t offset = 0; offset < image.size(); offset += 56)
        EXPECT(chunkReport(1, offset, image), OK);
    EXPECT(verify(1), BAD_CRC);
    EXPECT(commit(1), NO_UPLOAD);
    QCOMPARE(bench.device.status().banks[0].state, std::uint8_t(BRIDGE_BANK_EMPTY));
}

void TestFirmwareDevice::verify_badKnot_isBadTable()
{
    Bench bench;
    Bytes image = randomImage(bench.random, 5);
    bridge_put_u32(image.data() + BRIDGE_TABLE_VALUES + 24, 0x40000000);
    EXPECT(beginFor(image, 1), OK);
    for (std::uint32_t offset = 0; offset < image.size(); offset += 56)
        EXPECT(chunkReport(1, offset, image), OK);
    EXPECT(verify(1), BAD_TABLE);
}

void TestFirmwareDevice::commit_repeated_isHarmless()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 5);
    for (const Report &report : uploadReports(image, 4))
        EXPECT(report, OK);
    const int operations = bench.flash.operations();
    EXPECT(commit(4), OK);
    QCOMPARE(bench.flash.operations(), operations);
    EXPECT(commit(5), NO_UPLOAD);
}

void TestFirmwareDevice::activate_and_rollback_followGenerations()
{
    Bench bench;
    EXPECT(activate(1), NOTHING_THERE);
    EXPECT(rollback(1), NOTHING_THERE);
    QCOMPARE(bench.device.install(randomImage(bench.random, 5), 1), std::uint8_t(BRIDGE_RESULT_OK));
    EXPECT(activate(1), OK);
    for (const Report &report : uploadReports(randomImage(bench.random, 6), 2))
        EXPECT(report, OK);
    EXPECT(rollback(2), NOTHING_THERE);
    EXPECT(activate(2), OK);
    QCOMPARE(bench.device.status().active, std::uint8_t(1));
    EXPECT(activate(1), BAD_VALUE);
    EXPECT(rollback(1), NOTHING_THERE);
    EXPECT(rollback(2), OK);
    EXPECT(rollback(2), OK);
    QCOMPARE(bench.device.status().active, std::uint8_t(0));
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(1));
    EXPECT(rollback(1), OK);
    QCOMPARE(bench.device.status().active, std::uint8_t(BRIDGE_NO_BANK));
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(0));
    EXPECT(activate(2), OK);
    QCOMPARE(bench.device.status().active, std::uint8_t(1));
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_COMPENSATE], std::uint8_t(1));
}

void TestFirmwareDevice::begin_lastGeneration_isFull()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 5);
    bridge_bank bank{};
    const bridge_sensor sensor{bench.device.identity.model, bench.device.identity.serial};
    for (std::uint32_t at = 0; at < image.size(); at += 8) {
        const std::uint32_t count = std::min<std::uint32_t>(8, static_cast<std::uint32_t>(image.size()) - at);
        QCOMPARE(bridge_bank_program(bench.flash.flash(), 0, at, image.data() + at, count),
                 std::uint8_t(BRIDGE_RESULT_OK));
    }
    QCOMPARE(bridge_bank_commit(&bank, bench.flash.flash(), 0, UINT32_MAX,
                                static_cast<std::uint32_t>(image.size()), deviceImageCrc(image), sensor),
             std::uint8_t(BRIDGE_RESULT_OK));
    bench.device.powerUp();
    EXPECT(beginFor(image, 1), FULL);
}

void TestFirmwareDevice::read_bankAndLimits_areChecked()
{
    Bench bench;
    const Bytes image = randomImage(bench.random, 6);
    QCOMPARE(bench.device.install(image, 1), std::uint8_t(BRIDGE_RESULT_OK));
    Report choice = makeReport(BRIDGE_REPORT_READ);
    EXPECT(choice, BAD_LENGTH);
    choice[BRIDGE_READ_LENGTH] = 57;
    EXPECT(choice, BAD_LENGTH);
    choice[BRIDGE_READ_LENGTH] = 56;
    choice[BRIDGE_READ_BANK] = 2;
    EXPECT(choice, BAD_VALUE);
    choice[BRIDGE_READ_BANK] = 0;
    bridge_put_u32(choice.data() + BRIDGE_READ_OFFSET, 120);
    EXPECT(choice, OK);
    QCOMPARE(bench.device.get(BRIDGE_REPORT_READ)[BRIDGE_READ_LENGTH], std::uint8_t(8));
    for (const std::uint32_t offset : {128U, 4096U, 0xFFFFFFFFU}) {
        bridge_put_u32(choice.data() + BRIDGE_READ_OFFSET, offset);
        EXPECT(choice, OK);
        QCOMPARE(bench.device.get(BRIDGE_REPORT_READ)[BRIDGE_READ_LENGTH], std::uint8_t(0));
    }
    // An image that is being uploaded can be read back before it is committed.
    const Bytes next = randomImage(bench.random, 6);
    EXPECT(beginFor(next, 2), OK);
    EXPECT(chunkReport(2, 0, next), OK);
    QCOMPARE(bench.device.image(1), Bytes(next.begin(), next.begin() + 56));
}

void TestFirmwareDevice::read_flashFailure_isTold()
{
    Bench bench;
    QCOMPARE(bench.device.install(randomImage(bench.random, 6), 1), std::uint8_t(BRIDGE_RESULT_OK));
    Report choice = makeReport(BRIDGE_REPORT_READ);
    choice[BRIDGE_READ_LENGTH] = 56;
    EXPECT(choice, OK);
    bench.flash.refuseReads(true);
    QCOMPARE(bench.device.get(BRIDGE_REPORT_READ)[BRIDGE_READ_LENGTH], std::uint8_t(0));
    QCOMPARE(bench.device.status().result, std::uint8_t(BRIDGE_RESULT_FLASH));
}

void TestFirmwareDevice::bank_ofAnotherSensor_isForeign()
{
    Bench bench;
    QCOMPARE(bench.device.install(randomImage(bench.random, 6), 1), std::uint8_t(BRIDGE_RESULT_OK));
    bench.device.identity.serial[0] = 'T';
    bench.device.powerUp();
    const DeviceStatus status = bench.device.status();
    QCOMPARE(status.banks[0].state, std::uint8_t(BRIDGE_BANK_FOREIGN));
    QCOMPARE(status.banks[0].generation, 1U);
    QCOMPARE(status.active, std::uint8_t(BRIDGE_NO_BANK));
    EXPECT(activate(1), OTHER_SENSOR);
    EXPECT(rollback(1), NOTHING_THERE);
}

void TestFirmwareDevice::set_randomReports_neverCrashNorLoseTheTable()
{
    Bench bench;
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
