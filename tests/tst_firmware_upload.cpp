// A table on its way through the device's reports: every result code is reached by what it stands for.
#include "support/firmware_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareUpload : public QObject
{
    Q_OBJECT

private slots:
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
    void begin_lastGeneration_isFull();
};

void TestFirmwareUpload::upload_wrongOrder_isRefused()
{
    FirmwareBench bench;
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

void TestFirmwareUpload::upload_wrongLengths_areRefused()
{
    FirmwareBench bench;
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

void TestFirmwareUpload::upload_repeatedChunk_isARepeatIfBytesAgree()
{
    FirmwareBench bench;
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

void TestFirmwareUpload::upload_flashRefusal_endsIt()
{
    FirmwareBench bench;
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

void TestFirmwareUpload::upload_otherSensor_isRefusedBeforeErasing()
{
    FirmwareBench bench;
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

void TestFirmwareUpload::upload_unusableTable_isRefusedBeforeErasing_data()
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

void TestFirmwareUpload::upload_unusableTable_isRefusedBeforeErasing()
{
    QFETCH(int, at);
    QFETCH(int, value);
    QFETCH(int, capabilities);
    FirmwareBench bench;
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

void TestFirmwareUpload::verify_otherBytesThanAnnounced_isBadCrc()
{
    FirmwareBench bench;
    const Bytes image = randomImage(bench.random, 5);
    EXPECT(beginReport(1, static_cast<std::uint32_t>(image.size()), deviceImageCrc(image) ^ 1), OK);
    for (std::uint32_t offset = 0; offset < image.size(); offset += 56)
        EXPECT(chunkReport(1, offset, image), OK);
    EXPECT(verify(1), BAD_CRC);
    EXPECT(commit(1), NO_UPLOAD);
    QCOMPARE(bench.device.status().banks[0].state, std::uint8_t(BRIDGE_BANK_EMPTY));
}

void TestFirmwareUpload::verify_badKnot_isBadTable()
{
    FirmwareBench bench;
    Bytes image = randomImage(bench.random, 5);
    bridge_put_u32(image.data() + BRIDGE_TABLE_VALUES + 24, 0x40000000);
    EXPECT(beginFor(image, 1), OK);
    for (std::uint32_t offset = 0; offset < image.size(); offset += 56)
        EXPECT(chunkReport(1, offset, image), OK);
    EXPECT(verify(1), BAD_TABLE);
}

void TestFirmwareUpload::commit_repeated_isHarmless()
{
    FirmwareBench bench;
    const Bytes image = randomImage(bench.random, 5);
    for (const Report &report : uploadReports(image, 4))
        EXPECT(report, OK);
    const int operations = bench.flash.operations();
    EXPECT(commit(4), OK);
    QCOMPARE(bench.flash.operations(), operations);
    EXPECT(commit(5), NO_UPLOAD);
}

void TestFirmwareUpload::begin_lastGeneration_isFull()
{
    FirmwareBench bench;
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

QTEST_APPLESS_MAIN(TestFirmwareUpload)
#include "tst_firmware_upload.moc"
