#include "engine/physics/control_figures.h"
#include "engine/physics/gyro_simulator.h"
#include "engine/physics/test_plan.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace driftbench;

class TestTestPlan : public QObject
{
    Q_OBJECT

private slots:
    void interval_L3GD20H_isThePapers();
    void interval_I3G4250D_isRoundedDown();
    void interval_anySensor_keepsTheErrorBelowOneCount();
    void period_paperChamber_printedAndSi();
    void period_rangeBelowZero_hasOnlyTheKelvinFigure();
    void figures_every_hasEquationAndOneSentence();
    void plan_recommended_isTheExperimentOfThePaper();
    void profile_everyKind_agreesWithItsSegments_data();
    void profile_everyKind_agreesWithItsSegments();
    void samples_unevenRate_areThoseThatTheSimulatorMakes();
    void check_badValue_saysWhichInOneSentence_data();
    void check_badValue_saysWhichInOneSentence();
};

namespace {

SensorDatasheet l3gd20h()
{
    return *namedSensor("L3GD20H");
}

ChamberDatasheet paperChamber()
{
    return *namedChamber("SET-Z-021");
}

TestPlan paperPlan()
{
    return *makeTestPlan(l3gd20h(), paperChamber());
}

bool isOneSentence(const std::string &text)
{
    QString sentence = QString::fromStdString(text);
    sentence.remove("Eq. ").remove("Eqs. ");
    return sentence.endsWith('.') && !sentence.contains(". ");
}

bool within(double value, double expected, double tolerance)
{
    return std::abs(value - expected) <= tolerance;
}

} // namespace

void TestTestPlan::interval_L3GD20H_isThePapers()
{
    const auto interval = controlInterval(l3gd20h(), -40.0, 85.0);
    QVERIFY(interval.ok());
    QVERIFY(within(interval->zeroRateMdpsPerC, 4.9, 1e-12));
    QVERIFY(within(interval->sensitivityMdpsPerC, 10.9375, 1e-12));
    QVERIFY(within(interval->printedSensitivityMdpsPerC, 2734.375, 1e-9));
    QVERIFY(within(interval->longestC, 8.75 / 15.8375, 1e-12));
    QVERIFY(within(interval->longestC, 0.5525, 5e-5));
    QCOMPARE(interval->recommendedC, 0.5);
}

void TestTestPlan::interval_I3G4250D_isRoundedDown()
{
    const auto interval = controlInterval(*namedSensor("I3G4250D"), -40.0, 85.0);
    QVERIFY(interval.ok());
    QVERIFY(within(interval->longestC, 8.75 / 40.9375, 1e-12));
    QCOMPARE(interval->recommendedC, 0.2);
}

void TestTestPlan::interval_anySensor_keepsTheErrorBelowOneCount()
{
    for (double sensitivityMdps = 0.01; sensitivityMdps < 200.0; sensitivityMdps *= 1.37) {
        SensorDatasheet sensor = l3gd20h();
        sensor.sensitivityMdps = sensitivityMdps;
        const auto interval = controlInterval(sensor, -10.0, 60.0);
        QVERIFY(interval.ok());
        const double slope = interval->zeroRateMdpsPerC + interval->sensitivityMdpsPerC;
        QVERIFY(within(interval->longestC * slope, sensitivityMdps, 1e-9));
        QVERIFY(interval->recommendedC <= interval->longestC);
        QVERIFY(interval->recommendedC > 0.4 * interval->longestC);
    }
}

void TestTestPlan::period_paperChamber_printedAndSi()
{
    const auto period = controlPeriod(paperChamber(), -40.0, 85.0);
    QVERIFY(period.ok());
    QVERIFY(within(*period->printedS, 25.766, 5e-4));
    QVERIFY(within(*period->celsiusS, 25766.0, 0.5));
    QVERIFY(within(period->kelvinS, 6115.0, 0.5));
    QCOMPARE(period->recommendedS, 30.0);
}

void TestTestPlan::period_rangeBelowZero_hasOnlyTheKelvinFigure()
{
    const auto period = controlPeriod(paperChamber(), -60.0, -10.0);
    QVERIFY(period.ok());
    QVERIFY(!period->printedS && !period->celsiusS);
    QVERIFY(within(period->kelvinS, 17520.7 * 50.0 / 263.15, 1.0));
    QCOMPARE(period->recommendedS, 30.0);
    for (const PlanFigure &figure : periodFigures(*period, paperChamber(), -60.0, -10.0))
        QVERIFY(isOneSentence(figure.remark));
}

void TestTestPlan::figures_every_hasEquationAndOneSentence()
{
    const auto interval = controlInterval(l3gd20h(), -40.0, 85.0);
    const auto period = controlPeriod(paperChamber(), -40.0, 85.0);
    auto figures = intervalFigures(*interval, l3gd20h(), -40.0, 85.0);
    QCOMPARE(figures.size(), std::size_t{7});
    QVERIFY(figures[2].equation.ends_with("125²"));
    QVERIFY(figures[5].equation.ends_with("8.75/(4.9 + 10.9375)"));
    const auto more = periodFigures(*period, paperChamber(), -40.0, 85.0);
    QVERIFY(more[0].equation.find("1.005 × 1.293 × 0.6² × (85 − (−40))/(0.0267 × 85)") != std::string::npos);
    figures.insert(figures.end(), more.begin(), more.end());
    for (const PlanFigure &figure : figures) {
        QVERIFY2(isOneSentence(figure.remark), figure.remark.c_str());
        QVERIFY(!figure.name.empty() && !figure.equation.empty() && !figure.unit.empty() && figure.value);
    }
}

void TestTestPlan::plan_recommended_isTheExperimentOfThePaper()
{
    const TestPlan plan = paperPlan();
    QVERIFY(checkTestPlan(plan).ok());
    QCOMPARE(plan.runDurationS(), 11100.0);
    QCOMPARE(plan.samplesPerRun(), std::int64_t{111000});
    QCOMPARE(plan.samplesInAll(), std::int64_t{555000});
    const auto profile = plan.profile();
    const auto paper = TemperatureProfile::named("paper");
    QVERIFY(profile.ok());
    QCOMPARE(profile->durationS(), paper->durationS());
    QCOMPARE(profile->steps().size(), paper->steps().size());
    for (std::size_t i = 0; i < paper->steps().size(); ++i) {
        QCOMPARE(profile->steps()[i].startS, paper->steps()[i].startS);
        QCOMPARE(profile->steps()[i].setpointC, paper->steps()[i].setpointC);
    }
}

void TestTestPlan::profile_everyKind_agreesWithItsSegments_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("cycles");
    QTest::addColumn<double>("holdS");
    QTest::addColumn<double>("startC");
    QTest::addColumn<double>("endC");
    QTest::addColumn<int>("segments");
    QTest::newRow("heating") << int(PlanKind::Heating) << 1 << 600.0 << -20.0 << 51.0 << 3;
    QTest::newRow("cooling") << int(PlanKind::Cooling) << 1 << 600.0 << 51.0 << -20.0 << 3;
    QTest::newRow("cycle") << int(PlanKind::Cycle) << 1 << 600.0 << -20.0 << -20.0 << 5;
    QTest::newRow("three cycles") << int(PlanKind::Cycle) << 3 << 600.0 << -20.0 << -20.0 << 13;
    QTest::newRow("without holds") << int(PlanKind::Cycle) << 2 << 0.0 << -20.0 << -20.0 << 4;
}

// The stair is ahead of the straight ramp by up to a step, and by up to another where the last is shorter.
void TestTestPlan::profile_everyKind_agreesWithItsSegments()
{
    QFETCH(int, kind);
    QFETCH(int, cycles);
    QFETCH(double, holdS);
    QFETCH(double, startC);
    QFETCH(double, endC);
    TestPlan plan = paperPlan();
    plan.kind = static_cast<PlanKind>(kind);
    plan.cycles = cycles;
    plan.holdS = holdS;
    plan.lowestC = -20.0;
    plan.highestC = 51.0;
    plan.stepC = 2.0; // the last step of a ramp is half of that
    const auto profile = plan.profile();
    QVERIFY(profile.ok());
    const auto segments = plan.segments();
    QTEST(int(segments.size()), "segments");
    QCOMPARE(segments.front().fromC, startC);
    QCOMPARE(segments.back().toC, endC);
    QCOMPARE(segments.back().startS + segments.back().durationS, profile->durationS());
    QCOMPARE(plan.runDurationS(), profile->durationS());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const PlanSegment &segment = segments[i];
        QCOMPARE(segment.startS, i == 0 ? 0.0 : segments[i - 1].startS + segments[i - 1].durationS);
        for (double part = 0.01; part < 1.0; part += 0.037) {
            const double timeS = segment.startS + part * segment.durationS;
            const double straightC = segment.fromC + part * (segment.toC - segment.fromC);
            const double aheadC = profile->setpointC(timeS) - straightC;
            QVERIFY(segment.isHold() ? aheadC == 0.0 : std::abs(aheadC) <= 2.0 * plan.stepC);
        }
        QCOMPARE(profile->setpointC(segment.startS + segment.durationS - 1e-6), segment.toC);
    }
}

void TestTestPlan::samples_unevenRate_areThoseThatTheSimulatorMakes()
{
    for (const double rateHz : {0.3, 1.0, 1.7, 9.99}) {
        TestPlan plan = paperPlan();
        plan.sampleRateHz = rateHz;
        SimulationOptions options{*plan.profile(), *namedDriftCurves("none")};
        options.gyro.sampleRateHz = rateHz;
        QCOMPARE(plan.samplesPerRun(), GyroSimulator::create(options, 0)->sampleCount());
    }
}

void TestTestPlan::check_badValue_saysWhichInOneSentence_data()
{
    using Change = std::function<void(TestPlan &)>;
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto add = [](const char *name, Change change, const char *says) {
        QTest::newRow(name) << change << says;
    };
    add(
        "step 0", [](TestPlan &p) { p.stepC = 0.0; }, "step of the plan is 0");
    add(
        "step negative", [](TestPlan &p) { p.stepC = -0.5; }, "step of the plan is -0.5");
    add(
        "step beyond range", [](TestPlan &p) { p.stepC = 126.0; }, "more than its range of 125");
    add(
        "period 0", [](TestPlan &p) { p.periodS = 0.0; }, "period of the plan is 0");
    add(
        "period nan", [nan](TestPlan &p) { p.periodS = nan; }, "period of the plan is nan");
    add(
        "hold negative", [](TestPlan &p) { p.holdS = -1.0; }, "hold of the plan is -1");
    add(
        "rate 0", [](TestPlan &p) { p.sampleRateHz = 0.0; }, "rate of the plan is 0");
    add(
        "rate too high", [](TestPlan &p) { p.sampleRateHz = 1e6; }, "at most 100000 Hz");
    add(
        "rate too low", [](TestPlan &p) { p.sampleRateHz = 1e-9; }, "less than a sample");
    add(
        "absolute zero", [](TestPlan &p) { p.lowestC = -273.15; }, "above absolute zero");
    add(
        "infinite", [](TestPlan &p) { p.highestC = std::numeric_limits<double>::infinity(); }, "inf");
    add(
        "empty range", [](TestPlan &p) { p.lowestC = 85.0; }, "must be below the highest");
    add(
        "no runs", [](TestPlan &p) { p.runs = 0; }, "number of runs is 0");
    add(
        "no cycles", [](TestPlan &p) { p.cycles = 0; }, "number of cycles is 0");
    add(
        "cycles of a ramp", [](TestPlan &p) { p.cycles = 2; }, "choose the kind cycle");
    add(
        "steps without end", [](TestPlan &p) { p.stepC = 1e-5; }, "more than a million steps");
    add(
        "hours without end", [](TestPlan &p) { p.periodS = 1e6; }, "end within 100 days");
    add(
        "conductivity 0", [](TestPlan &p) { p.chamber.conductivityWPerMK = 0.0; }, "heat conductivity");
    add(
        "edge negative", [](TestPlan &p) { p.chamber.edgeM = -0.6; }, "inner edge");
    add(
        "sensitivity 0", [](TestPlan &p) { p.sensor.sensitivityMdps = 0.0; }, "sensitivity of L3GD20H");
}

void TestTestPlan::check_badValue_saysWhichInOneSentence()
{
    QFETCH(std::function<void(TestPlan &)>, change);
    QFETCH(QString, says);
    TestPlan plan = paperPlan();
    change(plan);
    const Status status = checkTestPlan(plan);
    QVERIFY(!status.ok());
    QCOMPARE(status.error().code, Errc::InvalidOption);
    QVERIFY2(QString::fromStdString(status.error().message).contains(says), status.error().message.c_str());
    QVERIFY(isOneSentence(status.error().message));
    QVERIFY(!plan.profile().ok());
}

QTEST_APPLESS_MAIN(TestTestPlan)
#include "tst_test_plan.moc"
