// Figures of numpy 1.24.2, printed by  python3 tests/golden/peer_cubics.py
#include "engine/base/random.h"
#include "engine/models/polynomial_model.h"
#include "engine/models/running_median.h"
#include "support/model_data.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace driftbench;

class TestPolynomialModel : public QObject
{
    Q_OBJECT

private slots:
    void fit_asNumpy_data();
    void fit_asNumpy();
    void fit_exactCubic_recovered();
    void fit_foldAfterFold_sameWithCache();
    void fit_samplesNotForTraining_leftOut();
    void fit_noSamples_zero();
    void runningMedian_anySeries_asSorted();
};

using Coefficients = Eigen::Matrix<double, 4, 3>;

static Eigen::VectorXd evenNoise(std::uint64_t seed, Eigen::Index count)
{
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        seed = (1103515245 * seed + 12345) % 2147483648U;
        values[i] = static_cast<double>(seed) / 2147483648.0 - 0.5;
    }
    return values;
}

// The log of the script, with the features over referenceC.
static std::shared_ptr<const RunFeatures> log(std::uint64_t seed, Eigen::Index count, double low, double high,
                                              double seconds, double referenceC)
{
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1)) /
                              static_cast<double>(count - 1);
    const Eigen::VectorXd temperature =
        (low + (high - low) * u.array()).matrix() + 0.3 * evenNoise(seed, count);
    const Eigen::ArrayXd c = (temperature.array() - 20.0) / 40.0;
    Eigen::MatrixX3d rates(count, 3);
    rates.col(0) = 0.8 * c - 0.5 * c.square() + 0.2 * c.cube() + 0.4 * evenNoise(seed + 1, count).array();
    rates.col(1) = -2.0 + 0.3 * (3.0 * c).sin() + 0.2 * evenNoise(seed + 2, count).array();
    rates.col(2) = 0.05 * c.square().square() + 0.3 * evenNoise(seed + 3, count).array();
    return test::makeRun("log", seconds * u, (temperature.array() - referenceC).matrix(), rates);
}

static Coefficients coefficients(const std::vector<double> &values)
{
    Coefficients result;
    for (std::size_t i = 0; i < values.size(); ++i)
        result(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = values[i];
    return result;
}

Q_DECLARE_METATYPE(Coefficients)

void TestPolynomialModel::fit_asNumpy_data()
{
    QTest::addColumn<bool>("px4");
    QTest::addColumn<bool>("both");
    QTest::addColumn<double>("centreC");
    QTest::addColumn<Coefficients>("wanted");
    QTest::newRow("PX4, first log") << true << false << 24.507204115451973
                                    << coefficients({0.08448117448020381, -1.9169580005971556,
                                                     -0.0022339963665525477, 0.017525186232522697,
                                                     0.01911973526420757, 8.030542156370485e-05,
                                                     -0.00027079991216339506, -0.0001560405070176286,
                                                     1.7814095972190348e-05, 2.9165249425643022e-06,
                                                     -1.2600012170140826e-05, 3.662592727476212e-07});
    QTest::newRow("PX4, both logs") << true << true << 32.989823041669844
                                    << coefficients({0.21500549770559627, -1.8275531645609837,
                                                     -0.005621520086000333, 0.013469421563369891,
                                                     0.010385968804943557, 0.0001745980284340306,
                                                     -0.00019376247663639216, -0.0002809655943744229,
                                                     5.2385938856390716e-05, 3.042751591027707e-06,
                                                     -6.049137568952039e-06, 1.1272337856441118e-06});
    QTest::newRow("ArduPilot, first log")
        << false << false << 35.0
        << coefficients({0.24102159020221653, -1.7458155083554805, -0.00038242402914902783,
                         0.012736208538232456, 0.0117039314028172, 0.0005898553043310785,
                         -0.0001726065742540585, -0.0005619915640109353, 3.518690802860308e-05,
                         3.1170584226246588e-06, -1.2811007027696314e-05, 4.37937545891859e-07});
    QTest::newRow("ArduPilot, both logs")
        << false << true << 35.0
        << coefficients({0.24094903013431476, -1.7937249711412906, -0.004347978445369108,
                         0.012693714019687432, 0.009602029466071735, 0.00036888811819341073,
                         -0.00017311453208242669, -0.0003434718710233234, 5.702841703093038e-05,
                         3.1277912826766932e-06, -6.657265922821778e-06, 1.0709061566349957e-06});
}

void TestPolynomialModel::fit_asNumpy()
{
    QFETCH(bool, px4);
    QFETCH(bool, both);
    QFETCH(double, centreC);
    QFETCH(Coefficients, wanted);
    constexpr double kReferenceC = 21.0;
    TrainingSet set{{log(1, 6000, -12.0, 61.0, 300.0, kReferenceC)}, kReferenceC};
    if (both)
        set.runs.push_back(log(100, 3000, 10.0, 78.0, 280.0, kReferenceC));
    const PolynomialModel model = px4 ? fitCubicAsPx4(set) : fitCubicAsArduPilot(set);
    QVERIFY(std::abs(model.centreDeltaT + kReferenceC - centreC) < 1e-10);
    QVERIFY(((model.coefficients - wanted).array() / wanted.array()).abs().maxCoeff() < 1e-8);
}

void TestPolynomialModel::fit_exactCubic_recovered()
{
    const auto truth = [](double d) {
        return Eigen::Vector3d(1.0 + 0.02 * d, 4.0 - 0.01 * d + 3e-4 * d * d, 1e-5 * d * d * d - 2.0);
    };
    const TrainingSet set{{test::makeRamp("run", 20000, -30.0, 60.0, truth)}, 12.0};
    // Means of a window of 20 samples shift a curved rate by far less than this.
    const PolynomialModel model = fitCubicAsArduPilot(set);
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(50, -29.0, 59.0);
    const Eigen::MatrixX3d tde = model.predict(deltaT);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        QVERIFY((tde.row(i).transpose() - truth(deltaT[i])).cwiseAbs().maxCoeff() < 1e-5);
    QCOMPARE(model.centreDeltaT, 23.0);
}

void TestPolynomialModel::fit_foldAfterFold_sameWithCache()
{
    TrainingSet set{{}, 15.0};
    for (std::uint64_t run = 0; run < 4; ++run)
        set.runs.push_back(log(10 * run + 1, 4000, -5.0, 50.0 + static_cast<double>(run), 300.0, 15.0));
    const auto cache = makePeerSeriesCache();
    for (std::size_t left = 0; left < set.runs.size(); ++left) {
        const TrainingSet fold = set.without(left);
        QCOMPARE(fitCubicAsPx4(fold, cache).coefficients, fitCubicAsPx4(fold).coefficients);
        QCOMPARE(fitCubicAsArduPilot(fold, cache).coefficients, fitCubicAsArduPilot(fold).coefficients);
    }
}

void TestPolynomialModel::fit_samplesNotForTraining_leftOut()
{
    const auto truth = [](double d) { return Eigen::Vector3d(0.1 * d, 1.0, -0.01 * d * d); };
    const auto clean = test::makeRamp("run", 3000, 0.0, 50.0, truth);
    auto spoilt = std::make_shared<RunFeatures>(*clean);
    spoilt->deltaT.conservativeResize(3001);
    spoilt->timeS.conservativeResize(3001);
    spoilt->tdeDps.conservativeResize(3001, 3);
    spoilt->deltaT[3000] = 70.0;
    spoilt->timeS[3000] = 300.0;
    spoilt->tdeDps.row(3000).setConstant(100.0);
    spoilt->usableForTraining.push_back(0);
    QCOMPARE(fitCubicAsPx4({{spoilt}, 0.0}).coefficients, fitCubicAsPx4({{clean}, 0.0}).coefficients);
    QCOMPARE(fitCubicAsArduPilot({{spoilt}, 0.0}).coefficients,
             fitCubicAsArduPilot({{clean}, 0.0}).coefficients);
}

void TestPolynomialModel::fit_noSamples_zero()
{
    const auto empty = test::makeRun("empty", {}, {}, {});
    for (const TrainingSet &set : {TrainingSet{}, TrainingSet{{empty}, 0.0}}) {
        QCOMPARE(fitCubicAsPx4(set).coefficients, Coefficients(Coefficients::Zero()));
        QCOMPARE(fitCubicAsArduPilot(set).coefficients, Coefficients(Coefficients::Zero()));
    }
}

void TestPolynomialModel::runningMedian_anySeries_asSorted()
{
    constexpr std::uint64_t kSeed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (const Eigen::Index count : {0, 1, 2, 15, 16, 30, 31, 32, 500}) {
        Eigen::VectorXd values(count);
        for (double &value : values) // few different values, so that many are equal
            value = std::floor(random.normal() * 3.0) + (random.below(2) == 0 ? 0.0 : random.uniform());
        const Eigen::VectorXd medians = runningMedian(values);
        QCOMPARE(medians.size(), count);
        for (Eigen::Index i = 0; i < count; ++i) {
            std::vector<double> window;
            for (Eigen::Index k = i - 15; k <= i + 15; ++k)
                window.push_back(k >= 0 && k < count ? values[k] : 0.0);
            std::nth_element(window.begin(), window.begin() + 15, window.end());
            QCOMPARE(medians[i], window[15]);
        }
    }
}

QTEST_APPLESS_MAIN(TestPolynomialModel)
#include "tst_polynomial_model.moc"
