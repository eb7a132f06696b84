#include "engine/evaluation/reason.h"
#include "engine/evaluation/recommendation.h"
#include "engine/evaluation/verdict.h"

#include <QTest>

using namespace driftbench;

class TestVerdict : public QObject
{
    Q_OBJECT

private slots:
    void judge_borders_data();
    void judge_borders();
    void judge_anchored_takesTheStartsNoiseOff();
    void recommended_withinAStandardError_isTheSimpler();
    void recommended_simplerWithAWorseVerdict_isNotTaken();
    void recommended_oneRun_isTheBest();
    void reason_eachVerdict_saysItWithFigures();
    void reason_notRepeatable_readsAsOnTheChamber();
};

// f = 1, so that errors read in noise floors.
static HeldOutError heldOut(double constantError, double modelError)
{
    return {"run", constantError + 1.0, modelError + 1.0, 1.0, 0.0};
}

using Errors = std::vector<std::pair<double, double>>; // E0, E1

void TestVerdict::judge_borders_data()
{
    QTest::addColumn<Errors>("errors");
    QTest::addColumn<double>("inRunVariance");
    QTest::addColumn<bool>("singleRun");
    QTest::addColumn<QString>("verdict");

    const auto row = [](const char *name, const Errors &errors, double inRun, bool single,
                        const char *verdict) { QTest::newRow(name) << errors << inRun << single << verdict; };
    row("gain of 0.75", {{1.0, 0.25}, {1.0, 0.25}}, 1.0, false, "yes");
    row("gain just below 0.75", {{1.0, 0.2501}, {1.0, 0.25}}, 1.0, false, "with care");
    row("gain of 0.5", {{1.0, 0.5}, {1.0, 0.5}}, 1.0, false, "with care");
    row("gain just below 0.5", {{1.0, 0.5}, {1.0, 0.5001}}, 1.0, false, "not repeatable");
    row("error of 0.001 f", {{0.001, 0.0}, {0.001, 0.0}}, 1.0, false, "not repeatable");
    row("error just over 0.001 f", {{0.00101, 0.0}, {0.00101, 0.0}}, 1.0, false, "yes");
    row("a run 0.02 f worse", {{9.0, 0.1}, {9.0, 0.1}, {1.0, 1.0199}}, 1.0, false, "yes");
    row("one of three worse", {{9.0, 0.1}, {9.0, 0.1}, {1.0, 1.0201}}, 1.0, false, "with care");
    row("one of two worse", {{9.0, 0.1}, {1.0, 1.1}}, 1.0, false, "not repeatable");
    row("two of five worse", {{9.0, 0.1}, {9.0, 0.1}, {9.0, 0.1}, {1.0, 1.1}, {1.0, 1.1}}, 1.0, false,
        "not repeatable");
    row("two of six worse", {{9.0, 0.1}, {9.0, 0.1}, {9.0, 0.1}, {9.0, 0.1}, {1.0, 1.1}, {1.0, 1.1}}, 1.0,
        false, "with care");
    row("a single run is never a yes", {{9.0, 0.0}, {9.0, 0.0}}, 1.0, true, "with care");
    row("no drift", {{0.0, 0.001}, {0.001, 0.002}}, 0.02, false, "no drift");
    row("just more than no drift", {{0.0, 0.001}, {0.001, 0.002}}, 0.0201, false, "not repeatable");
    row("variance below the noise of its estimate", {{-0.001, 0.001}}, -0.001, false, "no drift");
    row("offsets of runs are no drift", {{5.0, 6.0}, {5.0, 6.0}}, 0.0, false, "no drift");
    row("a small drift that goes is a yes", {{0.006, 0.001}, {0.006, 0.001}}, 0.006, false, "yes");
}

void TestVerdict::judge_borders()
{
    QFETCH(Errors, errors);
    QFETCH(double, inRunVariance);
    QFETCH(bool, singleRun);
    QFETCH(QString, verdict);
    AxisEvidence evidence{{}, inRunVariance, singleRun};
    for (const auto &[constantError, modelError] : errors)
        evidence.heldOut.push_back(heldOut(constantError, modelError));
    QCOMPARE(QString::fromStdString(std::string(verdictName(judge(evidence).verdict))), verdict);
}

void TestVerdict::judge_anchored_takesTheStartsNoiseOff()
{
    AxisEvidence evidence{{heldOut(2.0, 1.0)}, 1.0, false};
    QCOMPARE(judge(evidence).gain, 0.5);
    evidence.heldOut[0].anchorNoise = 0.5;
    QVERIFY(std::abs(judge(evidence).gain - (1.0 - 0.5 / 1.5)) < 1e-12);
}

static Candidate candidate(const std::string &name, int complexity, Verdict verdict, std::vector<double> loss)
{
    return {name, complexity, {verdict, 0.9, 0}, std::move(loss)};
}

void TestVerdict::recommended_withinAStandardError_isTheSimpler()
{
    // Differences 0.1, -0.05, 0.01: mean 0.02, standard error 0.0436.
    std::vector<Candidate> candidates{candidate("linear", 1, Verdict::Yes, {3.0, 3.0, 3.0}),
                                      candidate("cubic", 2, Verdict::Yes, {1.1, 0.95, 1.01}),
                                      candidate("rbf", 5, Verdict::Yes, {1.0, 1.0, 1.0})};
    QCOMPARE(*recommended(candidates), std::size_t{1});
    // The same mean difference without scatter is a difference.
    candidates[1].loss = {1.02, 1.02, 1.02};
    QCOMPARE(*recommended(candidates), std::size_t{2});
    QVERIFY(!recommended({}));
}

void TestVerdict::recommended_simplerWithAWorseVerdict_isNotTaken()
{
    const std::vector<Candidate> candidates{candidate("cubic", 2, Verdict::WithCare, {1.1, 0.95, 1.01}),
                                            candidate("rbf", 5, Verdict::Yes, {1.0, 1.0, 1.0})};
    QCOMPARE(*recommended(candidates), std::size_t{1});
}

void TestVerdict::recommended_oneRun_isTheBest()
{
    std::vector<Candidate> candidates{candidate("cubic", 2, Verdict::Yes, {1.01}),
                                      candidate("rbf", 5, Verdict::Yes, {1.0})};
    QCOMPARE(*recommended(candidates), std::size_t{1});
    candidates[0].loss = {1.00005};
    QCOMPARE(*recommended(candidates), std::size_t{0});
}

// The chamber's x axis, as the cubic does there.
struct Chamber
{
    AxisEvidence evidence;
    Hysteresis hysteresis;
    Repeatability repeatability;

    Chamber()
    {
        const double noise = 1.7e-4;
        evidence.heldOut = {{"run1", 0.168 * 0.168, 0.306 * 0.306, noise, 0.0},
                            {"run2", 0.530 * 0.530, 0.423 * 0.423, noise, 0.0},
                            {"run3", 0.603 * 0.603, 0.544 * 0.544, noise, 0.0}};
        evidence.inRunVariance = 0.04;
        hysteresis.meetingTemperatureC = 40.0;
        for (const double x : {-3.99, -4.21, -3.42})
            hysteresis.passages.push_back({"run" + std::to_string(hysteresis.passages.size() + 1), false,
                                           Eigen::Vector3d(x, 0.34, 1.16)});
        repeatability.repeatRmsDps.setConstant(0.32);
        repeatability.curveRmsDps.setConstant(0.165);
    }

    std::string reason(Judging judging = Judging::Absolute) const
    {
        const Judgement judgement = judge(evidence);
        return reasonFor({0, "cubic", evidence, judgement, hysteresis, repeatability, judging});
    }
};

void TestVerdict::reason_notRepeatable_readsAsOnTheChamber()
{
    Chamber chamber;
    QCOMPARE(
        QString::fromStdString(chamber.reason()),
        QStringLiteral("On x the bias is not a repeatable function of temperature: at 40 °C the runs read "
                       "−3.99, −4.21 and −3.42 dps; on run1 compensation does harm, 0.168 → 0.306 dps rms. "
                       "Runs differ by 0.320 dps rms at the same temperature; the curve they share moves by "
                       "0.165 dps rms."));
    QVERIFY(
        chamber.reason(Judging::Anchored).starts_with("On x, with each run's bias at its start removed,"));
    chamber.hysteresis.passages[1].run = "run1";
    QVERIFY(chamber.reason().find("the sweeps read") != std::string::npos);
    chamber.hysteresis.passages.clear();
    chamber.evidence.heldOut.erase(chamber.evidence.heldOut.begin());
    QVERIFY(chamber.reason().find("cubic takes away only 26 % of what the constant leaves") !=
            std::string::npos);
}

void TestVerdict::reason_eachVerdict_saysItWithFigures()
{
    Chamber chamber;
    for (HeldOutError &run : chamber.evidence.heldOut)
        run.modelMsd = 0.01 * run.constantMsd;
    QCOMPARE(QString::fromStdString(chamber.reason()),
             QStringLiteral(
                 "On x the bias is a repeatable function of temperature: cubic leaves 0.047 dps rms where "
                 "the constant leaves 0.474, and no held-out run gets worse."));

    chamber.evidence.heldOut[0].modelMsd = 0.2 * 0.2;
    QCOMPARE(
        QString::fromStdString(chamber.reason()).section(QStringLiteral(". "), 0, 0),
        QStringLiteral("On x compensation helps, but use it with care: cubic leaves 0.124 dps rms where the "
                       "constant leaves 0.474, but on run1 it does harm, 0.168 → 0.200 dps rms"));

    chamber.evidence.singleRun = true;
    QVERIFY(chamber.reason().find("there is only one run") != std::string::npos);

    for (HeldOutError &run : chamber.evidence.heldOut)
        run = {run.run, 1.7e-4, 1.71e-4, 1.7e-4, 0.0};
    chamber.evidence.inRunVariance = 1e-7;
    QCOMPARE(QString::fromStdString(chamber.reason()),
             QStringLiteral(
                 "On x there is no temperature drift to remove: within a run the bias moves by 0.00032 dps "
                 "rms with temperature, in noise of 0.013 dps rms."));
}

QTEST_APPLESS_MAIN(TestVerdict)
#include "tst_verdict.moc"
