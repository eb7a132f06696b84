// TMP117 and MCP9808: values of the data sheets' tables, and reading them through a bridge.
#include "device/gyros/die_sign_check.h"
#include "device/gyros/thermometers.h"
#include "support/bridges.h"
#include "support/memory_model.h"
#include "support/thermometer_models.h"

#include <QTest>
#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceThermometers : public QObject
{
    Q_OBJECT

private slots:
    void tmp117_valuesOfTheDataSheet_areExact();
    void mcp9808_valuesOfTheDataSheet_areExact();
    void mcp9808_everyWord_isInRange();
    void find_either_isFoundAndRead_data();
    void find_either_isFoundAndRead();
    void find_otherDevices_isNothing();
    void tmp117_beforeFirstConversion_hasNoValue();
    void open_anotherDevice_isWrongSensor();
    void signCheck_eitherSign_isTold();
};

// TI SNOSD82D, table 7-1.
void TestDeviceThermometers::tmp117_valuesOfTheDataSheet_areExact()
{
    QCOMPARE(*tmp117::decodeTemperatureC(0xF380), -25.0);
    QCOMPARE(*tmp117::decodeTemperatureC(0xFFF0), -0.125);
    QCOMPARE(*tmp117::decodeTemperatureC(0xFFFF), -0.0078125);
    QCOMPARE(*tmp117::decodeTemperatureC(0x0000), 0.0);
    QCOMPARE(*tmp117::decodeTemperatureC(0x0001), 0.0078125);
    QCOMPARE(*tmp117::decodeTemperatureC(0x0C80), 25.0);
    QCOMPARE(*tmp117::decodeTemperatureC(0x3200), 100.0);
    QCOMPARE(*tmp117::decodeTemperatureC(0x7FFF), 255.9921875);
    QVERIFY(!tmp117::decodeTemperatureC(0x8000));
}

// Microchip DS25095A, section 5.1.3: upper byte after masking times 16 plus lower byte / 16, minus 256.
void TestDeviceThermometers::mcp9808_valuesOfTheDataSheet_areExact()
{
    QCOMPARE(mcp9808::decodeTemperatureC(0x0194), 25.25);
    QCOMPARE(mcp9808::decodeTemperatureC(0xC194), 25.25); // with alert flags
    QCOMPARE(mcp9808::decodeTemperatureC(0x1FFF), -0.0625);
    QCOMPARE(mcp9808::decodeTemperatureC(0x1E6C), -25.25);
    QCOMPARE(mcp9808::decodeTemperatureC(0x07D0), 125.0);
}

void TestDeviceThermometers::mcp9808_everyWord_isInRange()
{
    for (int word = 0; word < 0x10000; ++word) {
        const double temperatureC = mcp9808::decodeTemperatureC(static_cast<std::uint16_t>(word));
        QVERIFY(temperatureC >= -256.0 && temperatureC < 256.0);
        QCOMPARE(static_cast<int>(temperatureC * 16.0) & 0x1FFF, word & 0x1FFF);
    }
}

void TestDeviceThermometers::find_either_isFoundAndRead_data()
{
    QTest::addColumn<QString>("bridgeName");
    QTest::addColumn<bool>("isTmp117");
    for (const char *name : kBridgeNames) {
        QTest::addRow("TMP117 on %s", name) << QString(name) << true;
        QTest::addRow("MCP9808 on %s", name) << QString(name) << false;
    }
}

void TestDeviceThermometers::find_either_isFoundAndRead()
{
    QFETCH(QString, bridgeName);
    QFETCH(bool, isTmp117);
    const auto bridge = makeBridge(bridgeName.toStdString());
    Tmp117Model tmp117(bridge->clock);
    Mcp9808Model mcp9808(bridge->clock);
    double trueC = 0.0;
    tmp117.temperatureC = mcp9808.temperatureC = [&](double) { return trueC; };
    if (isTmp117)
        bridge->wires.attach(0x49, tmp117);
    else
        bridge->wires.attach(0x1F, mcp9808);
    Result<std::optional<I2cThermometer>> found = I2cThermometer::find(*bridge->bus);
    QVERIFY(found.ok() && found->has_value());
    I2cThermometer &thermometer = **found;
    QCOMPARE(int(thermometer.address()), isTmp117 ? 0x49 : 0x1F);
    QCOMPARE(thermometerName(thermometer.model()), std::string_view(isTmp117 ? "TMP117" : "MCP9808"));
    bridge->clock.waitS(1.0);
    for (trueC = -40.0; trueC <= 125.0; trueC += 0.37) {
        const Result<std::optional<double>> read = thermometer.temperatureC();
        QVERIFY(read.ok() && read->has_value());
        QVERIFY(std::abs(**read - trueC) <= (isTmp117 ? 0.0039063 : 0.03125));
    }
}

void TestDeviceThermometers::find_otherDevices_isNothing()
{
    const auto bridge = makeBridge("CP2112");
    MemoryModel memory;
    bridge->wires.attach(0x48, memory);
    bridge->wires.attach(0x18, memory);
    const Result<std::optional<I2cThermometer>> found = I2cThermometer::find(*bridge->bus);
    QVERIFY(found.ok());
    QVERIFY(!found->has_value());
    bridge->chip->unplugAfter(3);
    QCOMPARE(I2cThermometer::find(*bridge->bus).error().code, Errc::DeviceUnplugged);
}

void TestDeviceThermometers::tmp117_beforeFirstConversion_hasNoValue()
{
    const auto bridge = makeBridge("FT260");
    Tmp117Model tmp117(bridge->clock);
    bridge->wires.attach(0x48, tmp117);
    Result<I2cThermometer> thermometer = I2cThermometer::open(*bridge->bus, ThermometerModel::Tmp117, 0x48);
    QVERIFY(thermometer.ok());
    QVERIFY(!thermometer->temperatureC()->has_value());
    bridge->clock.waitS(1.0);
    QCOMPARE(thermometer->temperatureC()->value(), 25.0);
}

void TestDeviceThermometers::open_anotherDevice_isWrongSensor()
{
    const auto bridge = makeBridge("CP2112");
    Mcp9808Model mcp9808(bridge->clock);
    bridge->wires.attach(0x48, mcp9808);
    const Result<I2cThermometer> thermometer =
        I2cThermometer::open(*bridge->bus, ThermometerModel::Tmp117, 0x48);
    QVERIFY(!thermometer.ok());
    QCOMPARE(thermometer.error().code, Errc::WrongSensor);
    QVERIFY(thermometer.error().message.find("0x48") != std::string::npos);
}

void TestDeviceThermometers::signCheck_eitherSign_isTold()
{
    struct Case
    {
        double countsPerC;
        double cPerCount;
        const char *told;
    };
    const std::array cases{Case{-1.0, -1.0, "confirms"}, Case{1.0, 1.0, "confirms"},
                           Case{1.0, -1.0, "other sign"}, Case{-1.0, 1.0, "other sign"},
                           Case{0.0, -1.0, "fasten"}};
    for (const Case &one : cases) {
        for (const double stepC : {0.05, -0.05}) {
            DieSignCheck check(one.cPerCount);
            int told = 0;
            for (int i = 0; i < 400; ++i) {
                const double temperatureC = 20.0 + stepC * i;
                const auto verdict = check.add(
                    temperatureC, static_cast<int>(std::floor(7.3 + one.countsPerC * temperatureC)));
                if (!verdict)
                    continue;
                ++told;
                QVERIFY(std::abs(temperatureC - 20.0) >= DieSignCheck::kSpanC - 1e-9);
                QVERIFY2(verdict->find(one.told) != std::string::npos, verdict->c_str());
            }
            QCOMPARE(told, 1);
        }
    }
}

QTEST_APPLESS_MAIN(TestDeviceThermometers)
#include "tst_device_thermometers.moc"
