// Raw twins of compensated reports: the same samples as they were measured, right behind, or neither.
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>
#include <cstring>

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareTwins : public QObject
{
    Q_OBJECT

private slots:
    void twin_ofCompensatedReport_hasTheRawSamples();
    void twin_notAskedFor_doesNotCome();
    void twin_ofRawReport_doesNotCome();
    void twin_ringWithoutRoom_bothAreLostAndCountedOnce();
    void config_withoutTheCapability_ignoresPairs();
};

namespace {

struct Bench
{
    explicit Bench(std::uint64_t seed) : random(announced(seed))
    {
        if (device.install(randomImage(random, 9), 1) != BRIDGE_RESULT_OK)
            qFatal("the table could not be installed");
    }

    std::uint8_t configure(bool compensate, bool pair)
    {
        Report config = device.get(BRIDGE_REPORT_CONFIG);
        config[BRIDGE_CONFIG_STREAM] = 1;
        config[BRIDGE_CONFIG_COMPENSATE] = compensate ? 1 : 0;
        config[BRIDGE_CONFIG_PAIR] = pair ? 1 : 0;
        return device.set(config);
    }
    bridge_sample sample(bool dieValid = true)
    {
        bridge_sample made{};
        made.time_us = timeUs += 1000;
        for (std::int16_t &counts : made.counts)
            counts = static_cast<std::int16_t>(random.below(20) == 0 ? INT16_MAX : random.bits());
        made.die_valid = dieValid;
        made.die_millic = static_cast<std::int32_t>(random.below(60000)) - 20000;
        bridge_device_sample(&device.device, &made);
        return made;
    }
    std::optional<Report> take()
    {
        Report report;
        if (!bridge_device_take(&device.device, report.data()))
            return std::nullopt;
        return report;
    }

    Random random;
    RamFlash flash{4096};
    FirmwareDevice device{flash};
    std::uint32_t timeUs = 0;
};

std::int16_t countsOf(const Report &report, std::size_t sample, std::size_t axis)
{
    return bridge_get_i16(report.data() + BRIDGE_SAMPLES_RATES + sample * BRIDGE_SAMPLE_SIZE + 2 * axis);
}

std::uint16_t sequenceOf(const Report &report)
{
    return bridge_get_u16(report.data() + BRIDGE_SAMPLES_SEQUENCE);
}

bool isTwin(const Report &report)
{
    return (report[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_TWIN) != 0;
}

// Everything between the sequence number and the rates: time, interval, temperatures.
bool sameTimesAndTemperatures(const Report &one, const Report &other)
{
    return std::equal(one.begin() + BRIDGE_SAMPLES_TIME, one.begin() + BRIDGE_SAMPLES_RATES,
                      other.begin() + BRIDGE_SAMPLES_TIME);
}

} // namespace

void TestFirmwareTwins::twin_ofCompensatedReport_hasTheRawSamples()
{
    Bench bench(20261301);
    QCOMPARE(bench.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    std::uint16_t sequence = 0;
    for (int round = 0; round < 100; ++round) {
        const std::size_t count = 1 + bench.random.below(7);
        std::vector<bridge_sample> sent;
        for (std::size_t i = 0; i < count; ++i)
            sent.push_back(bench.sample());
        bridge_stream_flush(&bench.device.device.stream);
        const auto compensated = bench.take();
        const auto twin = bench.take();
        QVERIFY(compensated && twin && !bench.take());
        QVERIFY(!isTwin(*compensated));
        QVERIFY(((*compensated)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_COMPENSATED) != 0);
        QCOMPARE(int((*twin)[BRIDGE_SAMPLES_FLAGS]), int(BRIDGE_FLAG_TWIN | BRIDGE_FLAG_DIE_VALID));
        QCOMPARE(sequenceOf(*compensated), sequence++);
        QCOMPARE(sequenceOf(*twin), sequence++);
        QVERIFY(sameTimesAndTemperatures(*compensated, *twin));
        QCOMPARE(std::size_t((*twin)[BRIDGE_SAMPLES_COUNT]), count);
        for (std::size_t i = 0; i < count; ++i) {
            bool saturated = false;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QCOMPARE(countsOf(*twin, i, axis), sent[i].counts[axis]);
                saturated =
                    saturated || sent[i].counts[axis] == INT16_MAX || sent[i].counts[axis] == INT16_MIN;
            }
            QCOMPARE((((*twin)[BRIDGE_SAMPLES_SATURATED] >> i) & 1) != 0, saturated);
        }
    }
    QCOMPARE(bench.device.status().dropped, 0U);
}

void TestFirmwareTwins::twin_notAskedFor_doesNotCome()
{
    Bench bench(20261302);
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_PAIR], std::uint8_t(0));
    QCOMPARE(bench.configure(true, false), std::uint8_t(BRIDGE_RESULT_OK));
    for (int i = 0; i < 14; ++i)
        bench.sample();
    QVERIFY(!isTwin(*bench.take()) && !isTwin(*bench.take()) && !bench.take());
}

void TestFirmwareTwins::twin_ofRawReport_doesNotCome()
{
    Bench bench(20261303);
    // Raw because it was asked for, and because the table's thermometer is not read.
    for (const bool compensate : {false, true}) {
        QCOMPARE(bench.configure(compensate, true), std::uint8_t(BRIDGE_RESULT_OK));
        for (int i = 0; i < 7; ++i)
            bench.sample(!compensate);
        const auto report = bench.take();
        QVERIFY(report && !isTwin(*report) && !bench.take());
    }
}

void TestFirmwareTwins::twin_ringWithoutRoom_bothAreLostAndCountedOnce()
{
    Bench bench(20261304);
    QCOMPARE(bench.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    // The ring of four takes two pairs; one place is no room for a third.
    for (int i = 0; i < 14; ++i)
        bench.sample();
    QVERIFY(bench.take());
    for (int i = 0; i < 7; ++i)
        bench.sample();
    QCOMPARE(bench.device.status().dropped, 7U);
    QCOMPARE(bench.device.status().produced, 21U);
    QVERIFY(isTwin(*bench.take()) && !isTwin(*bench.take()) && isTwin(*bench.take()) && !bench.take());
    for (int i = 0; i < 7; ++i)
        bench.sample();
    QVERIFY(((*bench.take())[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) != 0);
    const auto twin = bench.take();
    QVERIFY(isTwin(*twin) && ((*twin)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) == 0);
}

void TestFirmwareTwins::config_withoutTheCapability_ignoresPairs()
{
    Bench bench(20261305);
    Report bad = bench.device.get(BRIDGE_REPORT_CONFIG);
    bad[BRIDGE_CONFIG_PAIR] = 2;
    QCOMPARE(bench.device.set(bad), std::uint8_t(BRIDGE_RESULT_BAD_VALUE));
    bench.device.identity.capabilities &= static_cast<std::uint8_t>(~BRIDGE_CAN_PAIR);
    bench.device.powerUp();
    QCOMPARE(bench.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(bench.device.get(BRIDGE_REPORT_CONFIG)[BRIDGE_CONFIG_PAIR], std::uint8_t(0));
    for (int i = 0; i < 7; ++i)
        bench.sample();
    QVERIFY(bench.take() && !bench.take());
}

QTEST_APPLESS_MAIN(TestFirmwareTwins)
#include "tst_firmware_twins.moc"
