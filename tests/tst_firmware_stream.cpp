// Samples into reports: nothing is lost uncounted, and what a report says about its samples is so.
#include "engine/exports/device_compensation.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareStream : public QObject
{
    Q_OBJECT

private slots:
    void report_sevenSamples_carriesThemAll();
    void report_slowSamples_isClosedInTime();
    void sequence_manyReports_wraps();
    void time_wrapInsideReport_intervalHolds();
    void ring_full_newReportIsLostAndTold();
    void ring_randomTraffic_addsUp();
    void lost_insideTheDevice_isCountedAndTold();
    void saturation_ofRawOrCompensated_isFlagged();
    void compensated_randomTables_equalHostFromReportAlone();
    void compensated_switchedInsideReport_startsAnother();
    void compensated_tableReplaced_usesTheNewOneAtOnce();
    void compensated_thermometerMissing_staysRaw();
    void compensated_flashUnreadable_staysRaw();
};

namespace {

class Stream
{
public:
    explicit Stream(std::uint32_t capacity = 4) : m_ring(std::make_unique<bridge_report[]>(capacity))
    {
        bridge_stream_start(&stream, m_ring.get(), capacity);
    }

    void sample(std::uint32_t timeUs, std::array<std::int16_t, 3> counts = {1, 2, 3})
    {
        bridge_sample sample{};
        sample.time_us = timeUs;
        std::copy(counts.begin(), counts.end(), sample.counts);
        sample.die_valid = true;
        sample.die_millic = 25000;
        bridge_stream_sample(&stream, &sample);
    }

    std::optional<Report> take()
    {
        Report report;
        if (!bridge_stream_take(&stream, report.data()))
            return std::nullopt;
        return report;
    }

    bridge_stream stream;

private:
    std::unique_ptr<bridge_report[]> m_ring;
};

std::uint32_t u32(const Report &report, std::size_t offset)
{
    return bridge_get_u32(report.data() + offset);
}

std::uint16_t sequenceOf(const Report &report)
{
    return bridge_get_u16(report.data() + BRIDGE_SAMPLES_SEQUENCE);
}

std::int16_t countsOf(const Report &report, std::size_t sample, std::size_t axis)
{
    return bridge_get_i16(report.data() + BRIDGE_SAMPLES_RATES + sample * BRIDGE_SAMPLE_SIZE + 2 * axis);
}

} // namespace

void TestFirmwareStream::report_sevenSamples_carriesThemAll()
{
    Stream stream;
    for (std::int16_t i = 0; i < 7; ++i) {
        QVERIFY(!stream.take());
        stream.sample(5000U + 1000U * static_cast<std::uint32_t>(i),
                      {i, static_cast<std::int16_t>(-i), static_cast<std::int16_t>(1000 * i)});
    }
    const auto report = stream.take();
    QVERIFY(report && !stream.take());
    QCOMPARE((*report)[0], std::uint8_t(BRIDGE_REPORT_SAMPLES));
    QCOMPARE((*report)[BRIDGE_SAMPLES_FLAGS], std::uint8_t(BRIDGE_FLAG_DIE_VALID));
    QCOMPARE((*report)[BRIDGE_SAMPLES_COUNT], std::uint8_t(7));
    QCOMPARE((*report)[BRIDGE_SAMPLES_SATURATED], std::uint8_t(0));
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_TIME), 5000U);
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_INTERVAL), 1000000U);
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_DIE_MILLIC), 25000U);
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_EXTERNAL_MILLIC), 0U);
    for (std::int16_t i = 0; i < 7; ++i) {
        QCOMPARE(countsOf(*report, static_cast<std::size_t>(i), 0), i);
        QCOMPARE(countsOf(*report, static_cast<std::size_t>(i), 1), static_cast<std::int16_t>(-i));
        QCOMPARE(countsOf(*report, static_cast<std::size_t>(i), 2), static_cast<std::int16_t>(1000 * i));
    }
}

void TestFirmwareStream::report_slowSamples_isClosedInTime()
{
    Stream stream;
    stream.sample(0);
    stream.sample(39999);
    QVERIFY(!stream.take());
    stream.sample(100000);
    const auto report = stream.take();
    QVERIFY(report);
    QCOMPARE((*report)[BRIDGE_SAMPLES_COUNT], std::uint8_t(3));
    stream.sample(7);
    bridge_stream_flush(&stream.stream);
    const auto single = stream.take();
    QCOMPARE((*single)[BRIDGE_SAMPLES_COUNT], std::uint8_t(1));
    QCOMPARE(u32(*single, BRIDGE_SAMPLES_INTERVAL), 0U);
    // Two samples more than the field can hold apart.
    stream.sample(0);
    stream.sample(4294967U + 1000000U);
    QCOMPARE(u32(*stream.take(), BRIDGE_SAMPLES_INTERVAL), 0xFFFFFFFFU);
}

void TestFirmwareStream::sequence_manyReports_wraps()
{
    Stream stream;
    std::uint16_t expected = 0;
    for (std::uint32_t i = 0; i < 7U * 65540U; ++i) {
        stream.sample(1000U * i);
        if (const auto report = stream.take())
            QCOMPARE(sequenceOf(*report), expected++);
    }
    QCOMPARE(expected, std::uint16_t(4));
}

void TestFirmwareStream::time_wrapInsideReport_intervalHolds()
{
    Stream stream;
    for (std::uint32_t i = 0; i < 7; ++i)
        stream.sample(0xFFFFFFFFU - 2500U + 1001U * i);
    const auto report = stream.take();
    QVERIFY(report);
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_TIME), 0xFFFFFFFFU - 2500U);
    QCOMPARE(u32(*report, BRIDGE_SAMPLES_INTERVAL), 1001000U);
}

void TestFirmwareStream::ring_full_newReportIsLostAndTold()
{
    Stream stream(2);
    for (std::uint32_t i = 0; i < 7 * 5; ++i)
        stream.sample(1000U * i);
    QCOMPARE(stream.stream.produced, 35U);
    QCOMPARE(stream.stream.dropped, 21U);
    QCOMPARE(sequenceOf(*stream.take()), std::uint16_t(0));
    const auto second = stream.take();
    QCOMPARE(sequenceOf(*second), std::uint16_t(1));
    QVERIFY(((*second)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) == 0);
    QVERIFY(!stream.take());
    for (std::uint32_t i = 35; i < 49; ++i)
        stream.sample(1000U * i);
    const auto afterLoss = stream.take();
    QCOMPARE(sequenceOf(*afterLoss), std::uint16_t(2));
    QVERIFY(((*afterLoss)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) != 0);
    QVERIFY(((*stream.take())[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) == 0);
}

void TestFirmwareStream::ring_randomTraffic_addsUp()
{
    Random random = announced(20261231);
    for (int round = 0; round < 200; ++round) {
        Stream stream(static_cast<std::uint32_t>(1 + random.below(5)));
        std::uint32_t taken = 0;
        std::uint32_t lastTime = 0;
        std::uint16_t sequence = 0;
        std::uint32_t timeUs = static_cast<std::uint32_t>(random.bits());
        const auto drain = [&] {
            const auto report = stream.take();
            if (!report)
                return;
            QCOMPARE(sequenceOf(*report), sequence++);
            // Samples are missing between two reports if and only if the later one says so.
            const std::uint32_t first = u32(*report, BRIDGE_SAMPLES_TIME);
            const bool overrun = ((*report)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) != 0;
            if (taken > 0)
                QCOMPARE(overrun, first - lastTime != 1000U);
            taken += (*report)[BRIDGE_SAMPLES_COUNT];
            lastTime = first + 1000U * ((*report)[BRIDGE_SAMPLES_COUNT] - 1U);
        };
        for (int i = 0; i < 2000; ++i) {
            stream.sample(timeUs += 1000U);
            if (random.below(100) == 0) {
                const auto lost = static_cast<std::uint32_t>(random.below(9));
                bridge_stream_lost(&stream.stream, lost);
                timeUs += 1000U * lost;
            }
            if (random.below(static_cast<std::uint64_t>(4 + round % 8)) == 0)
                drain();
        }
        bridge_stream_flush(&stream.stream);
        for (int i = 0; i < 6; ++i)
            drain();
        QCOMPARE(taken + stream.stream.dropped, stream.stream.produced);
    }
}

void TestFirmwareStream::lost_insideTheDevice_isCountedAndTold()
{
    Stream stream;
    stream.sample(0);
    stream.sample(1000);
    bridge_stream_lost(&stream.stream, 30);
    const auto before = stream.take();
    QVERIFY(before);
    QCOMPARE((*before)[BRIDGE_SAMPLES_COUNT], std::uint8_t(2));
    for (std::uint32_t i = 0; i < 7; ++i)
        stream.sample(32000 + 1000 * i);
    const auto after = stream.take();
    QVERIFY(((*after)[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_OVERRUN) != 0);
    QCOMPARE(sequenceOf(*after), std::uint16_t(1));
    QCOMPARE(stream.stream.produced, 39U);
    QCOMPARE(stream.stream.dropped, 30U);
}

void TestFirmwareStream::saturation_ofRawOrCompensated_isFlagged()
{
    Stream stream;
    for (std::uint32_t i = 0; i < 7; ++i) {
        const bool high = i == 2;
        const bool low = i == 5;
        stream.sample(1000 * i, {0, high ? std::int16_t(INT16_MAX) : std::int16_t(INT16_MAX - 1),
                                 low ? std::int16_t(INT16_MIN) : std::int16_t(0)});
    }
    QCOMPARE((*stream.take())[BRIDGE_SAMPLES_SATURATED], std::uint8_t(0b100100));
}

void TestFirmwareStream::compensated_randomTables_equalHostFromReportAlone()
{
    Random random = announced(20261232);
    for (int round = 0; round < 24; ++round) {
        const auto kind = round % 2 == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float;
        const bool external = round % 3 == 0;
        const CompensationTable table = randomTable(random, 20, round % 4 == 0 ? 300.0 : 2.0);
        const Bytes image =
            imageOf(table, kind, external ? DeviceThermometer::External : DeviceThermometer::Die);
        RamFlash flash(4096);
        FirmwareDevice firmware(flash);
        QCOMPARE(firmware.install(image, 1), std::uint8_t(BRIDGE_RESULT_OK));
        QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
        const DeviceCompensation host(*decodeDeviceImage(image, "image"), 875);
        std::vector<bridge_sample> sent;
        for (std::uint32_t i = 0; i < 7 * 50; ++i) {
            bridge_sample sample{};
            sample.time_us = 1000 * i;
            for (std::int16_t &counts : sample.counts)
                counts = static_cast<std::int16_t>(random.bits());
            sample.die_valid = sample.external_valid = true;
            const std::int32_t span = table.lastMilliC - table.firstMilliC + 2000;
            sample.die_millic = table.firstMilliC - 1000 +
                                static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(span)));
            sample.external_millic = table.firstMilliC + table.lastMilliC - sample.die_millic;
            bridge_device_sample(&firmware.device, &sample);
            sent.push_back(sample);
            Report report;
            if (!bridge_device_take(&firmware.device, report.data()))
                continue;
            const std::int32_t milliC = static_cast<std::int32_t>(
                u32(report, external ? BRIDGE_SAMPLES_EXTERNAL_MILLIC : BRIDGE_SAMPLES_DIE_MILLIC));
            const bool outside = milliC < table.firstMilliC || milliC > table.lastMilliC;
            QCOMPARE(int(report[BRIDGE_SAMPLES_FLAGS]),
                     int(BRIDGE_FLAG_COMPENSATED | BRIDGE_FLAG_DIE_VALID | BRIDGE_FLAG_EXTERNAL_VALID |
                         (outside ? BRIDGE_FLAG_OUTSIDE_TABLE : 0U)));
            const auto tde = host.tdeCounts(milliC);
            for (std::size_t k = 0; k < sent.size(); ++k) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    QCOMPARE(countsOf(report, k, axis),
                             DeviceCompensation::compensated(sent[k].counts[axis], tde[axis]));
            }
            sent.clear();
        }
    }
}

void TestFirmwareStream::compensated_switchedInsideReport_startsAnother()
{
    Random random(6);
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    QCOMPARE(firmware.install(randomImage(random, 5), 1), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(firmware.configure(true, false), std::uint8_t(BRIDGE_RESULT_OK));
    const bridge_sample sample{0, {11, 22, 33}, true, false, 20000, 0};
    for (int i = 0; i < 3; ++i)
        bridge_device_sample(&firmware.device, &sample);
    QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    for (int i = 0; i < 2; ++i)
        bridge_device_sample(&firmware.device, &sample);
    QCOMPARE(firmware.configure(false, true), std::uint8_t(BRIDGE_RESULT_OK));
    Report report;
    QVERIFY(bridge_device_take(&firmware.device, report.data()));
    QCOMPARE(report[BRIDGE_SAMPLES_COUNT], std::uint8_t(3));
    QVERIFY((report[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_COMPENSATED) == 0);
    QVERIFY(bridge_device_take(&firmware.device, report.data()));
    QCOMPARE(report[BRIDGE_SAMPLES_COUNT], std::uint8_t(2));
    QVERIFY((report[BRIDGE_SAMPLES_FLAGS] & BRIDGE_FLAG_COMPENSATED) != 0);
    QVERIFY(!bridge_device_take(&firmware.device, report.data()));
}

void TestFirmwareStream::compensated_tableReplaced_usesTheNewOneAtOnce()
{
    Random random(8);
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    CompensationTable table = randomTable(random, 2, 50.0);
    const bridge_sample sample{0, {11, 22, 33}, true, false, table.firstMilliC, 0};
    for (std::uint16_t upload = 1; upload < 4; ++upload) {
        // Another table on the same grid, so that the temperature stays in its cell.
        table.tdeDps *= -2.0;
        const Bytes image = imageOf(table, DeviceTableKind::FixedPoint);
        QCOMPARE(firmware.install(image, upload), std::uint8_t(BRIDGE_RESULT_OK));
        QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
        for (int i = 0; i < 7; ++i)
            bridge_device_sample(&firmware.device, &sample);
        Report report;
        QVERIFY(bridge_device_take(&firmware.device, report.data()));
        const auto tde =
            DeviceCompensation(*decodeDeviceImage(image, "image"), 875).tdeCounts(table.firstMilliC);
        QVERIFY(tde[0] != 0);
        QCOMPARE(countsOf(report, 0, 0), DeviceCompensation::compensated(11, tde[0]));
    }
}

void TestFirmwareStream::compensated_thermometerMissing_staysRaw()
{
    Random random(4);
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    const Bytes image =
        imageOf(randomTable(random, 5, 10.0), DeviceTableKind::Float, DeviceThermometer::External);
    QCOMPARE(firmware.install(image, 1), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    bridge_sample sample{0, {11, 22, 33}, true, false, 20000, 0};
    for (int i = 0; i < 7; ++i)
        bridge_device_sample(&firmware.device, &sample);
    Report report;
    QVERIFY(bridge_device_take(&firmware.device, report.data()));
    QCOMPARE(report[BRIDGE_SAMPLES_FLAGS], std::uint8_t(BRIDGE_FLAG_DIE_VALID));
    QCOMPARE(countsOf(report, 6, 2), std::int16_t(33));
}

void TestFirmwareStream::compensated_flashUnreadable_staysRaw()
{
    Random random(5);
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    QCOMPARE(firmware.install(randomImage(random, 5), 1), std::uint8_t(BRIDGE_RESULT_OK));
    QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    flash.refuseReads(true);
    bridge_sample sample{0, {11, 22, 33}, true, false, 20000, 0};
    for (int i = 0; i < 7; ++i)
        bridge_device_sample(&firmware.device, &sample);
    Report report;
    QVERIFY(bridge_device_take(&firmware.device, report.data()));
    QCOMPARE(report[BRIDGE_SAMPLES_FLAGS], std::uint8_t(BRIDGE_FLAG_DIE_VALID));
    QCOMPARE(countsOf(report, 0, 0), std::int16_t(11));
}

QTEST_APPLESS_MAIN(TestFirmwareStream)
#include "tst_firmware_stream.moc"
