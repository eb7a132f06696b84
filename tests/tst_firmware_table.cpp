// The firmware's table look-up against the engine's, on random tables, and its checks on damaged images.
#include "device/firmware/bridge_counts.h"
#include "device/firmware/bridge_crc32.h"
#include "engine/compensation/table_apply.h"
#include "engine/exports/device_compensation.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>
#include <cstring>

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareTable : public QObject
{
    Q_OBJECT

private slots:
    void crc32_checkValue_isThatOfTheStandard();
    void ratio_randomOperands_equalsLongDivision();
    void units_randomTables_equalFixedPointTable();
    void dps_randomTables_equalTableApply();
    void counts_randomTables_equalHost();
    void counts_anySensitivity_areWithinHalfACount();
    void takenOff_wholeRange_saturates();
    void covers_ends_belongToTheTable();
    void read_damagedHeader_isRefusedAsByTheHost();
};

namespace {

constexpr int kTables = 30;
constexpr int kTemperatures = 4000;

bridge_table readTable(const Bytes &image)
{
    bridge_table table;
    const bool ok = bridge_table_read(&table, image.data());
    Q_ASSERT(ok);
    Q_UNUSED(ok);
    return table;
}

const std::uint8_t *cellOf(const Bytes &image, const bridge_place &place)
{
    return image.data() + BRIDGE_TABLE_VALUES + place.cell * BRIDGE_TABLE_KNOT_SIZE;
}

CompensationTable anyTable(Random &random)
{
    return randomTable(random, 2 + static_cast<int>(random.below(random.below(2) == 0 ? 20 : 3000)),
                       std::pow(10.0, random.uniform(-6.0, 5.0)));
}

// Inside, at the knots, at the ends and far outside.
std::int32_t anyTemperature(Random &random, const CompensationTable &table)
{
    const std::int32_t span = table.lastMilliC - table.firstMilliC;
    switch (random.below(8)) {
    case 0:
        return table.firstMilliC - 1 + static_cast<std::int32_t>(random.below(3));
    case 1:
        return table.lastMilliC - 1 + static_cast<std::int32_t>(random.below(3));
    case 2:
        return static_cast<std::int32_t>(random.bits());
    case 3:
        return static_cast<std::int32_t>(1000.0 * table.temperatureC(static_cast<Eigen::Index>(
                                                      random.below(std::uint64_t(table.size())))));
    default:
        return table.firstMilliC + static_cast<std::int32_t>(random.below(std::uint64_t(span) + 1));
    }
}

} // namespace

void TestFirmwareTable::crc32_checkValue_isThatOfTheStandard()
{
    const std::string digits = "123456789";
    const auto *bytes = reinterpret_cast<const std::uint8_t *>(digits.data());
    QCOMPARE(bridge_crc32(0, bytes, 9), 0xCBF43926U);
    QCOMPARE(bridge_crc32(bridge_crc32(0, bytes, 4), bytes + 4, 5), 0xCBF43926U);
    QCOMPARE(bridge_crc32(0, bytes, 0), 0U);
}

void TestFirmwareTable::ratio_randomOperands_equalsLongDivision()
{
    Random random = announced(20261211);
    for (int i = 0; i < 100000; ++i) {
        const auto denominator = static_cast<std::uint32_t>(1 + random.below(1000000));
        const auto numerator = static_cast<std::uint32_t>(1 + random.below(1000000));
        std::uint8_t bits = 0;
        const std::uint32_t ratio = bridge_ratio(numerator, denominator, &bits);
        QVERIFY(bits < 52 && ratio >= 1U << 30);
        QCOMPARE(ratio, static_cast<std::uint32_t>((std::uint64_t{numerator} << bits) / denominator));
        QVERIFY(bits == 0 || (std::uint64_t{numerator} << (bits - 1)) / denominator < 1U << 30);
    }
}

void TestFirmwareTable::units_randomTables_equalFixedPointTable()
{
    Random random = announced(20261212);
    for (int i = 0; i < kTables; ++i) {
        const CompensationTable table = anyTable(random);
        const FixedPointTable fixed = makeFixedPointTable(table);
        const Bytes image = imageOf(table, DeviceTableKind::FixedPoint);
        const bridge_table read = readTable(image);
        for (int k = 0; k < kTemperatures; ++k) {
            const std::int32_t milliC = anyTemperature(random, table);
            const bridge_place place = bridge_table_locate(&read, milliC);
            std::array<std::int32_t, 3> units{};
            bridge_table_units(place, cellOf(image, place), units.data());
            QVERIFY2(units == tdeUnits(fixed, milliC), qPrintable(QString::number(milliC)));
        }
    }
}

void TestFirmwareTable::dps_randomTables_equalTableApply()
{
    Random random = announced(20261213);
    for (int i = 0; i < kTables; ++i) {
        const CompensationTable table = anyTable(random);
        const TableApply<float> apply(table);
        const Bytes image = imageOf(table, DeviceTableKind::Float);
        const bridge_table read = readTable(image);
        TableApply<float>::Column temperatureC(kTemperatures);
        TableApply<float>::Columns dps(kTemperatures, 3);
        for (int k = 0; k < kTemperatures; ++k) {
            const std::int32_t milliC = anyTemperature(random, table);
            temperatureC[k] = static_cast<float>(milliC) / 1000.0F;
            const bridge_place place = bridge_table_locate(&read, milliC);
            float values[3];
            bridge_table_dps(place, cellOf(image, place), values);
            dps.row(k) << values[0], values[1], values[2];
        }
        QVERIFY(dps == apply.tde(temperatureC));
    }
}

void TestFirmwareTable::counts_randomTables_equalHost()
{
    Random random = announced(20261214);
    for (int i = 0; i < 2 * kTables; ++i) {
        const CompensationTable table = anyTable(random);
        const auto kind = i % 2 == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float;
        const auto sensitivity = static_cast<std::uint16_t>(1 + random.below(65535));
        const Bytes image = imageOf(table, kind);
        const bridge_table read = readTable(image);
        const bridge_scale scale = bridge_scale_of(&read, sensitivity);
        const DeviceCompensation host(*decodeDeviceImage(image, "image"), sensitivity);
        for (int k = 0; k < 500; ++k) {
            const std::int32_t milliC = anyTemperature(random, table);
            const bridge_place place = bridge_table_locate(&read, milliC);
            std::array<std::int32_t, 3> counts{};
            if (kind == DeviceTableKind::FixedPoint) {
                std::array<std::int32_t, 3> units{};
                bridge_table_units(place, cellOf(image, place), units.data());
                for (std::size_t axis = 0; axis < 3; ++axis)
                    counts[axis] = bridge_counts_of_units(scale, units[axis]);
            } else {
                std::array<float, 3> dps{};
                bridge_table_dps(place, cellOf(image, place), dps.data());
                for (std::size_t axis = 0; axis < 3; ++axis)
                    counts[axis] = bridge_counts_of_dps(scale, dps[axis]);
            }
            QVERIFY(counts == host.tdeCounts(milliC));
            const auto raw = static_cast<std::int16_t>(random.bits());
            bool atLimit = false;
            QCOMPARE(bridge_counts_taken_off(raw, counts[0], &atLimit),
                     DeviceCompensation::compensated(raw, counts[0]));
        }
    }
}

void TestFirmwareTable::counts_anySensitivity_areWithinHalfACount()
{
    Random random = announced(20261215);
    for (int i = 0; i < 200000; ++i) {
        bridge_table table{};
        table.fraction = static_cast<std::uint8_t>(random.below(31));
        const auto sensitivity = static_cast<std::uint16_t>(1 + random.below(65535));
        const bridge_scale scale = bridge_scale_of(&table, sensitivity);
        const auto units =
            static_cast<std::int32_t>(random.below((std::uint64_t{1} << 31) - 1)) - (1 << 30) + 1;
        const double exact =
            std::clamp(std::ldexp(units, -table.fraction) * 1e5 / sensitivity, -65536.0, 65536.0);
        // Half a count, and 2^-30 of the value for the multiplier.
        QVERIFY(std::abs(bridge_counts_of_units(scale, units) - exact) <= 0.5 + 65536.0 / (1 << 30));
        const auto dps = static_cast<float>(std::ldexp(units, -table.fraction));
        const double exactOfFloat = std::clamp(double{dps} * 1e5 / sensitivity, -65536.0, 65536.0);
        QVERIFY(std::abs(bridge_counts_of_dps(scale, dps) - exactOfFloat) <= 0.5 + 65536.0 / (1 << 22));
    }
}

void TestFirmwareTable::takenOff_wholeRange_saturates()
{
    for (std::int32_t raw = INT16_MIN; raw <= INT16_MAX; raw += 3) {
        for (const std::int32_t counts : {-65536, -32768, -1, 0, 1, 100, 32767, 65536}) {
            bool atLimit = false;
            const std::int16_t rate =
                bridge_counts_taken_off(static_cast<std::int16_t>(raw), counts, &atLimit);
            QCOMPARE(std::int32_t{rate}, std::clamp(raw - counts, -32768, 32767));
            QCOMPARE(atLimit, rate == INT16_MAX || rate == INT16_MIN || raw == INT16_MAX || raw == INT16_MIN);
        }
    }
}

void TestFirmwareTable::covers_ends_belongToTheTable()
{
    Random random(7);
    const bridge_table table = readTable(randomImage(random, 5));
    QVERIFY(bridge_table_covers(&table, table.first_millic) &&
            bridge_table_covers(&table, table.last_millic));
    QVERIFY(!bridge_table_covers(&table, table.first_millic - 1));
    QVERIFY(!bridge_table_covers(&table, table.last_millic + 1));
}

void TestFirmwareTable::read_damagedHeader_isRefusedAsByTheHost()
{
    Random random = announced(20261216);
    int accepted = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto kind = i % 2 == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float;
        Bytes image = randomImage(random, 2 + static_cast<int>(random.below(4)), kind);
        const std::uint64_t changes = 1 + random.below(3);
        for (std::uint64_t k = 0; k < changes; ++k)
            image[random.below(image.size())] = static_cast<std::uint8_t>(random.bits());
        bridge_table table;
        const bool read =
            bridge_table_read(&table, image.data()) && bridge_table_bytes(&table) == image.size();
        bool fits = read;
        for (std::size_t at = BRIDGE_TABLE_VALUES; fits && at < image.size(); at += BRIDGE_TABLE_KNOT_SIZE)
            fits = bridge_table_knot_fits(&table, image.data() + at);
        const bool byHost = decodeDeviceImage(image, "image").ok();
        // The host knows the float reciprocal to the last bit, the firmware to a few.
        QVERIFY(fits == byHost || (fits && kind == DeviceTableKind::Float));
        if (fits) {
            ++accepted;
            const bridge_place place = bridge_table_locate(&table, static_cast<std::int32_t>(random.bits()));
            QVERIFY(place.cell + 2 <= table.knots);
        }
    }
    QVERIFY(accepted > 1000);
}

QTEST_APPLESS_MAIN(TestFirmwareTable)
#include "tst_firmware_table.moc"
