// Bytes of the bridge to values and back, and what damaged bytes give.
#include "device/bridge/bridge_codec.h"
#include "engine/base/random.h"
#include "support/firmware_device.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceCodec : public QObject
{
    Q_OBJECT

private slots:
    void decodeInfo_ofFirmware_saysWhatItIs();
    void decodeInfo_otherMajor_isProtocolVersion();
    void config_anyValues_roundTripsThroughFirmware();
    void commands_anyValues_equalThoseOfTheFirmwareTests();
    void decodeStatus_ofFirmware_hasEveryField();
    void decodeSamples_ofFirmware_hasEveryField();
    void decode_damagedField_namesByteAndValue_data();
    void decode_damagedField_namesByteAndValue();
    void decode_randomBytes_neverReadsOutside();
    void decode_cutReports_areDamaged();
    void rateDps_counts_areExact();
    void resultText_everyResult_differs();
};

namespace {

constexpr std::uint64_t kSeed = 20240611;

Bytes bytesOf(const BridgeReport &report)
{
    return {report.begin(), report.end()};
}

// Every decoder on these bytes; gives how many took them.
int decodeAll(std::span<const std::uint8_t> bytes)
{
    int taken = 0;
    taken += decodeBridgeInfo(bytes).ok() ? 1 : 0;
    taken += decodeBridgeConfig(bytes).ok() ? 1 : 0;
    taken += decodeBridgeStatus(bytes).ok() ? 1 : 0;
    taken += decodeBridgeTablePart(bytes).ok() ? 1 : 0;
    if (const auto samples = decodeBridgeSamples(bytes)) {
        ++taken;
        Q_ASSERT(samples->count >= 1 && samples->count <= 7);
    }
    return taken;
}

} // namespace

void TestDeviceCodec::decodeInfo_ofFirmware_saysWhatItIs()
{
    RamFlash flash(8192);
    FirmwareDevice device(flash);
    const auto info = decodeBridgeInfo(device.get(BRIDGE_REPORT_INFO));
    QVERIFY(info.ok());
    QCOMPARE(info->major, 1);
    QCOMPARE(info->sensor.model, std::string("L3GD20H"));
    QCOMPARE(info->sensor.serial, std::string("SIM-0001"));
    QCOMPARE(info->firmwareText(), std::string("1.0.0"));
    QVERIFY(info->can(BRIDGE_CAN_EXTERNAL) && info->can(BRIDGE_CAN_FIXED) && info->can(BRIDGE_CAN_FLOAT));
    QCOMPARE(info->lowestRateMilliHz, 1000u);
    QCOMPARE(info->highestRateMilliHz, 1000000u);
    QCOMPARE(info->bankBytes, 8192u - BRIDGE_BANK_IMAGE_AT);
    QCOMPARE(info->ranges.size(), 3u);
    QVERIFY((info->ranges[2] == BridgeRange{2000, 7000}));
}

void TestDeviceCodec::decodeInfo_otherMajor_isProtocolVersion()
{
    // Only four bytes of a version that is not known mean anything.
    BridgeReport report;
    report.fill(0xFF);
    report[0] = BRIDGE_REPORT_INFO;
    report[BRIDGE_INFO_MAJOR] = 2;
    report[BRIDGE_INFO_MINOR] = 7;
    const auto info = decodeBridgeInfo(report);
    QVERIFY(!info.ok());
    QCOMPARE(info.error().code, Errc::ProtocolVersion);
    QVERIFY(info.error().message.find("2.7") != std::string::npos);
}

void TestDeviceCodec::config_anyValues_roundTripsThroughFirmware()
{
    RamFlash flash(8192);
    FirmwareDevice device(flash);
    Random random(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const BridgeConfig config{static_cast<std::uint32_t>(1000 + random.below(999001)),
                                  static_cast<std::uint8_t>(random.below(3)), false, false};
        QCOMPARE(device.set(encodeBridgeConfig(config)), BRIDGE_RESULT_OK);
        const auto back = decodeBridgeConfig(device.get(BRIDGE_REPORT_CONFIG));
        QVERIFY(back.ok());
        QVERIFY(*back == config);
    }
    const BridgeConfig all{1, 3, true, true};
    QVERIFY(*decodeBridgeConfig(encodeBridgeConfig(all)) == all);
}

void TestDeviceCodec::commands_anyValues_equalThoseOfTheFirmwareTests()
{
    Random random(kSeed);
    for (int i = 0; i < 200; ++i) {
        const auto transaction = static_cast<std::uint16_t>(random.bits());
        const auto number = static_cast<std::uint32_t>(random.bits());
        const auto crc = static_cast<std::uint32_t>(random.bits());
        Bytes image(1 + random.below(300));
        for (std::uint8_t &byte : image)
            byte = static_cast<std::uint8_t>(random.bits());
        const auto offset = static_cast<std::uint32_t>(random.below(image.size()));
        const std::size_t length = std::min<std::size_t>(BRIDGE_CHUNK_BYTES, image.size() - offset);
        QCOMPARE(encodeBridgeBegin(transaction, number, crc), beginReport(transaction, number, crc));
        QCOMPARE(encodeBridgeChunk(transaction, offset, std::span(image).subspan(offset, length)),
                 chunkReport(transaction, offset, image));
        QCOMPARE(encodeBridgeVerify(transaction), transactionReport(BRIDGE_REPORT_VERIFY, transaction));
        QCOMPARE(encodeBridgeCommit(transaction), transactionReport(BRIDGE_REPORT_COMMIT, transaction));
        QCOMPARE(encodeBridgeActivate(number), generationReport(BRIDGE_REPORT_ACTIVATE, number));
        QCOMPARE(encodeBridgeRollback(number), generationReport(BRIDGE_REPORT_ROLLBACK, number));
    }
}

void TestDeviceCodec::decodeStatus_ofFirmware_hasEveryField()
{
    RamFlash flash(8192);
    FirmwareDevice device(flash);
    Random random(kSeed);
    const auto before = decodeBridgeStatus(device.get(BRIDGE_REPORT_STATUS));
    QVERIFY(before.ok() && !before->activeBank);
    QCOMPARE(device.install(randomImage(random, 9), 7), BRIDGE_RESULT_OK);
    QCOMPARE(device.install(randomImage(random, 5), 8), BRIDGE_RESULT_OK);
    const auto status = decodeBridgeStatus(device.get(BRIDGE_REPORT_STATUS));
    const DeviceStatus expected = device.status();
    QVERIFY(status.ok());
    QCOMPARE(status->command, BRIDGE_REPORT_ACTIVATE);
    QCOMPARE(status->result, BRIDGE_RESULT_OK);
    QCOMPARE(*status->activeBank, expected.active);
    for (std::size_t i = 0; i < BRIDGE_BANKS; ++i) {
        QCOMPARE(status->banks[i].state, expected.banks[i].state);
        QCOMPARE(status->banks[i].generation, expected.banks[i].generation);
        QCOMPARE(status->banks[i].bytes, expected.banks[i].bytes);
        QCOMPARE(status->banks[i].crc, expected.banks[i].crc);
    }
}

void TestDeviceCodec::decodeSamples_ofFirmware_hasEveryField()
{
    RamFlash flash(8192);
    FirmwareDevice device(flash);
    QCOMPARE(device.configure(true, false), BRIDGE_RESULT_OK);
    bridge_device_lost(&device.device, 3);
    for (int i = 0; i < 4; ++i) {
        bridge_sample sample{};
        sample.time_us = 0xFFFFFFF0u + 1000u * static_cast<std::uint32_t>(i);
        sample.counts[0] = static_cast<std::int16_t>(-i);
        sample.counts[2] = i == 2 ? INT16_MIN : INT16_C(100);
        sample.external_valid = true;
        sample.external_millic = -12345;
        bridge_device_sample(&device.device, &sample);
    }
    bridge_stream_flush(&device.device.stream);
    Report report;
    QVERIFY(bridge_device_take(&device.device, report.data()));
    const auto samples = decodeBridgeSamples(report);
    QVERIFY(samples.ok());
    QCOMPARE(samples->count, 4);
    QCOMPARE(samples->timeUs, 0xFFFFFFF0u);
    QCOMPARE(samples->intervalNs, 1000000u);
    QVERIFY(samples->has(BRIDGE_FLAG_OVERRUN) && !samples->has(BRIDGE_FLAG_COMPENSATED));
    QVERIFY(!samples->dieMilliC);
    QCOMPARE(*samples->externalMilliC, -12345);
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(samples->counts[i][0], static_cast<std::int16_t>(-static_cast<int>(i)));
        QCOMPARE(samples->isSaturated(static_cast<int>(i)), i == 2);
    }
}

void TestDeviceCodec::decode_damagedField_namesByteAndValue_data()
{
    QTest::addColumn<int>("report");
    QTest::addColumn<int>("byte");
    QTest::addColumn<int>("value");
    QTest::newRow("samples: id") << 0x01 << 0 << 0x02;
    QTest::newRow("samples: none") << 0x01 << 2 << 0;
    QTest::newRow("samples: too many") << 0x01 << 2 << 8;
    QTest::newRow("samples: saturation of one that is not there") << 0x01 << 3 << 0x04;
    QTest::newRow("info: id") << 0x10 << 0 << 0;
    QTest::newRow("info: no range") << 0x10 << 7 << 0;
    QTest::newRow("info: too many ranges") << 0x10 << 7 << 5;
    QTest::newRow("info: letter") << 0x10 << 9 << 0x07;
    QTest::newRow("info: letter of the serial number") << 0x10 << 20 << 0xC3;
    QTest::newRow("config: range") << 0x11 << 5 << 4;
    QTest::newRow("config: stream") << 0x11 << 6 << 2;
    QTest::newRow("config: compensate") << 0x11 << 7 << 255;
    QTest::newRow("status: active") << 0x12 << 3 << 2;
    QTest::newRow("table: bank") << 0x22 << 1 << 2;
    QTest::newRow("table: length") << 0x22 << 6 << 57;
}

void TestDeviceCodec::decode_damagedField_namesByteAndValue()
{
    QFETCH(int, report);
    QFETCH(int, byte);
    QFETCH(int, value);
    RamFlash flash(8192);
    FirmwareDevice device(flash);
    Report bytes = device.get(static_cast<std::uint8_t>(report));
    if (report == 0x01) {
        bytes = makeReport(0x01);
        bytes[BRIDGE_SAMPLES_COUNT] = 2;
        bytes[BRIDGE_SAMPLES_INTERVAL] = 1;
    }
    QCOMPARE(decodeAll(bytes), 1);
    bytes[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(value);
    Error error{Errc::Cancelled, {}};
    switch (report) {
    case 0x01:
        error = decodeBridgeSamples(bytes).error();
        break;
    case 0x10:
        error = decodeBridgeInfo(bytes).error();
        break;
    case 0x11:
        error = decodeBridgeConfig(bytes).error();
        break;
    case 0x12:
        error = decodeBridgeStatus(bytes).error();
        break;
    default:
        error = decodeBridgeTablePart(bytes).error();
    }
    QCOMPARE(error.code, Errc::DamagedReport);
    const QString message = QString::fromStdString(error.message);
    QVERIFY2(message.contains(QString("byte %1 holds ").arg(byte)), qPrintable(message));
    const QString hex = QString("0x%1").arg(value, 2, 16, QLatin1Char('0'));
    QVERIFY2(message.contains(QString("holds %1,").arg(value)) || message.contains(hex), qPrintable(message));
}

void TestDeviceCodec::decode_randomBytes_neverReadsOutside()
{
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    constexpr std::uint8_t kIds[] = {0x01, 0x10, 0x11, 0x12, 0x22};
    int taken = 0;
    for (int i = 0; i < 200000; ++i) {
        // On the heap and exactly as long as it says, so that a sanitizer sees any byte too far.
        Bytes bytes(random.below(4) == 0 ? random.below(70) : BRIDGE_REPORT_SIZE);
        for (std::uint8_t &byte : bytes)
            byte = static_cast<std::uint8_t>(random.below(3) == 0 ? random.below(9) : random.bits());
        if (!bytes.empty() && random.below(8) != 0)
            bytes[0] = kIds[random.below(5)];
        taken += decodeAll(bytes);
    }
    QVERIFY(taken > 1000);
}

void TestDeviceCodec::decode_cutReports_areDamaged()
{
    for (const std::uint8_t id : {0x01, 0x10, 0x11, 0x12, 0x22}) {
        for (std::size_t size = 0; size < BRIDGE_REPORT_SIZE; ++size) {
            Bytes bytes(size, 1);
            if (size > 0)
                bytes[0] = id;
            QCOMPARE(decodeAll(bytes), 0);
        }
    }
    Bytes padded = bytesOf(encodeBridgeConfig({1000, 0, false, false}));
    padded.resize(100, 0xEE);
    QVERIFY(decodeBridgeConfig(padded).ok());
}

void TestDeviceCodec::rateDps_counts_areExact()
{
    QCOMPARE((BridgeRange{245, 875}).rateDps(1000), 8.75);
    QCOMPARE((BridgeRange{245, 875}).rateDps(-32768), -286.72);
    QCOMPARE((BridgeRange{2000, 7000}).rateDps(32767), 2293.69);
}

void TestDeviceCodec::resultText_everyResult_differs()
{
    QSet<QString> texts;
    for (std::uint8_t result = 0; result < 17; ++result)
        texts.insert(QString::fromStdString(bridgeResultText(result)));
    QCOMPARE(texts.size(), 17);
}

QTEST_APPLESS_MAIN(TestDeviceCodec)
#include "tst_device_codec.moc"
