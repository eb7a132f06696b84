#include "engine/physics/datasheets.h"

#include <QTest>

#include <limits>

using namespace driftbench;

class TestDatasheets : public QObject
{
    Q_OBJECT

private slots:
    void named_every_isAcceptedInAnyCase();
    void named_unknown_listsTheKnownOnes();
    void check_anyFigureThatCannotBe_isNamed();
};

void TestDatasheets::named_every_isAcceptedInAnyCase()
{
    for (const std::string_view name : kSensorNames) {
        const auto sensor = namedSensor(name);
        QVERIFY(sensor.ok());
        QCOMPARE(sensor->model, std::string(name));
        QVERIFY(checkDatasheet(*sensor).ok());
        QCOMPARE(namedSensor(QString::fromUtf8(name.data()).toLower().toStdString())->model, sensor->model);
    }
    for (const std::string_view name : kChamberNames) {
        const auto chamber = namedChamber(name);
        QVERIFY(chamber.ok());
        QCOMPARE(chamber->model, std::string(name));
        QVERIFY(checkDatasheet(*chamber).ok());
    }
    // Eq. 26 and 27 of the paper.
    QCOMPARE(namedSensor("l3gd20h")->sensitivityMdps, 8.75);
    QCOMPARE(namedSensor("l3gd20h")->zeroRateChangeMdpsPerC, 40.0);
    QCOMPARE(namedSensor("l3gd20h")->zeroRateChangeRangeDps, 2000.0);
}

void TestDatasheets::named_unknown_listsTheKnownOnes()
{
    const auto sensor = namedSensor("MPU6000");
    QVERIFY(!sensor.ok());
    QCOMPARE(sensor.error().code, Errc::InvalidOption);
    for (const std::string_view name : kSensorNames)
        QVERIFY(sensor.error().message.find(name) != std::string::npos);
    const auto chamber = namedChamber("");
    QVERIFY(!chamber.ok());
    QVERIFY(chamber.error().message.find("SET-Z-021") != std::string::npos);
}

void TestDatasheets::check_anyFigureThatCannotBe_isNamed()
{
    const auto refused = [](const Status &status, const char *says) {
        return !status.ok() && status.error().code == Errc::InvalidOption &&
               status.error().message.find(says) != std::string::npos &&
               status.error().message.ends_with('.');
    };
    struct SensorFigure
    {
        double SensorDatasheet::*figure;
        const char *name;
    };
    struct ChamberFigure
    {
        double ChamberDatasheet::*figure;
        const char *name;
    };
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        for (const SensorFigure &each :
             {SensorFigure{&SensorDatasheet::sensitivityMdps, "sensitivity of"},
              SensorFigure{&SensorDatasheet::rangeDps, "The range"},
              SensorFigure{&SensorDatasheet::zeroRateChangeMdpsPerC, "zero-rate level change of"},
              SensorFigure{&SensorDatasheet::zeroRateChangeRangeDps, "full scale"},
              SensorFigure{&SensorDatasheet::sensitivityChangePercent, "sensitivity change"},
              SensorFigure{&SensorDatasheet::noiseDensityDpsPerRootHz, "noise density"}}) {
            SensorDatasheet sensor = *namedSensor("L3GD20H");
            sensor.*each.figure = bad;
            QVERIFY(refused(checkDatasheet(sensor), each.name));
        }
        for (const ChamberFigure &each :
             {ChamberFigure{&ChamberDatasheet::edgeM, "inner edge"},
              ChamberFigure{&ChamberDatasheet::specificHeatJPerKgK, "specific heat"},
              ChamberFigure{&ChamberDatasheet::densityKgPerM3, "density"},
              ChamberFigure{&ChamberDatasheet::conductivityWPerMK, "heat conductivity"},
              ChamberFigure{&ChamberDatasheet::thermometerAccuracyC, "thermometer"}}) {
            ChamberDatasheet chamber = *namedChamber("SET-Z-021");
            chamber.*each.figure = bad;
            QVERIFY(refused(checkDatasheet(chamber), each.name));
        }
    }
    SensorDatasheet cold = *namedSensor("L3GD20H");
    cold.lowestC = -300.0;
    QVERIFY(refused(checkDatasheet(cold), "absolute zero"));
    cold.lowestC = 90.0;
    QVERIFY(refused(checkDatasheet(cold), "lower end"));
}

QTEST_APPLESS_MAIN(TestDatasheets)
#include "tst_datasheets.moc"
