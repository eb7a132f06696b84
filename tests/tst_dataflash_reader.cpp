#include "engine/base/axes.h"
#include "engine/base/random.h"
#include "engine/formats/log_reader.h"
#include "support/log_encoders.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDataFlashReader : public QObject
{
    Q_OBJECT

private slots:
    void read_warmUpLog_equalsPublishedConversion();
    void list_realLog_hasDeviceIds();
    void read_severalGyrosNoneChosen_listsThem();
    void read_spellingsOfFields_give_data();
    void read_spellingsOfFields_give();
    void read_instanceField_separatesGyros();
    void read_parameters_nameTheSensor();
    void read_damageInTheMiddle_resynchronises();
    void read_nothingUsable_isAnError_data();
    void read_nothingUsable_isAnError();
    void read_cutAnywhere_keepsWhatIsGood();
    void read_flippedBits_neverFails();
};

static std::filesystem::path scratch(const std::string &bytes)
{
    const auto path = scratchFolder() / "log.bin";
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

static std::string rates(int i)
{
    return bytesOf(0.25f) + bytesOf(-0.5f) + bytesOf(static_cast<float>(i));
}

static constexpr std::size_t kImuMessage = 3 + 8 + 12 + 4;

static DataFlashEncoder oneGyro(int samples)
{
    DataFlashEncoder log;
    log.format(140, "IMU", kImuMessage - 3, "Qffff", "TimeUS,GyrX,GyrY,GyrZ,T");
    for (int i = 0; i < samples; ++i)
        log.message(140,
                    bytesOf(std::uint64_t(20000 * i)) + rates(i) + bytesOf(20.0f + static_cast<float>(i)));
    return log;
}

void TestDataFlashReader::read_warmUpLog_equalsPublishedConversion()
{
    REQUIRE_SHARED_DATA(path, "dataflash_warmup/log171.bin");
    const auto log = readLog(path, {.instance = 2, .csv = {}});
    const auto stretch = readLog(path.parent_path() / "log171_IMU3_stationary_17s6-59s.csv", {});
    QVERIFY2(log, log ? "" : log.error().message.c_str());
    QVERIFY2(stretch, stretch ? "" : stretch.error().message.c_str());
    // The published stretch counts time from the log's first sample.
    const Eigen::VectorXd sinceStartS = log->timeS.array() - log->timeS[0];
    const auto first = std::lower_bound(sinceStartS.begin(), sinceStartS.end(), stretch->timeS[0] - 1e-6) -
                       sinceStartS.begin();
    QCOMPARE(stretch->size(), 2047);
    QVERIFY(first + stretch->size() <= log->size());
    QVERIFY((sinceStartS.segment(first, stretch->size()) - stretch->timeS).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY(
        (log->temperatureC.segment(first, stretch->size()) - stretch->temperatureC).cwiseAbs().maxCoeff() <
        1e-5);
    QVERIFY((log->rateDps.middleRows(first, stretch->size()) - stretch->rateDps).cwiseAbs().maxCoeff() <
            1e-7);
    QVERIFY(log->info.warnings.empty());
}

void TestDataFlashReader::list_realLog_hasDeviceIds()
{
    REQUIRE_SHARED_DATA(path, "formats/pymavlink_test.BIN");
    const auto listed = listInstances(path, {});
    QVERIFY2(listed, listed ? "" : listed.error().message.c_str());
    QCOMPARE(listed->size(), std::size_t{2});
    // The log's parameters, 4-byte floats: INS_GYR_ID 28 18 04 4A and INS_GYR2_ID 28 10 10 4A.
    QCOMPARE((*listed)[0].sensor.serial, std::string("2164234"));
    QCOMPARE((*listed)[1].sensor.serial, std::string("2360330"));
    QCOMPARE((*listed)[1].name, std::string("IMU2"));
    const auto recording = readLog(path, {.instance = 1, .csv = {}});
    QVERIFY(recording && warnsOf(*recording, "is cut or damaged from byte"));
}

void TestDataFlashReader::read_severalGyrosNoneChosen_listsThem()
{
    REQUIRE_SHARED_DATA(path, "dataflash_warmup/log171.bin");
    const auto recording = readLog(path, {});
    QCOMPARE(recording.error().code, Errc::NoSuchInstance);
    for (const char *const said : {"--instance", "(IMU)", "(IMU3)", "11916 samples"})
        QVERIFY(recording.error().message.find(said) != std::string::npos);
}

void TestDataFlashReader::read_spellingsOfFields_give_data()
{
    QTest::addColumn<QString>("letters");
    QTest::addColumn<QString>("labels");
    QTest::addColumn<QByteArray>("payload");
    const auto row = [](const char *letters, const char *labels, const std::string &payload) {
        QTest::newRow(labels) << letters << labels << QByteArray::fromStdString(payload);
    };
    row("Qffff", "TimeUS,GyrX,GyrY,GyrZ,T", bytesOf(std::uint64_t{2500000}) + rates(3) + bytesOf(21.5f));
    row("Iffff", "TimeMS,GyrX,GyrY,GyrZ,Temp", bytesOf(std::uint32_t{2500}) + rates(3) + bytesOf(21.5f));
    row("Qfffc", "TimeUS,GyrX,GyrY,GyrZ,T",
        bytesOf(std::uint64_t{2500000}) + rates(3) + bytesOf(std::int16_t{2150}));
    row("QZbdfffe", "TimeUS,A,B,C,GyrX,GyrY,GyrZ,T",
        bytesOf(std::uint64_t{2500000}) + std::string(64 + 1 + 8, 'x') + rates(3) +
            bytesOf(std::int32_t{2150}));
}

void TestDataFlashReader::read_spellingsOfFields_give()
{
    QFETCH(QString, letters);
    QFETCH(QString, labels);
    QFETCH(QByteArray, payload);
    DataFlashEncoder log;
    log.format(140, "IMU", std::size_t(payload.size()), letters.toStdString(), labels.toStdString());
    log.message(140, payload.toStdString());
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->timeS[0], 2.5);
    QCOMPARE(recording->temperatureC[0], 21.5);
    QVERIFY((recording->rateDps.row(0) - Eigen::RowVector3d(0.25, -0.5, 3.0) * kDegreesPerRadian).norm() <
            1e-12);
}

void TestDataFlashReader::read_instanceField_separatesGyros()
{
    DataFlashEncoder log;
    log.format(140, "IMU", 25, "QBffff", "TimeUS,I,GyrX,GyrY,GyrZ,T");
    for (int i = 0; i < 30; ++i)
        log.message(140, bytesOf(std::uint64_t(1000 * i)) + static_cast<char>(i % 3) + rates(i % 3) +
                             bytesOf(20.0f + static_cast<float>(i % 3)));
    const auto path = scratch(log.bytes());
    QCOMPARE(listInstances(path, {})->size(), std::size_t{3});
    for (int instance = 0; instance < 3; ++instance) {
        const auto recording = readLog(path, {.instance = instance, .csv = {}});
        QVERIFY(recording);
        QCOMPARE(recording->temperatureC, Eigen::VectorXd::Constant(10, 20.0 + instance));
    }
}

void TestDataFlashReader::read_parameters_nameTheSensor()
{
    DataFlashEncoder log;
    log.format(129, "PARM", 28, "QNf", "TimeUS,Name,Value");
    const auto parameter = [&](const char *name, float value) {
        log.message(129, bytesOf(std::uint64_t{0}) + DataFlashEncoder::padded(name, 16) + bytesOf(value));
    };
    parameter("INS_GYR_ID", 100.0f);
    parameter("INS_GYR2_ID", 200.0f);
    parameter("INS4_GYR_ID", 400.0f);
    parameter("INS_GYR_CAL", 1.0f);
    parameter("INS_TCAL2_ENABLE", 1.0f);
    log.format(140, "IMU", 25, "QBffff", "TimeUS,I,GyrX,GyrY,GyrZ,T");
    for (int i = 0; i < 4; ++i)
        log.message(140, bytesOf(std::uint64_t(i)) + static_cast<char>(i) + rates(i) + bytesOf(20.0f));
    const auto listed = listInstances(scratch(log.bytes()), {});
    QVERIFY(listed);
    QCOMPARE((*listed)[0].sensor.serial, std::string("100"));
    QCOMPARE((*listed)[1].sensor.serial, std::string("200"));
    QVERIFY(!(*listed)[2].sensor.known());
    QCOMPARE((*listed)[3].sensor.serial, std::string("400"));
    QVERIFY(warnsOf(*readBytesOf(log.bytes(), 1), "INS_TCAL2_ENABLE"));
    QVERIFY(readBytesOf(log.bytes(), 0)->info.warnings.empty());
}

void TestDataFlashReader::read_damageInTheMiddle_resynchronises()
{
    DataFlashEncoder log = oneGyro(50);
    const std::size_t byte = log.bytes().size();
    log.raw(std::string("\xA3\x95\x8C\xA3", 4) + std::string(1000, '\0'));
    log.raw(oneGyro(40).bytes());
    const auto recording = readBytesOf(log.bytes());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QVERIFY(recording->size() >= 90 && recording->size() <= 91);
    QVERIFY(
        warnsOf(*recording, "damaged at byte " + std::to_string(recording->size() == 90 ? byte : byte + 27)));
}

void TestDataFlashReader::read_nothingUsable_isAnError_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("code");
    const auto row = [](const char *name, const std::string &bytes, Errc code) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << int(code);
    };
    row("no gyro", DataFlashEncoder().bytes(), Errc::MissingColumn);
    row("only damage", std::string("\xA3\x95\x80", 3) + std::string(500, '\0'), Errc::DamagedLog);
    DataFlashEncoder wrongLength;
    wrongLength.format(140, "IMU", 99, "Qffff", "TimeUS,GyrX,GyrY,GyrZ,T");
    row("format that contradicts itself", wrongLength.bytes(), Errc::DamagedLog);
    DataFlashEncoder cold;
    cold.format(140, "IMU", 20, "Qfff", "TimeUS,GyrX,GyrY,GyrZ");
    cold.message(140, bytesOf(std::uint64_t{1}) + rates(1));
    row("no temperature", cold.bytes(), Errc::MissingColumn);
}

void TestDataFlashReader::read_nothingUsable_isAnError()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, code);
    const auto recording = readBytesOf(bytes.toStdString());
    QVERIFY(!recording);
    QVERIFY2(int(recording.error().code) == code, recording.error().message.c_str());
}

void TestDataFlashReader::read_cutAnywhere_keepsWhatIsGood()
{
    const std::string whole = oneGyro(60).bytes();
    const std::size_t first = whole.size() - 60 * kImuMessage;
    for (std::size_t bytes = 4; bytes < whole.size(); bytes += 7) {
        const auto recording = readBytesOf(whole.substr(0, bytes));
        const std::size_t good = bytes < first ? 0 : (bytes - first) / kImuMessage;
        QCOMPARE(recording.ok(), good > 0);
        if (!recording)
            continue;
        QCOMPARE(recording->size(), Eigen::Index(good));
        const std::size_t byte = first + good * kImuMessage;
        QCOMPARE(warnsOf(*recording, "from byte " + std::to_string(byte) + " on"), byte != bytes);
    }
}

void TestDataFlashReader::read_flippedBits_neverFails()
{
    constexpr std::uint64_t kSeed = 20261124;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    REQUIRE_SHARED_DATA(path, "formats/pymavlink_test.BIN");
    const std::string synthetic = oneGyro(60).bytes();
    const std::string real = readBytes(path);
    for (int i = 0; i < 200; ++i) {
        std::string bytes = i < 150 ? synthetic : real.substr(0, 20000 + random.below(real.size() - 20000));
        for (auto flips = 1 + random.below(i < 150 ? 8 : 200); flips > 0; --flips)
            bytes[3 + random.below(bytes.size() - 3)] ^= static_cast<char>(1 << random.below(8));
        const auto recording = readBytesOf(bytes, 0);
        QVERIFY(recording ? recording->size() > 0 : recording.error().message.ends_with('.'));
    }
}

QTEST_APPLESS_MAIN(TestDataFlashReader)
#include "tst_dataflash_reader.moc"
