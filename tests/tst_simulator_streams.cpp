#include "engine/base/text.h"
#include "support/simulated_runs.h"

#include <QTest>

#include <limits>
#include <set>

using namespace driftbench;
using namespace driftbench::test;

class TestSimulatorStreams : public QObject
{
    Q_OBJECT

private slots:
    void simulateRun_paperProfile_hasThePapersSamples();
    void simulateRun_hookSaysStop_isCancelled();
    void samples_streamedInBlocksOrWhole_areTheSameBits();
    void seed_sameOrOther_givesTheSameOrOtherRun();
    void output_isInWholeCountsAndSaturates();
    void stairs_changeOnlyTheTemperature();
    void checkOptions_badValue_saysWhichInOneSentence_data();
    void checkOptions_badValue_saysWhichInOneSentence();
};

void TestSimulatorStreams::simulateRun_paperProfile_hasThePapersSamples()
{
    const Recording recording = run(optionsFor("paper", "curved"));
    QCOMPARE(recording.size(), Eigen::Index{111000});
    QCOMPARE(recording.timeS[0], 0.0);
    QCOMPARE(recording.timeS[3], 0.3);
    QCOMPARE(recording.timeS[110999], 11099.9);
    QVERIFY(recording.info.simulated);
    QCOMPARE(recording.info.sensor.text(), std::string("I3G4250D SIM-0001"));
    const double atStartC = recording.temperatureC.head(18000).mean();
    QVERIFY(std::abs(atStartC + 40.0) < 0.001);
    QVERIFY(std::abs(recording.temperatureC.tail(10000).mean() - 85.0) < 0.001);
    // 3 standard deviations of the thermometer are its accuracy of 0.03 C.
    const Eigen::ArrayXd off = recording.temperatureC.head(18000).array() - atStartC;
    QVERIFY(within(std::sqrt(off.square().mean()), 0.0098, 0.0102));
}

void TestSimulatorStreams::simulateRun_hookSaysStop_isCancelled()
{
    const auto stopped = simulateRun(optionsFor("paper", "curved"), 0, [](const Progress &progress) {
        return progress.fraction > 0.3 ? Flow::Stop : Flow::Continue;
    });
    QVERIFY(!stopped.ok());
    QCOMPARE(stopped.error().code, Errc::Cancelled);
}

void TestSimulatorStreams::samples_streamedInBlocksOrWhole_areTheSameBits()
{
    const SimulationOptions options = withEverything();
    const Recording whole = run(options, 2);
    QVERIFY(whole.size() > 3000);
    for (const Eigen::Index rows : {Eigen::Index{1}, Eigen::Index{7}, Eigen::Index{5000}}) {
        GyroSimulator one = simulator(options, 2);
        SampleBlock block = SampleBlock::withRows(rows);
        Eigen::Index filled = 0;
        while (const Eigen::Index count = one.fill(block)) {
            QVERIFY(filled + count <= whole.size());
            QVERIFY(sameBits<Eigen::VectorXd>(block.timeS.head(count), whole.timeS.segment(filled, count)));
            QVERIFY(sameBits<Eigen::VectorXd>(block.temperatureC.head(count),
                                              whole.temperatureC.segment(filled, count)));
            QVERIFY(sameBits<Eigen::MatrixX3d>(block.rateDps.topRows(count),
                                               whole.rateDps.middleRows(filled, count)));
            filled += count;
        }
        QCOMPARE(filled, whole.size());
        QCOMPARE(one.fractionDone(), 1.0);
    }
    GyroSimulator one = simulator(options, 2);
    Eigen::Index row = 0;
    while (const auto sample = one.next()) {
        QCOMPARE(sample->timeS, whole.timeS[row]);
        const Eigen::Vector3d expected = whole.rateDps.row(row).transpose();
        QVERIFY(sameBits(sample->rateDps, expected));
        ++row;
    }
    QCOMPARE(row, whole.size());
}

void TestSimulatorStreams::seed_sameOrOther_givesTheSameOrOtherRun()
{
    SimulationOptions options = withEverything();
    const Recording first = run(options);
    QVERIFY(sameBits(first, run(options)));
    QVERIFY(!sameBits(first.rateDps, run(options, 1).rateDps));
    options.seed += 1;
    QVERIFY(!sameBits(first.temperatureC, run(options).temperatureC));
}

void TestSimulatorStreams::output_isInWholeCountsAndSaturates()
{
    SimulationOptions options = optionsFor("quick", "curved");
    options.gyro.referenceRateDps = {244.0, -244.0, 0.0};
    const Recording recording = run(options);
    QCOMPARE(recording.rateDps.col(0).maxCoeff(), 245.0);
    QCOMPARE(recording.rateDps.col(1).minCoeff(), -245.0);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        for (int axis = 0; axis < kAxisCount; ++axis) {
            const double rateDps = recording.rateDps(i, axis);
            const double counts = rateDps * 1000.0 / options.gyro.sensitivityMdps;
            QVERIFY(std::abs(counts - std::round(counts)) < 1e-9);
            QCOMPARE(parseNumber(fixed(rateDps, 5)).value(), rateDps);
        }
        QCOMPARE(parseNumber(fixed(recording.temperatureC[i], 3)).value(), recording.temperatureC[i]);
    }
}

void TestSimulatorStreams::stairs_changeOnlyTheTemperature()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording fine = run(options);
    options.chamber.thermometerCountsPerC = 1.0;
    const Recording stairs = run(options);
    QVERIFY(sameBits(fine.rateDps, stairs.rateDps));
    std::set<double> values;
    for (Eigen::Index i = 0; i < stairs.size(); ++i) {
        QCOMPARE(stairs.temperatureC[i], std::round(stairs.temperatureC[i]));
        QVERIFY(std::abs(stairs.temperatureC[i] - fine.temperatureC[i]) <= 0.5005);
        values.insert(stairs.temperatureC[i]);
    }
    QVERIFY(within(static_cast<double>(values.size()), 120.0, 126.0));
}

void TestSimulatorStreams::checkOptions_badValue_saysWhichInOneSentence_data()
{
    using Change = void (*)(SimulationOptions &);
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *says, Change change) { QTest::newRow(says) << change << QString(says); };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    row("sampling rate is 0 Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = 0.0; });
    row("sampling rate is -10 Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = -10.0; });
    row("sampling rate is nan Hz", [](SimulationOptions &o) { o.gyro.sampleRateHz = kNan; });
    row("sampling rate is inf Hz",
        [](SimulationOptions &o) { o.gyro.sampleRateHz = std::numeric_limits<double>::infinity(); });
    row("has 0.37 samples", [](SimulationOptions &o) { o.gyro.sampleRateHz = 0.001; });
    row("spread between runs is -0.1", [](SimulationOptions &o) { o.gyro.spread = -0.1; });
    row("noise of the rate is -1 dps", [](SimulationOptions &o) { o.gyro.noiseDps = -1.0; });
    row("turn-on bias is -1 dps", [](SimulationOptions &o) { o.gyro.turnOnBiasDps = -1.0; });
    row("lag of the package is -1 s", [](SimulationOptions &o) { o.gyro.packageLagS = -1.0; });
    row("lag of the chamber is nan s", [](SimulationOptions &o) { o.chamber.lagS = kNan; });
    row("noise of the thermometer is -1 °C",
        [](SimulationOptions &o) { o.chamber.thermometerNoiseC = -1.0; });
    row("resolution of the thermometer",
        [](SimulationOptions &o) { o.chamber.thermometerCountsPerC = -1.0; });
    row("dead time of the chamber is -1 s", [](SimulationOptions &o) { o.chamber.deadTimeS = -1.0; });
    row("bias instability is -1 dps", [](SimulationOptions &o) { o.gyro.biasInstabilityDps = -1.0; });
    row("rate random walk is nan dps/√s",
        [](SimulationOptions &o) { o.gyro.rateRandomWalkDpsPerRootS = kNan; });
    row("drift curve curved is not defined at -40 °C", [](SimulationOptions &o) {
        o.truth.rateDps[1] = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
    });
    row("hysteresis is nan dps", [](SimulationOptions &o) { o.gyro.hysteresisDps = kNan; });
    row("play of the hysteresis is 0 °C", [](SimulationOptions &o) { o.gyro.hysteresisPlayC = 0.0; });
    row("sensitivity is -8.75 mdps", [](SimulationOptions &o) { o.gyro.sensitivityMdps = -8.75; });
    row("range of the gyro is 0 dps", [](SimulationOptions &o) { o.gyro.rangeDps = 0.0; });
    row("reference rate on z is 300 dps", [](SimulationOptions &o) { o.gyro.referenceRateDps[2] = 300.0; });
    row("number of bias steps is -1", [](SimulationOptions &o) { o.faults.biasSteps = -1; });
    row("number of motion bursts is -2", [](SimulationOptions &o) { o.faults.motionBursts = -2; });
    row("number of gaps is -3", [](SimulationOptions &o) { o.faults.gaps = -3; });
    row("length of a gap is -1 s", [](SimulationOptions &o) { o.faults.gapS = -1.0; });
    row("fraction of outliers is 1.5", [](SimulationOptions &o) { o.faults.outlierFraction = 1.5; });
    row("fraction of non-finite samples is nan",
        [](SimulationOptions &o) { o.faults.nonFiniteFraction = kNan; });
}

void TestSimulatorStreams::checkOptions_badValue_saysWhichInOneSentence()
{
    using Change = void (*)(SimulationOptions &);
    QFETCH(Change, change);
    QFETCH(QString, says);
    SimulationOptions options = optionsFor("quick", "curved");
    change(options);
    const Status status = checkOptions(options);
    QVERIFY(!status.ok());
    QCOMPARE(status.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(status.error().message);
    QVERIFY2(message.contains(says), qPrintable(message));
    QVERIFY(message.endsWith('.') && !message.contains(". "));
    QCOMPARE(GyroSimulator::create(options, 0).error().message, status.error().message);
}

QTEST_APPLESS_MAIN(TestSimulatorStreams)
#include "tst_simulator_streams.moc"
