// Every kind of source is opened by one function: the simulated bridge, native bridges by serial number (also
// after they were unplugged), each I2C chip with each gyro as its register-level model, and logs.
#include "device/bridge/bridge_source.h"
#include "device/open_source.h"
#include "engine/formats/csv_writer.h"
#include "support/bridges.h"
#include "support/collecting_sink.h"
#include "support/gyro_model.h"
#include "support/made_up_devices.h"
#include "support/simulated_device.h"
#include "support/test_data.h"
#include "support/thermometer_models.h"

#include <QTest>

#include <cmath>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceOpenSource : public QObject
{
    Q_OBJECT

private slots:
    void simulated_options_areThoseOfTheRun();
    void simulated_runs_differButShareTheCurve();
    void simulated_usualRate_isThePresets();
    void native_bySerial_isTheRightOne();
    void native_severalOrNone_isSaid();
    void native_otherUsbIds_areFound();
    void native_unplugged_goesOnWithTheSameSerial();
    void bridge_client_isThatOfTheSource();
    void i2c_everyChipAndGyro_records_data();
    void i2c_everyChipAndGyro_records();
    void i2c_namedThermometer_mustAnswer();
    void i2c_wrongGyroOrNone_isNamed();
    void i2c_ft260_takesTheI2cInterface();
    void i2c_stuckBus_isSaid();
    void file_isPlayedBack();
    void options_thatASourceLacks_areRefused();
};

namespace {

Errc codeOf(const SourceChoice &choice, const HidAccess &access)
{
    const auto opened = openSource(choice, access);
    return opened ? Errc::Cancelled : opened.error().code;
}

SourceChoice parsed(const std::string &text)
{
    return *parseSourceChoice(text);
}

TemperatureProfile shortProfile(double durationS)
{
    return *TemperatureProfile::build("test", 20.0, {HoldSegment{durationS}});
}

SourceChoice quickSimulated(double durationS, int run = 0)
{
    SimulatedChoice simulated;
    simulated.profile = shortProfile(durationS);
    simulated.speed = 0.0;
    simulated.run = run;
    return {simulated};
}

std::shared_ptr<SimulatedBoard> boardNamed(const std::string &serial, double durationS)
{
    SimulatedBoardOptions options = quickBoard(durationS);
    options.simulation.sensor.serial = serial;
    return *SimulatedBoard::create(options);
}

HidIdentity at(std::uint16_t vendorId, std::uint16_t productId, const std::string &serial,
               const std::string &path, int interfaceNumber = -1)
{
    return {vendorId, productId, "", "", serial, path, interfaceNumber};
}

// Wires with a gyro on them, and the chip's model whenever it is opened.
struct I2cBench
{
    I2cBench(const std::string &chipName, const std::string &gyroModel)
        : name(chipName), gyro(gyroModel, bridge.clock), tmp117(bridge.clock), mcp9808(bridge.clock)
    {
        bridge.wires.attach(gyroModel == "L3GD20H" ? 0x6B : 0x68, gyro);
        const I2cChipDescription &chip = describe(*i2cChipNamed(chipName));
        devices.plugIn(at(chip.vendorId, chip.productId, "00A1", "made-up:0"),
                       [this]() -> Result<std::unique_ptr<HidTransport>> { return makeChip(name, bridge); });
    }
    std::string text(const std::string &rest) const { return "i2c:" + name + "/" + rest; }
    HidAccess access() { return devices.access(&bridge.clock); }

    std::string name;
    Bridge bridge;
    GyroModel gyro;
    Tmp117Model tmp117;
    Mcp9808Model mcp9808;
    MadeUpDevices devices;
};

} // namespace

void TestDeviceOpenSource::simulated_options_areThoseOfTheRun()
{
    SourceChoice choice = quickSimulated(10.0);
    SimulatedChoice &simulated = *choice.as<SimulatedChoice>();
    simulated.sensor = "L3GD20H";
    simulated.serial = "S-9";
    simulated.noiseDps = 0.0;
    simulated.spread = 0.0;
    simulated.referenceRateDps = {1.0, 2.0, 3.0};
    choice.rateHz = 50.0;
    choice.rangeDps = 490.0;
    const auto opened = openSource(choice);
    QVERIFY(opened.ok());
    QCOMPARE(opened->source->info().sensor.model, std::string("L3GD20H"));
    QCOMPARE(opened->source->info().sensor.serial, std::string("S-9"));
    QCOMPARE(opened->source->info().sampleRateHz, 50.0);
    QCOMPARE(opened->source->info().rangeDps, 490.0);
    QVERIFY(opened->source->info().simulated && !opened->isRealTime && opened->board != nullptr);
    CollectingSink sink;
    QCOMPARE(opened->source->run(sink, {})->samples, 500);
    // At 20 degrees the drift is the same all the time; the reference rates lie 1 dps apart.
    QVERIFY(std::abs(sink.rows[400].temperatureC - 20.0) < 0.1);
    QVERIFY(std::abs(sink.rows[0].rateDps[0] - sink.rows[499].rateDps[0]) < 0.1);
}

void TestDeviceOpenSource::simulated_runs_differButShareTheCurve()
{
    const auto meanOf = [](int run, std::vector<double> *rates) {
        const auto opened = openSource(quickSimulated(60.0, run));
        CollectingSink sink;
        opened->source->run(sink, {}).ok();
        double sum = 0.0;
        for (const auto &row : sink.rows) {
            rates->push_back(row.rateDps[0]);
            sum += row.rateDps[0];
        }
        return sum / static_cast<double>(sink.rows.size());
    };
    std::vector<double> first, second, again;
    const double firstMean = meanOf(0, &first);
    const double secondMean = meanOf(1, &second);
    meanOf(0, &again);
    QVERIFY(first == again);
    QVERIFY(first != second);
    QVERIFY(std::abs(firstMean - secondMean) < 0.1);
    SourceChoice below = quickSimulated(1.0, -1);
    QCOMPARE(codeOf(below, {}), Errc::InvalidOption);
}

void TestDeviceOpenSource::simulated_usualRate_isThePresets()
{
    QCOMPARE(openSource(parsed("simulated"))->source->info().sampleRateHz, 10.0);
}

void TestDeviceOpenSource::native_bySerial_isTheRightOne()
{
    MadeUpDevices devices;
    const auto one = boardNamed("A-1", 1.0);
    const auto two = boardNamed("A-2", 1.0);
    devices.plugIn(at(0x1209, 1, "A-1", "p1"), [&] { return SimulatedBridge::open(one); });
    devices.plugIn(at(0x1209, 1, "A-2", "p2"), [&] { return SimulatedBridge::open(two); });
    const HidAccess access = devices.access(&two->clock());
    QCOMPARE(openSource(parsed("hid:A-2"), access)->source->info().sensor.serial, std::string("A-2"));
    QCOMPARE(openSource(parsed("hid:p2"), access)->identity.serial, std::string("A-2"));
    const auto several = openSource(parsed("hid"), access);
    QCOMPARE(several.error().code, Errc::InvalidOption);
    QVERIFY(several.error().message.find("A-1, A-2") != std::string::npos);
    QVERIFY(several.error().message.find("hid:A-1") != std::string::npos);
    QCOMPARE(codeOf(parsed("hid:A-3"), access), Errc::DeviceNotFound);
    QVERIFY(openSource(parsed("hid:A-1"), access)->isRealTime);
}

void TestDeviceOpenSource::native_severalOrNone_isSaid()
{
    MadeUpDevices devices;
    const auto none = openSource(parsed("hid"), devices.access());
    QCOMPARE(none.error().code, Errc::DeviceNotFound);
    QVERIFY(none.error().message.find("simulated") != std::string::npos);
    const auto board = boardNamed("", 1.0);
    // Serial numbers that are the same, or missing: the paths tell them apart.
    for (const char *path : {"p1", "p2"})
        devices.plugIn(at(0x1209, 1, "", path), [&] { return SimulatedBridge::open(board); });
    QVERIFY(openSource(parsed("hid"), devices.access()).error().message.find("hid:p1") != std::string::npos);
    QVERIFY(openSource(parsed("hid:p2"), devices.access(&board->clock())).ok());
}

void TestDeviceOpenSource::native_otherUsbIds_areFound()
{
    MadeUpDevices devices;
    const auto board = boardNamed("B-1", 1.0);
    devices.plugIn(at(0xCAFE, 0x4001, "B-1", "p1"), [&] { return SimulatedBridge::open(board); });
    const HidAccess access = devices.access(&board->clock());
    QCOMPARE(codeOf(parsed("hid"), access), Errc::DeviceNotFound);
    SourceChoice choice = parsed("hid");
    choice.as<NativeChoice>()->ids = {{0x1209, 1}, {0xCAFE, 0x4001}};
    QVERIFY(openSource(choice, access).ok());
}

void TestDeviceOpenSource::native_unplugged_goesOnWithTheSameSerial()
{
    MadeUpDevices devices;
    const auto right = boardNamed("A-1", 20.0);
    const auto wrong = boardNamed("A-2", 20.0);
    devices.plugIn(at(0x1209, 1, "A-1", "p1"), [&] { return SimulatedBridge::open(right); });
    SourceChoice choice = parsed("hid:p1"); // the path will be another one
    choice.rateHz = 100.0;
    const auto opened = openSource(choice, devices.access(&right->clock()));
    QVERIFY(opened.ok());
    CollectingSink sink;
    bool away = false;
    sink.onSamples = [&] {
        if (away || sink.rows.size() < 500)
            return;
        away = true;
        right->unplug();
        devices.unplug("p1");
        devices.plugIn(at(0x1209, 1, "A-2", "p1"), [&] { return SimulatedBridge::open(wrong); });
        right->plugIn(3.0);
        devices.plugIn(at(0x1209, 1, "A-1", "p3"), [&] { return SimulatedBridge::open(right); });
    };
    const auto stats = opened->source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(sink.gaps.size(), std::size_t(1));
    QCOMPARE(sink.gaps[0].cause, GapCause::Unplugged);
    QVERIFY(sink.gaps[0].endS - sink.gaps[0].startS > 2.9);
    QVERIFY(sink.rows.size() > 1500 && sink.consistent && sink.timesRise());
    QVERIFY(sink.hasEvent("is back"));
}

void TestDeviceOpenSource::bridge_client_isThatOfTheSource()
{
    const auto opened = openSource(quickSimulated(1.0));
    QVERIFY(opened->bridge != nullptr);
    QCOMPARE(opened->bridge->info().sensor.model, std::string("I3G4250D"));
    QVERIFY(opened->bridge->status().ok());
    const auto bridge = openBridge(parsed("simulated:L3GD20H"));
    QCOMPARE(bridge->client->info().sensor.model, std::string("L3GD20H"));
    QCOMPARE(openBridge(parsed("file:x")).error().code, Errc::InvalidOption);
    QCOMPARE(openBridge(parsed("i2c:cp2112/auto")).error().code, Errc::InvalidOption);
}

void TestDeviceOpenSource::i2c_everyChipAndGyro_records_data()
{
    QTest::addColumn<QString>("chip");
    QTest::addColumn<QString>("gyro");
    for (const char *chip : kBridgeNames) {
        for (const char *gyro : {"L3GD20H", "I3G4250D"})
            QTest::addRow("%s %s", chip, gyro) << QString(chip) << QString(gyro);
    }
}

void TestDeviceOpenSource::i2c_everyChipAndGyro_records()
{
    QFETCH(QString, chip);
    QFETCH(QString, gyro);
    I2cBench bench(chip.toStdString(), gyro.toStdString());
    bench.tmp117.temperatureC = [](double) { return 31.25; };
    bench.bridge.wires.attach(0x49, bench.tmp117);
    SourceChoice choice = parsed(bench.text(gyro.toLower().toStdString() + "+tmp117"));
    choice.rateHz = 200.0;
    choice.as<I2cChoice>()->gyroSerial = "board 3";
    const auto opened = openSource(choice, bench.access());
    QVERIFY2(opened.ok(), opened ? "" : opened.error().message.c_str());
    QCOMPARE(opened->source->info().sensor.text(), gyro.toStdString() + " board 3");
    QVERIFY(opened->isRealTime && opened->bridge == nullptr);
    CollectingSink sink;
    sink.stopAfter = 2000;
    const auto stats = opened->source->run(sink, {});
    QVERIFY(stats.ok());
    QCOMPARE(stats->lostSamples, 0);
    QVERIFY(sink.consistent && sink.timesRise());
    QCOMPARE(sink.rows.back().temperatureC, 31.25);
    QVERIFY(sink.hasEvent("TMP117"));
    // Whichever answers is the same one.
    QCOMPARE(openSource(parsed(bench.text("auto")), bench.access())->source->info().sensor.model,
             gyro.toStdString());
}

void TestDeviceOpenSource::i2c_namedThermometer_mustAnswer()
{
    I2cBench bench("CP2112", "L3GD20H");
    QVERIFY(openSource(parsed(bench.text("auto")), bench.access()).ok());
    for (const char *thermometer : {"+tmp117", "+any", "+tmp117@48", "+mcp9808"})
        QCOMPARE(codeOf(parsed(bench.text("auto") + thermometer), bench.access()), Errc::BusNoAcknowledge);
    bench.bridge.wires.attach(0x18, bench.mcp9808);
    QVERIFY(openSource(parsed(bench.text("auto+mcp9808")), bench.access()).ok());
    QVERIFY(openSource(parsed(bench.text("auto+any")), bench.access()).ok());
    QCOMPARE(codeOf(parsed(bench.text("auto+tmp117")), bench.access()), Errc::BusNoAcknowledge);
    QCOMPARE(codeOf(parsed(bench.text("auto+tmp117@18")), bench.access()), Errc::WrongSensor);
    const auto die = openSource(parsed(bench.text("auto+die")), bench.access());
    CollectingSink sink;
    sink.stopAfter = 10;
    QVERIFY(die->source->run(sink, {}).ok());
    QVERIFY(sink.hasEvent("relative"));
}

void TestDeviceOpenSource::i2c_wrongGyroOrNone_isNamed()
{
    I2cBench bench("FT260", "I3G4250D");
    const auto wrong = openSource(parsed(bench.text("l3gd20h@68")), bench.access());
    QCOMPARE(wrong.error().code, Errc::WrongSensor);
    QVERIFY(wrong.error().message.find("I3G4250D") != std::string::npos);
    bench.bridge.wires.detach(0x68);
    QCOMPARE(codeOf(parsed(bench.text("auto")), bench.access()), Errc::BusNoAcknowledge);
    QCOMPARE(codeOf(parsed("i2c:mcp2221a/auto"), bench.access()), Errc::DeviceNotFound);
}

void TestDeviceOpenSource::i2c_ft260_takesTheI2cInterface()
{
    I2cBench bench("FT260", "L3GD20H");
    bench.devices.unplug("made-up:0");
    const auto wrongOne = []() -> Result<std::unique_ptr<HidTransport>> {
        return Error{Errc::DeviceRefused, "This is the UART."};
    };
    bench.devices.plugIn(at(0x0403, 0x6030, "FT1", "uart", 1), wrongOne);
    bench.devices.plugIn(at(0x0403, 0x6030, "FT1", "i2c", 0), [&]() -> Result<std::unique_ptr<HidTransport>> {
        return makeChip("FT260", bench.bridge);
    });
    const auto opened = openSource(parsed("i2c:ft260/auto"), bench.access());
    QVERIFY(opened.ok());
    QCOMPARE(opened->identity.path, std::string("i2c"));
}

void TestDeviceOpenSource::i2c_stuckBus_isSaid()
{
    for (const char *chip : kBridgeNames) {
        I2cBench bench(chip, "L3GD20H");
        bench.bridge.wires.holdLow(1000000);
        QCOMPARE(codeOf(parsed(bench.text("auto")), bench.access()), Errc::BusStuck);
    }
}

void TestDeviceOpenSource::file_isPlayedBack()
{
    const auto path = scratchFolder() / "played.csv";
    Recording recording;
    recording.timeS = Eigen::VectorXd::LinSpaced(100, 5.0, 14.9);
    recording.temperatureC = Eigen::VectorXd::LinSpaced(100, 20.0, 25.0);
    recording.rateDps = Eigen::MatrixX3d::Random(100, 3);
    QVERIFY(writeCsv(path, recording).ok());
    const auto opened = openSource(parsed("file:" + path.string() + "*0"));
    QVERIFY(opened.ok() && !opened->isRealTime && opened->bridge == nullptr);
    CollectingSink sink;
    QVERIFY(opened->source->run(sink, {}).ok());
    QCOMPARE(sink.rows.size(), std::size_t(100));
    QCOMPARE(sink.rows[7].rateDps[2], recording.rateDps(7, 2));
    QCOMPARE(codeOf(parsed("file:/no/such.csv"), {}), Errc::FileNotFound);
}

void TestDeviceOpenSource::options_thatASourceLacks_areRefused()
{
    SourceChoice file = parsed("file:/no/such.csv");
    file.rateHz = 10.0;
    QCOMPARE(codeOf(file, {}), Errc::InvalidOption);
    I2cBench bench("CP2112", "L3GD20H");
    SourceChoice i2c = parsed(bench.text("auto"));
    i2c.compensate = true;
    QCOMPARE(codeOf(i2c, bench.access()), Errc::InvalidOption);
    SourceChoice simulated = quickSimulated(1.0);
    simulated.rateHz = std::nan("");
    QCOMPARE(codeOf(simulated, {}), Errc::InvalidOption);
    simulated.rateHz = 20000.0;
    QCOMPARE(codeOf(simulated, {}), Errc::InvalidOption);
    simulated.rateHz = 0.0;
    simulated.as<SimulatedChoice>()->externalThermometer = false;
    simulated.thermometer = ThermometerChoice::External;
    QCOMPARE(codeOf(simulated, {}), Errc::InvalidOption);
    QCOMPARE(codeOf(parsed("simulated:X1"), {}), Errc::InvalidOption);
}

QTEST_APPLESS_MAIN(TestDeviceOpenSource)
#include "tst_device_open_source.moc"
