#include "engine/base/text.h"
#include "engine/physics/datasheets.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/sensor_presets.h"

#include <Eigen/QR>
#include <QTest>

using namespace driftbench;

class TestSensorPresets : public QObject
{
    Q_OBJECT

private slots:
    void i3g4250d_onThePapersProfile_liesInTables2To6();
    void l3gd20h_onThePapersProfile_liesInTable1();
    void everyRun_ofTheCampaign_liesInTheTables();
    void preset_takesTheDatasheetsFigures();
    void preset_unknownOrOutOfRange_isRefused();
};

namespace {

const Eigen::Vector3d kPapersRatesDps{25.0, 5.0, 53.0};

SimulationOptions presetOptions(std::string_view model, const Eigen::Vector3d &referenceRateDps)
{
    auto options = presetSimulation(model, referenceRateDps);
    if (!options)
        qFatal("%s", options.error().message.c_str());
    return *std::move(options);
}

struct Squares // of the drift alone, over the samples of the profile behind the chamber's lag
{
    Eigen::Vector3d meanDps2;
    Eigen::Vector3d leftByLineDps2; // by least squares
};

Squares squaresOf(SimulationOptions options)
{
    const DriftTable truth = campaignTruth(options);
    options.chamber.thermometerNoiseC = 0.0;
    options.gyro.sampleRateHz = 1.0;
    const Recording recording = *simulateRun(options, 0);
    Eigen::MatrixX3d driftDps(recording.size(), kAxisCount);
    for (Eigen::Index i = 0; i < recording.size(); ++i)
        driftDps.row(i) = truth.rateDps(recording.temperatureC[i]).transpose();
    Eigen::MatrixX2d line(recording.size(), 2);
    line << Eigen::VectorXd::Ones(recording.size()), recording.temperatureC;
    const Eigen::MatrixX3d left = driftDps - line * line.colPivHouseholderQr().solve(driftDps);
    const auto samples = static_cast<double>(recording.size());
    return {driftDps.colwise().squaredNorm().transpose() / samples,
            left.colwise().squaredNorm().transpose() / samples};
}

bool within(double value, double low, double high)
{
    if (value < low || value > high)
        qWarning("%g is not in %g .. %g", value, low, high);
    return value >= low && value <= high;
}

} // namespace

void TestSensorPresets::i3g4250d_onThePapersProfile_liesInTables2To6()
{
    const SimulationOptions options = presetOptions("I3G4250D", kPapersRatesDps);
    const double noise = options.gyro.noiseDps * options.gyro.noiseDps;
    QVERIFY(within(noise, 0.0184, 0.0221)); // MSD6
    const Squares squares = squaresOf(options);
    QVERIFY(within(squares.meanDps2[0] + noise, 3.8538, 4.7794)); // MSD1
    QVERIFY(within(squares.meanDps2[1] + noise, 6.8208, 8.5962));
    QVERIFY(within(squares.meanDps2[2] + noise, 0.6538, 0.7286));
    QVERIFY(within(squares.leftByLineDps2[0], 0.0009, 0.0023)); // MSD4 - MSD6
    QVERIFY(within(squares.leftByLineDps2[1], 0.0044, 0.0068));
    QVERIFY(within(squares.leftByLineDps2[2], 0.0060, 0.0073));
}

void TestSensorPresets::l3gd20h_onThePapersProfile_liesInTable1()
{
    const SimulationOptions options = presetOptions("L3GD20H", Eigen::Vector3d::Zero());
    const double noise = options.gyro.noiseDps * options.gyro.noiseDps;
    QVERIFY(within(noise, 0.031339, 0.032172)); // MSD3
    const Squares squares = squaresOf(options);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        QVERIFY(within(squares.meanDps2[axis] + noise, 9.5507, 9.5590)); // MSD1
        QVERIFY(within(squares.leftByLineDps2[axis], 0.0028, 0.0044));   // MSD2 - MSD3
    }
}

void TestSensorPresets::everyRun_ofTheCampaign_liesInTheTables()
{
    SimulationOptions options = presetOptions("I3G4250D", kPapersRatesDps);
    options.gyro.sampleRateHz = 1.0;
    for (options.seed = 1; options.seed <= 5; ++options.seed) {
        for (int run = 0; run < 5; ++run) {
            const Recording recording = *simulateRun(options, run);
            const Eigen::RowVector3d mean =
                (recording.rateDps.rowwise() - kPapersRatesDps.transpose()).colwise().squaredNorm() /
                static_cast<double>(recording.size());
            QVERIFY(within(mean[0], 3.85, 4.78));
            QVERIFY(within(mean[1], 6.82, 8.60));
            QVERIFY(within(mean[2], 0.65, 0.73));
        }
    }
}

void TestSensorPresets::preset_takesTheDatasheetsFigures()
{
    for (const std::string_view model : kSensorNames) {
        const SensorDatasheet datasheet = *namedSensor(model);
        const SimulationOptions options = presetOptions(lowered(model), kPapersRatesDps);
        QCOMPARE(options.sensor.model, std::string(model));
        QCOMPARE(options.gyro.sensitivityMdps, datasheet.sensitivityMdps);
        QCOMPARE(options.gyro.rangeDps, datasheet.rangeDps);
        QVERIFY(options.gyro.referenceRateDps == kPapersRatesDps);
        QCOMPARE(options.truth.name, std::string(kCombDriftName));
        QVERIFY(options.combs.has_value());
        QCOMPARE(options.profile.durationS(), 11100.0);
    }
}

void TestSensorPresets::preset_unknownOrOutOfRange_isRefused()
{
    const auto unknown = presetSimulation("MPU6000", Eigen::Vector3d::Zero());
    QVERIFY(!unknown.ok());
    QCOMPARE(unknown.error().code, Errc::InvalidOption);
    QVERIFY(unknown.error().message.find("I3G4250D, L3GD20H") != std::string::npos);
    const auto fast = presetSimulation("L3GD20H", {0.0, 0.0, 300.0});
    QVERIFY(!fast.ok());
    QVERIFY(fast.error().message.find("reference rate on z is 300 dps") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestSensorPresets)
#include "tst_sensor_presets.moc"
