// Sources as one line of text: what may be said is understood, what may not is refused with a sentence, and
// every value that text can say comes back from its own text.
#include "device/source_choice.h"
#include "engine/base/random.h"

#include <QTest>

using namespace driftbench;

class TestDeviceSourceChoice : public QObject
{
    Q_OBJECT

private slots:
    void parse_everyKind_isThatKind();
    void parse_i2c_allParts();
    void parse_i2c_serialMayBeAPath();
    void parse_file_speedBehindTheLastStar();
    void parse_badText_isRefused_data();
    void parse_badText_isRefused();
    void text_everyChoice_comesBack();
    void parse_randomText_neverCrashes();
    void usbId_hexPairs();
};

namespace {

SourceChoice parsed(std::string_view text)
{
    const auto choice = parseSourceChoice(text);
    if (!choice)
        qFatal("%s", choice.error().message.c_str());
    return *choice;
}

I2cChoice i2c(std::string_view text)
{
    return *parsed(text).as<I2cChoice>();
}

} // namespace

void TestDeviceSourceChoice::parse_everyKind_isThatKind()
{
    QCOMPARE(parsed("simulated").as<SimulatedChoice>()->sensor, std::string("I3G4250D"));
    const SourceChoice simulated = parsed("Simulated:L3GD20H:SIM-0007");
    QCOMPARE(simulated.as<SimulatedChoice>()->sensor, std::string("L3GD20H"));
    QCOMPARE(simulated.as<SimulatedChoice>()->serial, std::string("SIM-0007"));
    QCOMPARE(parsed("hid").as<NativeChoice>()->serial, std::string());
    QCOMPARE(parsed("hid:AB:cd").as<NativeChoice>()->serial, std::string("AB:cd"));
    QCOMPARE(parsed("HID:/dev/hidraw3").as<NativeChoice>()->serial, std::string("/dev/hidraw3"));
    QVERIFY(parsed("i2c:cp2112/auto").as<I2cChoice>() != nullptr);
    QVERIFY(parsed("file:a.csv").as<FileChoice>() != nullptr);
    QCOMPARE(parsed("hid").thermometer, ThermometerChoice::Automatic);
}

void TestDeviceSourceChoice::parse_i2c_allParts()
{
    const SourceChoice choice = parsed("i2c:MCP2221A:0002137645/L3GD20H@6a+TMP117@0x49");
    const I2cChoice &parts = *choice.as<I2cChoice>();
    QCOMPARE(parts.chip, I2cChip::Mcp2221a);
    QCOMPARE(parts.serial, std::string("0002137645"));
    QCOMPARE(parts.gyro, std::string("L3GD20H"));
    QCOMPARE(parts.gyroAddress, std::uint8_t(0x6A));
    QVERIFY(parts.thermometer == ThermometerModel::Tmp117);
    QCOMPARE(parts.thermometerAddress, std::uint8_t(0x49));
    QCOMPARE(choice.thermometer, ThermometerChoice::External);
    QCOMPARE(parsed("i2c:ft260/i3g4250d+die").thermometer, ThermometerChoice::Die);
    QCOMPARE(parsed("i2c:ft260/i3g4250d").thermometer, ThermometerChoice::Automatic);
    QCOMPARE(parsed("i2c:ft260/auto+any").thermometer, ThermometerChoice::External);
    QVERIFY(i2c("i2c:ft260/auto").gyro.empty());
    QVERIFY(i2c("i2c:cp2112/auto+mcp9808").thermometer == ThermometerModel::Mcp9808);
}

void TestDeviceSourceChoice::parse_i2c_serialMayBeAPath()
{
    const I2cChoice parts = i2c("i2c:ft260:/dev/hidraw12/i3g4250d@68");
    QCOMPARE(parts.serial, std::string("/dev/hidraw12"));
    QCOMPARE(parts.gyroAddress, std::uint8_t(0x68));
}

void TestDeviceSourceChoice::parse_file_speedBehindTheLastStar()
{
    const auto file = [](std::string_view text) { return *parsed(text).as<FileChoice>(); };
    QCOMPARE(file("file:/a/b.csv").speed, 1.0);
    QCOMPARE(file("file:/a/b.csv*0").speed, 0.0);
    QCOMPARE(file("file:b.csv*2.5").speed, 2.5);
    QCOMPARE(file("file:b.csv*2.5").path.string(), std::string("b.csv"));
    QCOMPARE(file("file:a*b.csv").path.string(), std::string("a*b.csv"));
    QCOMPARE(file("file:C:x*3*1").path.string(), std::string("C:x*3"));
}

void TestDeviceSourceChoice::parse_badText_isRefused_data()
{
    QTest::addColumn<QString>("part"); // of the sentence
    for (const auto &[text, part] : {std::pair{"", "is no source"},
                                     {"toaster", "say simulated"},
                                     {"run1.csv", "file:PATH"},
                                     {"i2c", "names no gyro"},
                                     {"i2c:mcp2221a", "names no gyro"},
                                     {"i2c:mcp2221a/", "names no gyro"},
                                     {"i2c:ch341/l3gd20h", "no bridge \"ch341\""},
                                     {"i2c:cp2112/mpu6050", "no gyro \"mpu6050\""},
                                     {"i2c:cp2112/l3gd20h@80", "no I2C address"},
                                     {"i2c:cp2112/l3gd20h@", "no I2C address"},
                                     {"i2c:cp2112/l3gd20h@6bx", "no I2C address"},
                                     {"i2c:cp2112/l3gd20h+lm75", "no thermometer \"lm75\""},
                                     {"i2c:cp2112/l3gd20h+die@48", "needs a thermometer"},
                                     {"file:", "names no log"},
                                     {"file:*3", "names no log"},
                                     {"file:a.csv*-1", "can't be played back"},
                                     {"file:a.csv*nan", "can't be played back"},
                                     {"file:a.csv*inf", "can't be played back"}})
        QTest::newRow(text) << QString(part);
}

void TestDeviceSourceChoice::parse_badText_isRefused()
{
    QFETCH(QString, part);
    const auto choice = parseSourceChoice(QTest::currentDataTag());
    QVERIFY(!choice.ok());
    QCOMPARE(choice.error().code, Errc::InvalidOption);
    const QString sentence = QString::fromStdString(choice.error().message);
    QVERIFY2(sentence.contains(part) && sentence.endsWith('.'), qPrintable(sentence));
}

void TestDeviceSourceChoice::text_everyChoice_comesBack()
{
    for (const char *text :
         {"simulated:L3GD20H:S1", "hid", "hid:X-1", "hid:/dev/hidraw0", "i2c:cp2112/auto",
          "i2c:mcp2221a:99/l3gd20h@0x6b+tmp117@0x48", "i2c:ft260:/dev/hidraw1/i3g4250d+die",
          "i2c:ft260/auto+any", "i2c:ft260/auto+mcp9808", "file:/tmp/a b.csv", "file:a.csv*0",
          "file:a*2.csv*1", "file:a*2*1"})
        QCOMPARE(sourceChoiceText(parsed(text)), std::string(text));
}

void TestDeviceSourceChoice::parse_randomText_neverCrashes()
{
    constexpr std::uint64_t kSeed = 20;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    constexpr std::string_view kPieces[] = {
        "i2c", ":",   "/",         "@",  "+",   "*",       "file", "hid", "cp2112", "auto", "6b",
        "0x",  "die", "simulated", "-1", "nan", "l3gd20h", "any",  "1e9", "\xff",   "",     "tmp117"};
    Random random(kSeed);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string text;
        for (std::uint64_t i = random.below(9); i > 0; --i)
            text += kPieces[random.below(std::size(kPieces))];
        const auto choice = parseSourceChoice(text);
        if (!choice)
            continue;
        const std::string again = sourceChoiceText(*choice);
        QCOMPARE(sourceChoiceText(parsed(again)), again);
    }
}

void TestDeviceSourceChoice::usbId_hexPairs()
{
    QVERIFY((*parseUsbId("1209:0001") == UsbId{0x1209, 1}));
    QCOMPARE(usbIdText({0x04D8, 0xDD}), std::string("04d8:00dd"));
    for (const char *text : {"", "1209", "1209:", ":1", "12090:1", "1209:g", "1209:0001:2", "-1:2"})
        QCOMPARE(parseUsbId(text).ok(), false);
}

QTEST_APPLESS_MAIN(TestDeviceSourceChoice)
#include "tst_device_source_choice.moc"
