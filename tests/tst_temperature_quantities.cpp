#include "engine/base/random.h"
#include "engine/features/temperature_quantities.h"

#include <QTest>

using namespace driftbench;

class TestTemperatureQuantities : public QObject
{
    Q_OBJECT

private slots:
    void signedRoot_squared_isTheValue();
    void signedRoot_isOdd();
    void quantities_ofFour_areKnown();
    void quantities_ofEverySet_areTheFirstColumns();
};

void TestTemperatureQuantities::signedRoot_squared_isTheValue()
{
    constexpr std::uint64_t kSeed = 31;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const double deltaT = random.uniform(-200.0, 200.0);
        const double root = signedRoot(deltaT);
        QVERIFY(std::abs(root * std::abs(root) - deltaT) <= 1e-13 * std::abs(deltaT));
    }
    QCOMPARE(signedRoot(0.0), 0.0);
}

void TestTemperatureQuantities::signedRoot_isOdd()
{
    QCOMPARE(signedRoot(-2.25), -1.5);
    QCOMPARE(signedRoot(2.25), 1.5);
}

void TestTemperatureQuantities::quantities_ofFour_areKnown()
{
    QCOMPARE(temperatureQuantities(-4.0), Eigen::Vector3d(-4.0, 16.0, -2.0));
}

void TestTemperatureQuantities::quantities_ofEverySet_areTheFirstColumns()
{
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(51, -40.0, 85.0);
    for (const FeatureSet set :
         {FeatureSet::DeltaT, FeatureSet::DeltaTSquared, FeatureSet::DeltaTSquaredRoot}) {
        const Eigen::MatrixXd quantities = temperatureQuantities(set, deltaT);
        QCOMPARE(quantities.rows(), deltaT.size());
        QCOMPARE(quantities.cols(), static_cast<Eigen::Index>(set));
        for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
            const Eigen::Vector3d row = temperatureQuantities(deltaT[i]);
            QCOMPARE(Eigen::VectorXd(quantities.row(i)), Eigen::VectorXd(row.head(quantities.cols())));
        }
        QVERIFY(!featureSetName(set).empty());
    }
}

QTEST_APPLESS_MAIN(TestTemperatureQuantities)
#include "tst_temperature_quantities.moc"
