#include "engine/physics/temperature_profile.h"

#include <QTest>

#include <limits>

using namespace driftbench;

class TestTemperatureProfile : public QObject
{
    Q_OBJECT

private slots:
    void named_paper_isTheExperimentOfThePaper();
    void named_every_staysInItsRangeAndMovesInOrder();
    void named_unknown_listsTheKnownOnes();
    void build_wayThatIsNoMultipleOfTheStep_endsExactlyAtTheTarget();
    void build_repeats_goOnWhereTheLastEnded();
    void build_rampAfterHold_startsMovingAtOnce();
    void build_badValue_saysWhichInOneSentence_data();
    void build_badValue_saysWhichInOneSentence();
};

void TestTemperatureProfile::named_paper_isTheExperimentOfThePaper()
{
    const auto paper = TemperatureProfile::named("paper");
    QVERIFY(paper.ok());
    QCOMPARE(paper->durationS(), 11100.0);
    QCOMPARE(paper->lowestC(), -40.0);
    QCOMPARE(paper->highestC(), 85.0);
    QCOMPARE(paper->steps().size(), std::size_t{251});
    QCOMPARE(paper->setpointC(0.0), -40.0);
    QCOMPARE(paper->setpointC(1799.9), -40.0);
    QCOMPARE(paper->setpointC(1800.0), -39.5);
    QCOMPARE(paper->setpointC(1829.9), -39.5);
    QCOMPARE(paper->setpointC(1830.0), -39.0);
    QCOMPARE(paper->setpointC(9269.9), 84.5);
    QCOMPARE(paper->setpointC(9270.0), 85.0);
    QCOMPARE(paper->setpointC(20000.0), 85.0);
}

void TestTemperatureProfile::named_every_staysInItsRangeAndMovesInOrder()
{
    for (const std::string_view name : kProfileNames) {
        const auto profile = TemperatureProfile::named(name);
        QVERIFY(profile.ok());
        QCOMPARE(profile->name(), std::string(name));
        double beforeS = -1.0;
        for (const ProfileStep &step : profile->steps()) {
            QVERIFY(step.startS > beforeS && step.startS < profile->durationS());
            QVERIFY(step.setpointC >= profile->lowestC() && step.setpointC <= profile->highestC());
            beforeS = step.startS;
        }
    }
    QCOMPARE(TemperatureProfile::named("cycle")->durationS(), 3 * 1800.0 + 2 * 7500.0);
    QCOMPARE(TemperatureProfile::named("cooling")->setpointC(1e5), -40.0);
    QVERIFY(TemperatureProfile::named("quick")->durationS() < 600.0);
}

void TestTemperatureProfile::named_unknown_listsTheKnownOnes()
{
    const auto profile = TemperatureProfile::named("papers");
    QVERIFY(!profile.ok());
    QCOMPARE(profile.error().code, Errc::InvalidOption);
    for (const std::string_view name : kProfileNames)
        QVERIFY(profile.error().message.find(name) != std::string::npos);
}

void TestTemperatureProfile::build_wayThatIsNoMultipleOfTheStep_endsExactlyAtTheTarget()
{
    const auto up = TemperatureProfile::build("up", 0.0, {RampSegment{1.0, 0.3, 10.0}});
    QVERIFY(up.ok());
    QCOMPARE(up->durationS(), 40.0);
    QCOMPARE(up->setpointC(25.0), 0.3 * 3);
    QCOMPARE(up->setpointC(30.0), 1.0);
    // 0.1 is no binary fraction: 10 steps, not 11.
    const auto tenths = TemperatureProfile::build("tenths", 0.0, {RampSegment{1.0, 0.1, 1.0}});
    QCOMPARE(tenths->durationS(), 10.0);
    const auto down = TemperatureProfile::build("down", 5.0, {RampSegment{-5.0, 4.0, 2.0}});
    QCOMPARE(down->durationS(), 6.0);
    QCOMPARE(down->setpointC(0.0), 1.0);
    QCOMPARE(down->setpointC(2.0), -3.0);
    QCOMPARE(down->setpointC(4.0), -5.0);
}

void TestTemperatureProfile::build_repeats_goOnWhereTheLastEnded()
{
    const auto cycle = TemperatureProfile::build(
        "cycle", 0.0, {RampSegment{10.0, 1.0, 1.0}, RampSegment{0.0, 1.0, 1.0}, HoldSegment{5.0}}, 3);
    QVERIFY(cycle.ok());
    QCOMPARE(cycle->durationS(), 75.0);
    for (double timeS = 0.5; timeS < 25.0; timeS += 1.0) {
        QCOMPARE(cycle->setpointC(timeS + 25.0), cycle->setpointC(timeS));
        QCOMPARE(cycle->setpointC(timeS + 50.0), cycle->setpointC(timeS));
    }
}

void TestTemperatureProfile::build_rampAfterHold_startsMovingAtOnce()
{
    const auto profile =
        TemperatureProfile::build("p", 20.0, {HoldSegment{100.0}, RampSegment{21.0, 0.5, 30.0}});
    QCOMPARE(profile->setpointC(99.999), 20.0);
    QCOMPARE(profile->setpointC(100.0), 20.5);
    QCOMPARE(profile->setpointC(130.0), 21.0);
    QCOMPARE(profile->durationS(), 160.0);
}

void TestTemperatureProfile::build_badValue_saysWhichInOneSentence_data()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<double>("startC");
    QTest::addColumn<double>("holdS");
    QTest::addColumn<double>("targetC");
    QTest::addColumn<double>("stepC");
    QTest::addColumn<double>("periodS");
    QTest::addColumn<int>("repeats");
    QTest::addColumn<QString>("says");
    QTest::newRow("start below absolute zero") << -300.0 << 1.0 << 1.0 << 1.0 << 1.0 << 1 << "absolute zero";
    QTest::newRow("target below absolute zero") << 0.0 << 1.0 << -274.0 << 1.0 << 1.0 << 1 << "absolute zero";
    QTest::newRow("target NaN") << 0.0 << 1.0 << nan << 1.0 << 1.0 << 1 << "absolute zero";
    QTest::newRow("step zero") << 0.0 << 1.0 << 1.0 << 0.0 << 1.0 << 1 << "0 °C a step";
    QTest::newRow("step negative") << 0.0 << 1.0 << 1.0 << -0.5 << 1.0 << 1 << "-0.5 °C a step";
    QTest::newRow("period zero") << 0.0 << 1.0 << 1.0 << 1.0 << 0.0 << 1 << "0 s a step";
    QTest::newRow("period infinite") << 0.0 << 1.0 << 1.0 << 1.0 << infinity << 1 << "inf s a step";
    QTest::newRow("hold negative") << 0.0 << -1.0 << 1.0 << 1.0 << 1.0 << 1 << "A hold";
    QTest::newRow("steps without end") << 0.0 << 1.0 << 100.0 << 1e-9 << 1.0 << 1 << "million";
    QTest::newRow("no repeat") << 0.0 << 1.0 << 1.0 << 1.0 << 1.0 << 0 << "repeated 0 times";
    QTest::newRow("no time") << 0.0 << 0.0 << 0.0 << 1.0 << 1.0 << 1 << "lasts 0 s";
}

void TestTemperatureProfile::build_badValue_saysWhichInOneSentence()
{
    QFETCH(double, startC);
    QFETCH(double, holdS);
    QFETCH(double, targetC);
    QFETCH(double, stepC);
    QFETCH(double, periodS);
    QFETCH(int, repeats);
    QFETCH(QString, says);
    const auto profile = TemperatureProfile::build(
        "bad", startC, {HoldSegment{holdS}, RampSegment{targetC, stepC, periodS}}, repeats);
    QVERIFY(!profile.ok());
    QCOMPARE(profile.error().code, Errc::InvalidOption);
    const QString message = QString::fromStdString(profile.error().message);
    QVERIFY2(message.contains(says), qPrintable(message));
    QVERIFY(message.endsWith('.') && !message.contains(". "));
}

QTEST_APPLESS_MAIN(TestTemperatureProfile)
#include "tst_temperature_profile.moc"
