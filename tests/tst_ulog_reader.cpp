#include "engine/base/axes.h"
#include "engine/base/random.h"
#include "engine/formats/log_reader.h"
#include "support/log_encoders.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestULogReader : public QObject
{
    Q_OBJECT

private slots:
    void list_realLog_namesItsGyros();
    void read_realLog_valuesOfTheBytes();
    void read_severalGyrosNoneChosen_listsThem();
    void read_synthetic_radiansToDps();
    void read_combinedOnly_interpolatesTemperature();
    void read_combinedWithBarometer_takesItsTemperature();
    void read_nestedFormat_isFlattened();
    void read_appendedData_isRead();
    void read_damageInTheMiddle_resynchronises();
    void read_compensatedOnBoard_warns();
    void read_nothingUsable_isAnError_data();
    void read_nothingUsable_isAnError();
    void read_cutAnywhere_keepsWhatIsGood();
    void read_flippedBits_neverFails();
};

static const std::string kGyroFormat =
    "sensor_gyro:uint64_t timestamp;uint32_t device_id;float x;float y;float z;"
    "float temperature;uint8_t[4] _padding0;";

static std::string gyroFields(int i, std::uint32_t deviceId = 77)
{
    const auto step = static_cast<float>(i);
    return bytesOf(std::uint64_t(1000000 + 10000 * i)) + bytesOf(deviceId) + bytesOf(0.25f) + bytesOf(-0.5f) +
           bytesOf(step) + bytesOf(20.0f + step);
}

static std::filesystem::path scratch(const std::string &bytes)
{
    const auto path = scratchFolder() / "log.ulg";
    writeBytes(path, bytes);
    return path;
}

static Result<Recording> readBytesOf(const std::string &bytes, std::optional<int> instance = {})
{
    return readLog(scratch(bytes), {.instance = instance, .csv = {}});
}

static bool warnsOf(const Recording &recording, const std::string &said)
{
    return std::any_of(recording.info.warnings.begin(), recording.info.warnings.end(),
                       [&](const std::string &warning) { return warning.find(said) != std::string::npos; });
}

static ULogEncoder oneGyro(int samples)
{
    ULogEncoder log;
    log.format(kGyroFormat);
    log.subscribe(0, 5, "sensor_gyro");
    for (int i = 0; i < samples; ++i)
        log.data(5, gyroFields(i));
    return log;
}

void TestULogReader::list_realLog_namesItsGyros()
{
    REQUIRE_SHARED_DATA(path, "formats/pyulog_sample_log_small.ulg");
    const auto listed = listInstances(path, {});
    QVERIFY2(listed, listed ? "" : listed.error().message.c_str());
    QCOMPARE(listed->size(), std::size_t{4});
    const std::vector<std::string> serials{"2424842", "3670050", "2621474", "2424842"};
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE((*listed)[i].instance, int(i));
        QCOMPARE((*listed)[i].sensor.serial, serials[i]);
        QVERIFY((*listed)[i].hasTemperature());
    }
    QCOMPARE((*listed)[3].name, std::string("sensor_combined"));
    QVERIFY(std::abs((*listed)[0].meanRateHz() - 1.0) < 0.01);
}

void TestULogReader::read_realLog_valuesOfTheBytes()
{
    REQUIRE_SHARED_DATA(path, "formats/pyulog_sample_log_small.ulg");
    const auto recording = readLog(path, {.instance = 0, .csv = {}});
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    // The first sensor_gyro message of instance 0 stands at byte 183544 (header 3, id 2, then the fields).
    const std::string bytes = readBytes(path);
    const auto floatAt = [&](std::size_t at) {
        float value = 0.0f;
        std::memcpy(&value, bytes.data() + at, sizeof(value));
        return static_cast<double>(value);
    };
    constexpr std::size_t kFields = 183544 + 5;
    QCOMPARE(recording->timeS[0], 21.312030);
    for (int axis = 0; axis < 3; ++axis)
        QCOMPARE(recording->rateDps(0, axis),
                 floatAt(kFields + 20 + 4 * std::size_t(axis)) * kDegreesPerRadian);
    QCOMPARE(recording->temperatureC[0], floatAt(kFields + 32));
    QVERIFY(warnsOf(*recording, "30 ms"));
}

void TestULogReader::read_severalGyrosNoneChosen_listsThem()
{
    REQUIRE_SHARED_DATA(path, "formats/pyulog_sample_log_small.ulg");
    const auto recording = readLog(path, {});
    QCOMPARE(recording.error().code, Errc::NoSuchInstance);
    for (const char *const said : {"--instance", "sensor_gyro 0", "sensor_gyro 2", "sensor_combined"})
        QVERIFY(recording.error().message.find(said) != std::string::npos);
    QCOMPARE(readLog(path, {.instance = 9, .csv = {}}).error().code, Errc::NoSuchInstance);
}

void TestULogReader::read_synthetic_radiansToDps()
{
    const auto recording = readBytesOf(oneGyro(20000).bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 20000);
    QCOMPARE(recording->timeS[7], 1.07);
    QCOMPARE(recording->temperatureC[7], 27.0);
    QVERIFY((recording->rateDps.row(7) - Eigen::RowVector3d(0.25, -0.5, 7.0) * kDegreesPerRadian).norm() <
            1e-12);
    QCOMPARE(recording->info.sensor.serial, std::string("77"));
    QVERIFY(recording->info.warnings.empty());
}

static const std::string kCombinedFormat =
    "sensor_combined:uint64_t timestamp;float[3] gyro_rad;float gyro_integral_dt;";

static std::string combinedFields(std::uint64_t timeUs)
{
    return bytesOf(timeUs) + bytesOf(1.0f) + bytesOf(2.0f) + bytesOf(3.0f) + bytesOf(0.004f);
}

void TestULogReader::read_combinedOnly_interpolatesTemperature()
{
    ULogEncoder log(false);
    log.format(kCombinedFormat);
    log.format("sensor_gyro:uint64_t timestamp;float temperature;");
    log.subscribe(0, 1, "sensor_combined");
    log.subscribe(0, 2, "sensor_gyro");
    for (std::uint64_t i = 0; i <= 40; ++i) {
        log.data(1, combinedFields(1000 * i));
        if (i % 10 == 5)
            log.data(2, bytesOf(std::uint64_t{1000} * i) + bytesOf(static_cast<float>(i)));
    }
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 41);
    for (int i = 0; i <= 40; ++i)
        QVERIFY(std::abs(recording->temperatureC[i] - std::clamp(i, 5, 35)) < 1e-9);
    QVERIFY(warnsOf(*recording, "taken from sensor_gyro 0"));
}

void TestULogReader::read_combinedWithBarometer_takesItsTemperature()
{
    ULogEncoder log(false);
    log.format("sensor_combined:uint64_t timestamp;float[3] gyro_rad;float baro_temp_celcius;");
    log.subscribe(0, 1, "sensor_combined");
    for (std::uint64_t i = 0; i < 5; ++i)
        log.data(1, bytesOf(1000 * i) + bytesOf(1.0f) + bytesOf(2.0f) + bytesOf(3.0f) + bytesOf(31.5f));
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->temperatureC, Eigen::VectorXd::Constant(5, 31.5));
}

void TestULogReader::read_nestedFormat_isFlattened()
{
    ULogEncoder log;
    log.format("pair:uint16_t a;uint16_t b;");
    log.format(
        "sensor_gyro:uint64_t timestamp;pair[3] before;pair one;float x;float y;float z;float temperature;");
    log.subscribe(2, 9, "sensor_gyro");
    log.data(9, bytesOf(std::uint64_t{5000000}) + std::string(16, '\x55') + bytesOf(1.0f) + bytesOf(2.0f) +
                    bytesOf(3.0f) + bytesOf(44.0f));
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->info.instance, 2);
    QCOMPARE(recording->temperatureC[0], 44.0);
}

void TestULogReader::read_appendedData_isRead()
{
    const std::string whole = oneGyro(50).bytes();
    const std::string cut = whole.substr(0, whole.size() - 7);
    // The header is as long whether or not something is appended.
    ULogEncoder log(true, cut.size());
    log.raw(cut.substr(ULogEncoder().bytes().size()));
    for (int i = 50; i < 60; ++i)
        log.data(5, gyroFields(i));
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 59);
    QCOMPARE(recording->temperatureC[49], 70.0);
    QVERIFY(recording->info.warnings.empty());
}

void TestULogReader::read_damageInTheMiddle_resynchronises()
{
    ULogEncoder log = oneGyro(50);
    const std::size_t byte = log.bytes().size();
    log.raw(std::string(999, '\xEE'));
    for (int i = 50; i < 100; ++i)
        log.data(5, gyroFields(i));
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 100);
    QVERIFY(warnsOf(*recording, "damaged at byte " + std::to_string(byte) + ": 999 bytes"));
}

void TestULogReader::read_compensatedOnBoard_warns()
{
    ULogEncoder log(false);
    log.parameter("TC_G_ENABLE", 1);
    log.format("sensor_combined:uint64_t timestamp;float[3] gyro_rad;float baro_temp_celcius;");
    log.subscribe(0, 1, "sensor_combined");
    log.data(1, bytesOf(std::uint64_t{1}) + bytesOf(1.0f) + bytesOf(2.0f) + bytesOf(3.0f) + bytesOf(31.5f));
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QVERIFY(warnsOf(*recording, "TC_G_ENABLE"));
}

void TestULogReader::read_nothingUsable_isAnError_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("code");
    const auto row = [](const char *name, const std::string &bytes, Errc code) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << int(code);
    };
    ULogEncoder newer(false);
    newer.message('B', std::string(8, '\0') + '\x02' + std::string(31, '\0'));
    row("unknown features", newer.bytes(), Errc::UnknownFormat);
    row("no gyro", ULogEncoder().bytes(), Errc::MissingColumn);
    row("only damage", ULogEncoder(false).bytes() + std::string(500, '\xEE'), Errc::DamagedLog);
    row("only the magic", "ULog\x01\x12\x35", Errc::UnknownFormat);
    ULogEncoder cold(false);
    cold.format("sensor_gyro:uint64_t timestamp;float x;float y;float z;");
    cold.subscribe(0, 1, "sensor_gyro");
    cold.data(1, bytesOf(std::uint64_t{1}) + bytesOf(1.0f) + bytesOf(2.0f) + bytesOf(3.0f));
    row("no temperature", cold.bytes(), Errc::MissingColumn);
    ULogEncoder endless(false);
    endless.format("a:a nested;");
    endless.format("sensor_gyro:uint64_t timestamp;a nested;float x;float y;float z;float temperature;");
    endless.subscribe(0, 1, "sensor_gyro");
    endless.data(1, std::string(30, '\0'));
    row("format that nests itself", endless.bytes(), Errc::MissingColumn);
}

void TestULogReader::read_nothingUsable_isAnError()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, code);
    const auto recording = readBytesOf(bytes.toStdString());
    QVERIFY(!recording);
    QVERIFY2(int(recording.error().code) == code, recording.error().message.c_str());
}

void TestULogReader::read_cutAnywhere_keepsWhatIsGood()
{
    const std::string whole = oneGyro(60).bytes();
    constexpr std::size_t kMessage = 3 + 2 + 28; // without the padding at its end
    const std::size_t first = whole.size() - 60 * kMessage;
    for (std::size_t bytes = 1; bytes < whole.size(); bytes += 7) {
        const auto recording = readBytesOf(whole.substr(0, bytes));
        const std::size_t good = bytes < first ? 0 : (bytes - first) / kMessage;
        QCOMPARE(recording.ok(), good > 0);
        if (!recording)
            continue;
        QCOMPARE(recording->size(), Eigen::Index(good));
        const std::size_t byte = first + good * kMessage;
        QCOMPARE(warnsOf(*recording, "from byte " + std::to_string(byte) + " on"), byte != bytes);
    }
}

void TestULogReader::read_flippedBits_neverFails()
{
    constexpr std::uint64_t kSeed = 20261123;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    REQUIRE_SHARED_DATA(path, "formats/pyulog_sample_log_small.ulg");
    const std::string synthetic = oneGyro(60).bytes();
    const std::string real = readBytes(path);
    for (int i = 0; i < 165; ++i) {
        std::string bytes = i < 150 ? synthetic : real.substr(0, 20000 + random.below(real.size() - 20000));
        for (auto flips = 1 + random.below(i < 150 ? 8 : 200); flips > 0; --flips)
            bytes[8 + random.below(bytes.size() - 8)] ^= static_cast<char>(1 << random.below(8));
        const auto recording = readBytesOf(bytes, i < 150 ? 0 : int(random.below(4)));
        QVERIFY(recording ? recording->size() > 0 : recording.error().message.ends_with('.'));
    }
}

QTEST_APPLESS_MAIN(TestULogReader)
#include "tst_ulog_reader.moc"
