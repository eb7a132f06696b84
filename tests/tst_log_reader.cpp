#include "engine/formats/log_reader.h"
#include "support/log_encoders.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestLogReader : public QObject
{
    Q_OBJECT

private slots:
    void detectFormat_content_decides_data();
    void detectFormat_content_decides();
    void detectFormat_unreadable_saysWhy();
    void readLog_sharedLogs_read_data();
    void readLog_sharedLogs_read();
    void readLog_instanceOfTable_isRefused();
    void listInstances_table_hasOne();
    void readLog_stoppedByHook_isCancelled();
};

static std::filesystem::path scratch(const char *name, std::string_view bytes)
{
    const auto path = scratchFolder() / name;
    writeBytes(path, bytes);
    return path;
}

void TestLogReader::detectFormat_content_decides_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("format"); // -1: UnknownFormat
    const auto bytesOfText = [](const std::string &text) { return QByteArray::fromStdString(text); };
    QTest::newRow("csv") << QByteArray("time_s,x\n1,2\n") << int(LogFormat::Csv);
    QTest::newRow("text with degree signs in Latin-1") << QByteArray("t;T [\xB0"
                                                                     "C]\n")
                                                       << int(LogFormat::Csv);
    QTest::newRow("ulog") << bytesOfText(ULogEncoder().bytes()) << int(LogFormat::ULog);
    QTest::newRow("dataflash") << bytesOfText(DataFlashEncoder().bytes()) << int(LogFormat::DataFlash);
    QTest::newRow("dataflash with a lost beginning")
        << bytesOfText(std::string("\x01\x02\x00\xFF", 4) + DataFlashEncoder().bytes())
        << int(LogFormat::DataFlash);
    QTest::newRow("garbage") << QByteArray("\x7F"
                                           "ELF\x02\x01\x01\x00\x00\x00",
                                           10)
                             << -1;
    QTest::newRow("zeros") << QByteArray(1000, '\0') << -1;
    QTest::newRow("utf-16") << QByteArray("\xFF\xFEt\0i\0", 6) << -1;
}

void TestLogReader::detectFormat_content_decides()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, format);
    const auto found = detectFormat(scratch("misleading.ulg", bytes.toStdString()));
    if (format >= 0) {
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        QCOMPARE(int(*found), format);
    } else {
        QVERIFY(!found);
        QCOMPARE(found.error().code, Errc::UnknownFormat);
    }
}

void TestLogReader::detectFormat_unreadable_saysWhy()
{
    QCOMPARE(detectFormat(scratchFolder() / "nowhere.csv").error().code, Errc::FileNotFound);
    QCOMPARE(detectFormat(scratchFolder()).error().code, Errc::FileUnreadable);
    QCOMPARE(detectFormat(scratch("empty.csv", "")).error().code, Errc::FileEmpty);
    QCOMPARE(readLog(scratchFolder() / "nowhere.csv", {}).error().code, Errc::FileNotFound);
}

void TestLogReader::readLog_sharedLogs_read_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("instance");
    QTest::addColumn<int>("samples");
    QTest::addColumn<QString>("format");
    QTest::newRow("chamber") << "climate_chamber/chamber_all.csv" << 0 << 8400 << "csv";
    QTest::newRow("control") << "no_drift_control/astropi_2015_sensehat.csv" << 0 << 24604 << "csv";
    QTest::newRow("px4") << "formats/pyulog_sample_log_small.ulg" << 1 << 6 << "ulog";
    QTest::newRow("px4 combined") << "formats/pyulog_sample_log_small.ulg" << 3 << 1298 << "ulog";
    QTest::newRow("ardupilot") << "formats/pymavlink_test.BIN" << 1 << 45 << "dataflash";
    QTest::newRow("ardupilot old") << "dataflash_warmup/log171.bin" << 2 << 11916 << "dataflash";
}

void TestLogReader::readLog_sharedLogs_read()
{
    QFETCH(QString, file);
    QFETCH(int, instance);
    QFETCH(int, samples);
    QFETCH(QString, format);
    REQUIRE_SHARED_DATA(path, qPrintable(file));
    const auto recording = readLog(path, {.instance = instance, .csv = {}});
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), samples);
    QCOMPARE(QString::fromStdString(recording->info.format), format);
    QCOMPARE(recording->info.instance, instance);
    QVERIFY(recording->timeS.allFinite() && recording->temperatureC.allFinite() &&
            recording->rateDps.allFinite());
    QVERIFY(recording->temperatureC.minCoeff() > -60.0 && recording->temperatureC.maxCoeff() < 90.0);
    const auto listed = listInstances(path, {});
    QVERIFY(listed);
    const auto found = std::find_if(listed->begin(), listed->end(),
                                    [&](const LogInstance &one) { return one.instance == instance; });
    QVERIFY(found != listed->end());
    QCOMPARE(found->samples, samples);
    QCOMPARE(found->startS, recording->timeS[0]);
}

void TestLogReader::readLog_instanceOfTable_isRefused()
{
    const auto path = scratch("one.csv", "time,temp,gx,gy,gz\n1,2,3,4,5\n");
    QVERIFY(readLog(path, {.instance = 0, .csv = {}}));
    QCOMPARE(readLog(path, {.instance = 1, .csv = {}}).error().code, Errc::NoSuchInstance);
}

void TestLogReader::listInstances_table_hasOne()
{
    const auto path =
        scratch("list.csv", "# sensor_serial: S7\ntime,temp,gx,gy,gz\n1,20,3,4,5\n2,22,3,4,5\n3,21,3,4,5\n");
    const auto listed = listInstances(path, {});
    QVERIFY(listed);
    QCOMPARE(listed->size(), std::size_t{1});
    QCOMPARE(listed->front().samples, 3);
    QCOMPARE(listed->front().durationS, 2.0);
    QCOMPARE(listed->front().meanRateHz(), 1.0);
    QCOMPARE(listed->front().lowestTemperatureC, 20.0);
    QCOMPARE(listed->front().highestTemperatureC, 22.0);
    QCOMPARE(listed->front().sensor.serial, std::string("S7"));
}

void TestLogReader::readLog_stoppedByHook_isCancelled()
{
    const auto path = scratch("stop.csv", "time,temp,gx,gy,gz\n1,20,3,4,5\n");
    const auto stopped = readLog(path, {}, [](const Progress &) { return Flow::Stop; });
    QCOMPARE(stopped.error().code, Errc::Cancelled);
}

QTEST_APPLESS_MAIN(TestLogReader)
#include "tst_log_reader.moc"
