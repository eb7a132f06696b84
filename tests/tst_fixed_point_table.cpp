#include "engine/compensation/fixed_point_table.h"
#include "support/models_for_export.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace driftbench;
using namespace driftbench::test;

class TestFixedPointTable : public QObject
{
    Q_OBJECT

private slots:
    void tdeUnits_everyMillidegree_isWithinBoundOfRealTable();
    void tdeUnits_randomGrids_areWithinBoundOfRealTable();
    void tdeUnits_farOutside_holdsTheEnds();
    void makeFixedPointTable_largestValue_choosesFractionBits_data();
    void makeFixedPointTable_largestValue_choosesFractionBits();
};

// Linear interpolation in the table itself, at a whole millidegree.
static Eigen::RowVector3d exactTde(const CompensationTable &table, std::int32_t milliC)
{
    const double held = std::clamp(milliC, table.firstMilliC, table.lastMilliC) - table.firstMilliC;
    const double position =
        held * static_cast<double>(table.size() - 1) / (table.lastMilliC - table.firstMilliC);
    const auto cell = std::min(static_cast<Eigen::Index>(position), table.size() - 2);
    const double f = position - static_cast<double>(cell);
    return (1.0 - f) * table.tdeDps.row(cell) + f * table.tdeDps.row(cell + 1);
}

static double worstError(const CompensationTable &table, const FixedPointTable &fixed)
{
    double worst = 0.0;
    for (std::int32_t t = table.firstMilliC - 3000; t <= table.lastMilliC + 3000; ++t) {
        const auto units = tdeUnits(fixed, t);
        const Eigen::RowVector3d exact = exactTde(table, t);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double dps = units[axis] * fixed.dpsPerUnit();
            worst = std::max(worst, std::abs(dps - exact[static_cast<Eigen::Index>(axis)]));
        }
    }
    return worst;
}

static CompensationTable randomTable(Random &random)
{
    CompensationTable table;
    table.firstMilliC = static_cast<std::int32_t>(random.below(100000)) - 80000;
    const auto cells = static_cast<Eigen::Index>(1 + random.below(3000));
    table.lastMilliC = table.firstMilliC +
                       static_cast<std::int32_t>(cells + static_cast<Eigen::Index>(random.below(150000)));
    table.tdeDps.resize(cells + 1, 3);
    const double scale = std::pow(10.0, random.uniform(-6.0, 5.0));
    for (Eigen::Index i = 0; i <= cells; ++i)
        table.tdeDps.row(i) << scale * random.normal(), scale * random.uniform(-1.0, 1.0), 0.0;
    return table;
}

void TestFixedPointTable::tdeUnits_everyMillidegree_isWithinBoundOfRealTable()
{
    Random random = announced(20261104);
    for (int i = 0; i < 8; ++i) {
        const TrainedModel model = randomModel(random);
        const auto table = makeCompensationTable(model, {true, true, true}, {});
        QVERIFY(table.ok());
        const FixedPointTable fixed = makeFixedPointTable(*table);
        const double worst = worstError(*table, fixed);
        QVERIFY2(worst <= fixed.errorBoundDps,
                 qPrintable(QStringLiteral("%1 > %2").arg(worst).arg(fixed.errorBoundDps)));
        // The bound means something: it is not far above what happens, and far below the interpolation error.
        QVERIFY(fixed.errorBoundDps < 100.0 * worst);
        QVERIFY(fixed.errorBoundDps < 0.05 * table->interpolationErrorBoundDps);
    }
}

void TestFixedPointTable::tdeUnits_randomGrids_areWithinBoundOfRealTable()
{
    Random random = announced(20261105);
    for (int i = 0; i < 20; ++i) {
        const CompensationTable table = randomTable(random);
        const FixedPointTable fixed = makeFixedPointTable(table);
        QVERIFY(fixed.reciprocal >= (1U << 30) && fixed.reciprocal < (1U << 31));
        QVERIFY(worstError(table, fixed) <= fixed.errorBoundDps);
    }
}

void TestFixedPointTable::tdeUnits_farOutside_holdsTheEnds()
{
    Random random = announced(20261106);
    const CompensationTable table = randomTable(random);
    const FixedPointTable fixed = makeFixedPointTable(table);
    QCOMPARE(tdeUnits(fixed, std::numeric_limits<std::int32_t>::min()), tdeUnits(fixed, table.firstMilliC));
    QCOMPARE(tdeUnits(fixed, std::numeric_limits<std::int32_t>::max()), tdeUnits(fixed, table.lastMilliC));
    QCOMPARE(tdeUnits(fixed, table.firstMilliC), fixed.values.front());
}

void TestFixedPointTable::makeFixedPointTable_largestValue_choosesFractionBits_data()
{
    QTest::addColumn<double>("largestDps");
    QTest::addColumn<int>("fractionBits");
    QTest::newRow("nothing") << 0.0 << 30;
    QTest::newRow("below one") << 0.999 << 30;
    QTest::newRow("one") << 1.0 << 29;
    QTest::newRow("rounds up to the limit") << 1.0 - 1e-12 << 29;
    QTest::newRow("three") << -3.0 << 28;
    QTest::newRow("a thousand") << 1000.0 << 20;
}

void TestFixedPointTable::makeFixedPointTable_largestValue_choosesFractionBits()
{
    QFETCH(double, largestDps);
    QFETCH(int, fractionBits);
    CompensationTable table;
    table.lastMilliC = 1000;
    table.tdeDps = Eigen::MatrixX3d::Zero(2, 3);
    table.tdeDps(1, 2) = largestDps;
    const FixedPointTable fixed = makeFixedPointTable(table);
    QCOMPARE(fixed.fractionBits, fractionBits);
    QVERIFY(std::abs(std::int64_t{fixed.values[1][2]}) < (std::int64_t{1} << 30));
    QVERIFY(std::abs(fixed.values[1][2] * fixed.dpsPerUnit() - largestDps) <= 0.5 * fixed.dpsPerUnit());
}

QTEST_APPLESS_MAIN(TestFixedPointTable)
#include "tst_fixed_point_table.moc"
