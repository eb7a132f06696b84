#include "engine/compensation/axis_selection.h"
#include "engine/compensation/compensation_table.h"
#include "engine/compensation/table_apply.h"
#include "support/models_for_export.h"

#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <limits>

using namespace driftbench;
using namespace driftbench::test;

class TestCompensationTable : public QObject
{
    Q_OBJECT

private slots:
    void makeCompensationTable_randomModels_staysWithinBoundEverywhere();
    void makeCompensationTable_line_needsTwoKnots();
    void makeCompensationTable_pureRoot_reportsErrorOfClosedForm();
    void makeCompensationTable_tighterBound_needsMoreKnots();
    void makeCompensationTable_unreachableBound_namesTheReachableOne();
    void makeCompensationTable_axisLeftOut_hasZeros();
    void makeCompensationTable_badInput_isRefused_data();
    void makeCompensationTable_badInput_isRefused();
    void apply_insideAndOutside_interpolatesAndHoldsTheEnds();
    void apply_notFiniteTemperature_givesNoNumber();
    void apply_anyLength_equalsSampleBySample();
    void selectAxes_verdicts_decide();
};

static constexpr std::array<bool, 3> kAllAxes{true, true, true};

void TestCompensationTable::makeCompensationTable_randomModels_staysWithinBoundEverywhere()
{
    Random random = announced(20261101);
    for (int i = 0; i < 25; ++i) {
        const TrainedModel model = randomModel(random);
        const double bound = std::pow(10.0, random.uniform(-2.7, -1.5));
        const auto table = makeCompensationTable(
            model, kAllAxes, {.maxInterpolationErrorDps = bound, .largestKnotCount = 20001});
        QVERIFY2(table.ok(), table.ok() ? "" : table.error().message.c_str());
        QVERIFY(table->measuredErrorDps <= bound);
        Eigen::VectorXd temperatureC(40000);
        const double margin = 5.0;
        for (double &t : temperatureC)
            t = random.uniform(model.lowestTemperatureC - margin, model.highestTemperatureC + margin);
        for (int k = 0; k < 1000; ++k) // close to where the root is steep
            temperatureC[k] = model.referenceTemperatureC + random.normal() * table->stepC() * 0.3;
        const Eigen::MatrixX3d truth = predictAtTemperature(model, temperatureC).tdeDps;
        const double worst = (TableApply<double>(*table).tde(temperatureC) - truth).cwiseAbs().maxCoeff();
        QVERIFY2(worst <= bound,
                 qPrintable(QStringLiteral("model %1: %2 > %3").arg(i).arg(worst).arg(bound)));
        // The search is worth its name: a third of the cells would not have been enough for a smooth model.
        QVERIFY(table->size() == 2 || worst > 0.05 * bound);
    }
}

void TestCompensationTable::makeCompensationTable_line_needsTwoKnots()
{
    Random random(1);
    LinearModel line;
    line.biasDps = {1.0, -2.0, 0.0};
    line.slopeDpsPerC = {0.1, 0.0, -0.3};
    const TrainedModel model = framed(random, "linear", line);
    const auto table = makeCompensationTable(model, kAllAxes, {.maxInterpolationErrorDps = 0.01});
    QVERIFY(table.ok());
    QCOMPARE(table->size(), Eigen::Index(2));
    QCOMPARE(table->firstMilliC, std::int32_t(std::floor(model.lowestTemperatureC * 1000.0)));
    QCOMPARE(table->lastMilliC, std::int32_t(std::ceil(model.highestTemperatureC * 1000.0)));
}

// A chord of sqrt(x) over [0, h] is off by sqrt(h)/4, at x = h/4.
void TestCompensationTable::makeCompensationTable_pureRoot_reportsErrorOfClosedForm()
{
    Random random(2);
    RbfNetwork root;
    root.inputs.mean = Eigen::RowVector3d::Zero();
    root.inputs.scale = Eigen::RowVector3d::Ones();
    root.centres.resize(0, 3);
    root.weightsDps.resize(0, 3);
    root.linearDps(2, 0) = 0.2;
    TrainedModel model = framed(random, "rbf", root);
    model.lowestTemperatureC = model.referenceTemperatureC = -40.0;
    model.highestTemperatureC = 85.0;
    const auto table = makeCompensationTable(model, kAllAxes, {.maxInterpolationErrorDps = 0.02});
    QVERIFY(table.ok());
    const double expected = 0.2 * std::sqrt(table->stepC()) / 4.0;
    QVERIFY(std::abs(table->measuredErrorDps - expected) < 0.01 * expected);
    QVERIFY(table->measuredErrorDps <= 0.02);
}

void TestCompensationTable::makeCompensationTable_tighterBound_needsMoreKnots()
{
    Random random = announced(20261102);
    for (int i = 0; i < 10; ++i) {
        const TrainedModel cubic = randomCubic(random);
        Eigen::Index previous = 0;
        for (const double bound : {1e-1, 1e-2, 1e-3}) {
            const auto table = makeCompensationTable(cubic, kAllAxes, {.maxInterpolationErrorDps = bound});
            QVERIFY(table.ok());
            QVERIFY(table->size() >= previous);
            previous = table->size();
        }
    }
}

void TestCompensationTable::makeCompensationTable_unreachableBound_namesTheReachableOne()
{
    Random random(4);
    const TrainedModel model = randomRbf(random, 1.0);
    TableOptions options{.maxInterpolationErrorDps = 1e-5, .largestKnotCount = 65};
    const auto refused = makeCompensationTable(model, kAllAxes, options);
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(refused.error().message);
    const QRegularExpressionMatch match =
        QRegularExpression(QStringLiteral("ask for ([0-9.e-]+) dps")).match(message);
    QVERIFY2(match.hasMatch(), qPrintable(message));
    options.maxInterpolationErrorDps = match.captured(1).toDouble();
    QVERIFY(makeCompensationTable(model, kAllAxes, options).ok());

    // Unasked, the table is as good as its size allows, and says how good.
    options.maxInterpolationErrorDps.reset();
    const auto relaxed = makeCompensationTable(model, kAllAxes, options);
    QVERIFY(relaxed.ok());
    QVERIFY(relaxed->interpolationErrorBoundDps > TableOptions::kDefaultErrorDps);
    QVERIFY(relaxed->measuredErrorDps < relaxed->interpolationErrorBoundDps);
}

void TestCompensationTable::makeCompensationTable_axisLeftOut_hasZeros()
{
    Random random(5);
    const TrainedModel model = randomRbf(random);
    const auto table = makeCompensationTable(model, {true, false, true}, {});
    QVERIFY(table.ok());
    QVERIFY((table->tdeDps.col(1).array() == 0.0).all());
    QVERIFY((table->tdeDps.col(0).array() != 0.0).any());
    QCOMPARE(table->compensated[1], false);
}

void TestCompensationTable::makeCompensationTable_badInput_isRefused_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("bias");
    QTest::addColumn<double>("bound");
    QTest::addColumn<int>("knots");
    QTest::addColumn<Errc>("code");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::newRow("never trained") << 0.0 << 0.0 << 1.0 << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("range upside down") << 50.0 << 10.0 << 1.0 << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("range not a number") << nan << 10.0 << 1.0 << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("range endless") << 0.0 << infinity << 1.0 << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("output not a number") << 0.0 << 10.0 << nan << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("output infinite") << 0.0 << 10.0 << infinity << 0.001 << 100 << Errc::ModelNotUsableHere;
    QTest::newRow("bound zero") << 0.0 << 10.0 << 1.0 << 0.0 << 100 << Errc::InvalidOption;
    QTest::newRow("bound not a number") << 0.0 << 10.0 << 1.0 << nan << 100 << Errc::InvalidOption;
    QTest::newRow("one knot") << 0.0 << 10.0 << 1.0 << 0.001 << 1 << Errc::InvalidOption;
    QTest::newRow("too many knots") << 0.0 << 10.0 << 1.0 << 0.001 << 100000 << Errc::InvalidOption;
}

void TestCompensationTable::makeCompensationTable_badInput_isRefused()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, bias);
    QFETCH(double, bound);
    QFETCH(int, knots);
    QFETCH(Errc, code);
    Random random(6);
    TrainedModel model = framed(random, "constant", ConstantModel{Eigen::Vector3d(0.0, bias, 0.0)});
    model.lowestTemperatureC = low;
    model.highestTemperatureC = high;
    const auto table = makeCompensationTable(model, kAllAxes,
                                             {.maxInterpolationErrorDps = bound, .largestKnotCount = knots});
    QVERIFY(!table.ok());
    QCOMPARE(table.error().code, code);
    QVERIFY(table.error().message.ends_with('.'));
}

static CompensationTable tent()
{
    CompensationTable table;
    table.firstMilliC = -10000;
    table.lastMilliC = 30000;
    table.tdeDps.resize(3, 3);
    table.tdeDps << 0.0, 1.0, -2.0, 4.0, 1.0, 2.0, 0.0, 3.0, 6.0;
    return table;
}

void TestCompensationTable::apply_insideAndOutside_interpolatesAndHoldsTheEnds()
{
    Eigen::VectorXf temperatureC(7);
    temperatureC << -300.0F, -10.0F, 0.0F, 10.0F, 15.0F, 30.0F, 1e30F;
    Eigen::MatrixX3f expected(7, 3);
    expected << 0, 1, -2, 0, 1, -2, 2, 1, 0, 4, 1, 2, 3, 1.5, 3, 0, 3, 6, 0, 3, 6;
    QVERIFY((TableApply<float>(tent()).tde(temperatureC) - expected).cwiseAbs().maxCoeff() < 1e-6F);
    QVERIFY((TableApply<double>(tent()).tde(temperatureC.cast<double>()) - expected.cast<double>())
                .cwiseAbs()
                .maxCoeff() < 1e-14);
}

void TestCompensationTable::apply_notFiniteTemperature_givesNoNumber()
{
    Eigen::VectorXd temperatureC(4);
    temperatureC << std::numeric_limits<double>::quiet_NaN(), 5.0, std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity();
    const Eigen::MatrixX3d tde = TableApply<double>(tent()).tde(temperatureC);
    QVERIFY(tde.row(0).array().isNaN().all());
    QVERIFY(tde.row(1).allFinite());
    QVERIFY(tde.bottomRows(2).array().isNaN().all());
}

void TestCompensationTable::apply_anyLength_equalsSampleBySample()
{
    Random random = announced(20261103);
    const TrainedModel model = randomRbf(random);
    const auto table = makeCompensationTable(model, kAllAxes, {});
    QVERIFY(table.ok());
    const TableApply<float> apply(*table);
    for (const Eigen::Index length : {0, 1, 3, 63, 64, 65, 127, 1000}) {
        Eigen::VectorXf temperatureC(length);
        Eigen::MatrixX3f rate(length, 3);
        for (Eigen::Index i = 0; i < length; ++i) {
            temperatureC[i] = static_cast<float>(random.uniform(-60.0, 140.0));
            for (int axis = 0; axis < 3; ++axis)
                rate(i, axis) = static_cast<float>(random.normal());
        }
        Eigen::MatrixX3f compensated = rate;
        apply.apply(temperatureC, compensated, compensated);
        for (Eigen::Index i = 0; i < length; ++i) {
            const Eigen::MatrixX3f one = apply.tde(temperatureC.segment(i, 1));
            QVERIFY((compensated.row(i) == rate.row(i) - one.row(0)));
        }
        if (length > 0) {
            const Eigen::MatrixX3d exact = TableApply<double>(*table).tde(temperatureC.cast<double>());
            QVERIFY((apply.tde(temperatureC).cast<double>() - exact).cwiseAbs().maxCoeff() < 5e-4);
        }
    }
}

void TestCompensationTable::selectAxes_verdicts_decide()
{
    Random random(8);
    TrainedModel model = randomCubic(random);
    model.verdicts = {Verdict::NotRepeatable, Verdict::Yes, std::nullopt};
    model.reasons = {"the runs read -3.99 and -4.21 dps.", "gain 0.99", ""};

    const auto byDefault = selectAxes(model);
    QVERIFY(byDefault.ok());
    QCOMPARE(byDefault->compensated, (std::array<bool, 3>{false, true, false}));
    QCOMPARE(byDefault->notes.size(), std::size_t(1));
    QVERIFY(
        byDefault->notes[0].find("x (not repeatable: the runs read -3.99 and -4.21 dps), z (never judged)") !=
        std::string::npos);

    const auto asked = selectAxes(model, std::array<bool, 3>{true, true, false});
    QVERIFY(!asked.ok());
    QCOMPARE(asked.error().code, Errc::VerdictForbids);
    for (const char *part : {"x (not repeatable", "-3.99", "--force"})
        QVERIFY(asked.error().message.find(part) != std::string::npos);

    const auto forced = selectAxes(model, std::array<bool, 3>{true, true, false}, true);
    QVERIFY(forced.ok());
    QCOMPARE(forced->compensated, (std::array<bool, 3>{true, true, false}));
    QCOMPARE(forced->notes.size(), std::size_t(2));
    QCOMPARE(selectAxes(model, std::nullopt, true)->compensated, kAllAxes);

    model.verdicts = {Verdict::WithCare, Verdict::NoDrift, std::nullopt};
    QCOMPARE(selectAxes(model).error().code, Errc::VerdictForbids);
    QCOMPARE(selectAxes(model, std::array<bool, 3>{}).error().code, Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestCompensationTable)
#include "tst_compensation_table.moc"
