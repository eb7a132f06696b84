// What is done to data before it is drawn.
#include "engine/base/random.h"
#include "support/test_data.h"
#include "support/view_data.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/label_places.h"
#include "widgets/views/model_curve.h"
#include "widgets/views/rbf_centres.h"
#include "widgets/views/scatter_dots.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace driftbench;

class TestWidgetsPlotData : public QObject
{
    Q_OBJECT

private slots:
    void envelope_randomData_keepsExtremesAndMean();
    void envelope_gap_breaksTheLine();
    void thinned_manySamples_keepsDensityInOrder();
    void heatingFlags_upAndDown_partAtTheTop();
    void scatterDots_fewOutliers_areStillShown();
    void pushedApart_randomLabels_keepDistanceAndOrder();
    void modelCurve_interpolated_meetsTheModel();
    void rbfCentres_widthSolvedFromKnownOnes();
};

void TestWidgetsPlotData::envelope_randomData_keepsExtremesAndMean()
{
    constexpr std::uint64_t kSeed = 4;
    Random random(kSeed);
    const Eigen::VectorXd key = Eigen::VectorXd::LinSpaced(8000, 0.0, 100.0);
    Eigen::VectorXd value(8000);
    for (double &v : value)
        v = random.normal();
    const Envelope drawn = envelope(key, value, 0.0, 100.0, 200);
    QCOMPARE(drawn.key.size(), 200);
    QCOMPARE(*std::max_element(drawn.high.begin(), drawn.high.end()), value.maxCoeff());
    QCOMPARE(*std::min_element(drawn.low.begin(), drawn.low.end()), value.minCoeff());
    double mean = 0.0;
    for (qsizetype i = 0; i < drawn.key.size(); ++i) {
        QVERIFY(drawn.low[i] <= drawn.mean[i] && drawn.mean[i] <= drawn.high[i]);
        mean += drawn.mean[i] / 200.0;
    }
    QVERIFY(std::abs(mean - value.mean()) < 1e-3);
}

void TestWidgetsPlotData::envelope_gap_breaksTheLine()
{
    Eigen::VectorXd key = Eigen::VectorXd::LinSpaced(1000, 0.0, 999.0);
    key.tail(500).array() += 1000.0;
    const Envelope drawn = envelope(key, Eigen::VectorXd::Ones(1000), 0.0, 1999.0, 100);
    QCOMPARE(std::count_if(drawn.mean.begin(), drawn.mean.end(), [](double v) { return std::isnan(v); }), 1);
    const Envelope whole = envelope(key.head(500), Eigen::VectorXd::Ones(500), 0.0, 499.0, 100);
    QVERIFY(std::none_of(whole.mean.begin(), whole.mean.end(), [](double v) { return std::isnan(v); }));
}

void TestWidgetsPlotData::thinned_manySamples_keepsDensityInOrder()
{
    const auto kept = thinned(111'000, 4000);
    QCOMPARE(kept.size(), std::size_t{4000});
    QVERIFY(std::is_sorted(kept.begin(), kept.end()));
    QVERIFY(kept.front() >= 0 && kept.back() < 111'000);
    const auto inFirstTenth =
        std::count_if(kept.begin(), kept.end(), [](Eigen::Index i) { return i < 11'100; });
    QVERIFY(std::abs(static_cast<double>(inFirstTenth) - 400.0) <= 1.0);
    QCOMPARE(thinned(7, 4000).size(), std::size_t{7});
    QCOMPARE(thinned(7, 4000).back(), Eigen::Index{6});
    QVERIFY(thinned(0, 10).empty());
}

void TestWidgetsPlotData::heatingFlags_upAndDown_partAtTheTop()
{
    Random random(9);
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(20'001, 0.0, 20'000.0);
    Eigen::VectorXd deltaT(time.size());
    for (Eigen::Index i = 0; i < time.size(); ++i)
        deltaT[i] = 100.0 - std::abs(time[i] - 10'000.0) / 100.0 + 0.03 * random.normal();
    const auto flags = heatingFlags(time, deltaT);
    for (Eigen::Index i = 0; i < time.size(); ++i) {
        if (std::abs(time[i] - 10'000.0) > 200.0)
            QCOMPARE(flags[static_cast<std::size_t>(i)] != 0, time[i] < 10'000.0);
    }
}

void TestWidgetsPlotData::scatterDots_fewOutliers_areStillShown()
{
    const auto runs = test::syntheticRuns(2, 1.0);
    std::vector<Eigen::VectorXd> values;
    for (const auto &run : runs)
        values.emplace_back(run->tdeDps.col(0));
    const ScatterDots dots = scatterDots(runs, values, 1000);
    QVERIFY(dots.excluded.deltaT.size() >= 20);
    QVERIFY(dots.heating.deltaT.size() > 400 && dots.cooling.deltaT.size() > 400);
    QVERIFY(dots.heating.deltaT.size() + dots.cooling.deltaT.size() <= 1000);
}

void TestWidgetsPlotData::pushedApart_randomLabels_keepDistanceAndOrder()
{
    constexpr std::uint64_t kSeed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int round = 0; round < 500; ++round) {
        std::vector<double> wanted(1 + random.below(6));
        for (double &w : wanted)
            w = random.uniform(0.0, 200.0);
        const auto places = pushedApart(wanted, 14.0, 0.0, 200.0);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QVERIFY(places[i] >= -1e-9 && places[i] <= 200.0 + 1e-9);
            for (std::size_t j = 0; j < wanted.size(); ++j) {
                if (wanted[i] < wanted[j])
                    QVERIFY(places[j] - places[i] >= 14.0 - 1e-9);
            }
        }
    }
    QCOMPARE(pushedApart({10.0, 100.0}, 14.0, 0.0, 200.0), (std::vector<double>{10.0, 100.0}));
    QCOMPARE(pushedApart({100.0, 100.0}, 14.0, 0.0, 200.0), (std::vector<double>{93.0, 107.0}));
}

void TestWidgetsPlotData::modelCurve_interpolated_meetsTheModel()
{
    const TrainedModel model = test::syntheticRbf();
    const ModelCurve curve = modelCurve(model);
    QCOMPARE(curve.name, model.name);
    const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(97, 0.0, 125.0);
    const Eigen::MatrixX3d exact = predictAtDeltaT(model.model, deltaT);
    for (Eigen::Index i = 0; i < deltaT.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(interpolated(curve, axis, deltaT[i]) - exact(i, axis)) < 1e-3);
    }
    QCOMPARE(interpolated(curve, 0, 1000.0), curve.tdeDps(curve.tdeDps.rows() - 1, 0));
    QVERIFY(std::isnan(interpolated(curve, 0, NAN)));
    QVERIFY(std::isnan(interpolated(ModelCurve{}, 0, 1.0)));
}

void TestWidgetsPlotData::rbfCentres_widthSolvedFromKnownOnes()
{
    RbfNetwork network;
    network.inputs.mean = Eigen::RowVector3d(60.0, 5000.0, 7.0);
    network.inputs.scale = Eigen::RowVector3d(36.0, 4700.0, 2.6);
    const std::vector<RbfCentre> known{{5.0, 2.0}, {60.0, 31.25}, {120.0, 125.0}, {-10.0, 7.8}};
    network.centres.resize(4, 3);
    network.widths.resize(4);
    for (Eigen::Index k = 0; k < 4; ++k) {
        const auto &[deltaT, width] = known[static_cast<std::size_t>(k)];
        const Eigen::RowVector3d above = temperatureQuantities(deltaT + width).transpose();
        const Eigen::RowVector3d below = temperatureQuantities(deltaT - width).transpose();
        network.centres.row(k) = network.inputs.transform(temperatureQuantities(deltaT).transpose());
        network.widths[k] = 0.5 * (network.inputs.transform(above) - network.inputs.transform(below)).norm();
    }
    const auto centres = rbfCentres(network);
    QCOMPARE(centres.size(), known.size());
    for (std::size_t k = 0; k < known.size(); ++k) {
        QVERIFY(std::abs(centres[k].deltaT - known[k].deltaT) < 1e-9);
        QVERIFY(std::abs(centres[k].widthDeltaT - known[k].widthDeltaT) < 1e-6);
    }
}

QTEST_MAIN(TestWidgetsPlotData)
#include "tst_widgets_plot_data.moc"
