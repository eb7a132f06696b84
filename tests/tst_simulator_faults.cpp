#include "support/simulated_runs.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestSimulatorFaults : public QObject
{
    Q_OBJECT

private slots:
    void biasSteps_changeNothingButTheBias();
    void motion_changesOnlyItsBursts();
    void gaps_loseOnlyTheirSamples();
    void outliers_changeOnlyTheirShareOfSamples();
    void nonFinite_replacesOnlyItsShareOfSamples();
};

void TestSimulatorFaults::biasSteps_changeNothingButTheBias()
{
    SimulationOptions options = optionsFor("quick", "curved");
    options.gyro.sensitivityMdps = 0.0;
    const Recording without = run(options);
    options.faults.biasSteps = 4;
    const Recording with = run(options);
    const auto steps = simulator(options).events().biasSteps;
    QCOMPARE(steps.size(), std::size_t{4});
    QVERIFY(sameBits(with.temperatureC, without.temperatureC));
    for (Eigen::Index i = 0; i < with.size(); ++i) {
        Eigen::Vector3d expected = Eigen::Vector3d::Zero();
        for (const BiasStep &step : steps)
            expected += step.timeS <= with.timeS[i] ? step.stepDps : Eigen::Vector3d::Zero();
        QVERIFY((with.rateDps.row(i) - without.rateDps.row(i) - expected.transpose()).norm() < 1e-12);
    }
    for (const BiasStep &step : steps) {
        QVERIFY(step.stepDps.cwiseAbs().minCoeff() >= 0.5 * options.faults.biasStepDps);
        QVERIFY(step.stepDps.cwiseAbs().maxCoeff() <= options.faults.biasStepDps);
    }
}

void TestSimulatorFaults::motion_changesOnlyItsBursts()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording still = run(options);
    options.faults.motionBursts = 3;
    const Recording moved = run(options);
    const auto bursts = simulator(options).events().motionBursts;
    QCOMPARE(bursts.size(), std::size_t{3});
    for (const MotionBurst &burst : bursts) {
        double largest = 0.0;
        QVERIFY(std::abs(burst.endS - burst.startS - options.faults.motionS) < 1e-9);
        for (Eigen::Index i = 0; i < moved.size(); ++i) {
            if (moved.timeS[i] >= burst.startS && moved.timeS[i] < burst.endS)
                largest =
                    std::max(largest, (moved.rateDps.row(i) - still.rateDps.row(i)).cwiseAbs().maxCoeff());
        }
        QVERIFY(within(largest, 0.5 * options.faults.motionDps * 0.8, options.faults.motionDps + 0.01));
    }
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        const bool inBurst = std::any_of(bursts.begin(), bursts.end(), [&](const MotionBurst &burst) {
            return moved.timeS[i] >= burst.startS && moved.timeS[i] < burst.endS;
        });
        QVERIFY(inBurst || moved.rateDps.row(i) == still.rateDps.row(i));
    }
}

void TestSimulatorFaults::gaps_loseOnlyTheirSamples()
{
    SimulationOptions options = optionsFor("quick", "curved");
    const Recording whole = run(options);
    options.faults.gaps = 3;
    options.faults.gapS = 7.0;
    const Recording broken = run(options);
    const auto gaps = simulator(options).events().gaps;
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < whole.size(); ++i) {
        const bool lost = std::any_of(gaps.begin(), gaps.end(), [&](const Gap &gap) {
            return whole.timeS[i] >= gap.startS && whole.timeS[i] < gap.endS;
        });
        if (lost)
            continue;
        QCOMPARE(broken.timeS[row], whole.timeS[i]);
        QCOMPARE(broken.temperatureC[row], whole.temperatureC[i]);
        QVERIFY(broken.rateDps.row(row) == whole.rateDps.row(i));
        ++row;
    }
    QCOMPARE(row, broken.size());
    QVERIFY(std::abs(static_cast<double>(whole.size() - broken.size()) - 3 * 70.0) <= 3.0);
}

void TestSimulatorFaults::outliers_changeOnlyTheirShareOfSamples()
{
    SimulationOptions options = optionsFor("paper", "mild");
    const Recording clean = run(options);
    options.faults.outlierFraction = 0.01;
    const Recording dirty = run(options);
    Eigen::Index changed = 0;
    for (Eigen::Index i = 0; i < clean.size(); ++i) {
        const Eigen::RowVector3d difference = dirty.rateDps.row(i) - clean.rateDps.row(i);
        if (difference.isZero(0.0))
            continue;
        ++changed;
        // The size is 3 dps, to the nearest count.
        QVERIFY((difference.cwiseAbs().array() - options.faults.outlierDps).abs().maxCoeff() < 0.00876);
    }
    const double expected = 0.01 * static_cast<double>(clean.size());
    QVERIFY(std::abs(static_cast<double>(changed) - expected) < 4.5 * std::sqrt(expected));
}

void TestSimulatorFaults::nonFinite_replacesOnlyItsShareOfSamples()
{
    SimulationOptions options = optionsFor("paper", "mild");
    const Recording clean = run(options);
    options.faults.nonFiniteFraction = 0.005;
    const Recording broken = run(options);
    Eigen::Index lost = 0;
    for (Eigen::Index i = 0; i < clean.size(); ++i) {
        if (broken.rateDps.row(i).array().isNaN().all())
            ++lost;
        else
            QVERIFY(broken.rateDps.row(i) == clean.rateDps.row(i));
    }
    const double expected = 0.005 * static_cast<double>(clean.size());
    QVERIFY(std::abs(static_cast<double>(lost) - expected) < 4.5 * std::sqrt(expected));
}

QTEST_APPLESS_MAIN(TestSimulatorFaults)
#include "tst_simulator_faults.moc"
