// Banks that hold tables, behind the device's reports: which is in use, and what can be read of them.
#include "support/firmware_bench.h"

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareBanks : public QObject
{
    Q_OBJECT

private slots:
    void activate_and_rollback_followGenerations();
    void read_bankAndLimits_areChecked();
    void read_flashFailure_isTold();
    void bank_ofAnotherSensor_isForeign();
};

void TestFirmwareBanks::activate_and_rollback_followGenerations()
{
    FirmwareBench bench;
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

void TestFirmwareBanks::read_bankAndLimits_areChecked()
{
    FirmwareBench bench;
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

void TestFirmwareBanks::read_flashFailure_isTold()
{
    FirmwareBench bench;
    QCOMPARE(bench.device.install(randomImage(bench.random, 6), 1), std::uint8_t(BRIDGE_RESULT_OK));
    Report choice = makeReport(BRIDGE_REPORT_READ);
    choice[BRIDGE_READ_LENGTH] = 56;
    EXPECT(choice, OK);
    bench.flash.refuseReads(true);
    QCOMPARE(bench.device.get(BRIDGE_REPORT_READ)[BRIDGE_READ_LENGTH], std::uint8_t(0));
    QCOMPARE(bench.device.status().result, std::uint8_t(BRIDGE_RESULT_FLASH));
}

void TestFirmwareBanks::bank_ofAnotherSensor_isForeign()
{
    FirmwareBench bench;
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

QTEST_APPLESS_MAIN(TestFirmwareBanks)
#include "tst_firmware_banks.moc"
