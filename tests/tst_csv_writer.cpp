#include "engine/base/random.h"
#include "engine/formats/compensated_csv.h"
#include "engine/formats/csv_writer.h"
#include "engine/formats/log_reader.h"
#include "engine/formats/sidecar.h"
#include "support/log_encoders.h"
#include "support/test_data.h"

#include <QTest>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestCsvWriter : public QObject
{
    Q_OBJECT

private slots:
    void write_anyDoubles_readBackTheSame();
    void write_withDecimals_isThatText();
    void write_commentsAndSidecar_readBack();
    void write_folderMissing_saysSo();
    void compensate_table_keepsItsText_data();
    void compensate_table_keepsItsText();
    void compensate_manyRows_subtractsTheTde();
    void compensate_twice_isRefused();
    void compensate_badRow_leavesNoFile();
    void compensate_binaryLog_writesDefaultColumns();
};

static const std::string kHeader(kCsvHeader);

static Eigen::MatrixX3d tdeOf(const Eigen::VectorXd &temperatureC)
{
    Eigen::MatrixX3d tdeDps(temperatureC.size(), 3);
    tdeDps.col(0) = 0.5 * temperatureC;
    tdeDps.col(1) = -0.25 * temperatureC;
    tdeDps.col(2).setZero();
    return tdeDps;
}

static double anyDouble(Random &random)
{
    for (;;) {
        const std::uint64_t bits = random.bits();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof(value));
        if (std::isfinite(value))
            return value;
    }
}

void TestCsvWriter::write_anyDoubles_readBackTheSame()
{
    constexpr std::uint64_t kSeed = 99;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    Recording written;
    constexpr Eigen::Index kSamples = 20000;
    written.timeS = Eigen::VectorXd::NullaryExpr(kSamples, [&] { return anyDouble(random); });
    written.temperatureC = Eigen::VectorXd::NullaryExpr(kSamples, [&] { return random.normal(); });
    written.rateDps = Eigen::MatrixX3d::NullaryExpr(kSamples, 3, [&] { return random.normal(); });
    written.rateDps(5, 1) = std::numeric_limits<double>::infinity();
    const auto path = scratchFolder() / "round.csv";
    QVERIFY(writeCsv(path, written));
    const auto read = readLog(path, {});
    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->timeS, written.timeS);
    QCOMPARE(read->temperatureC, written.temperatureC);
    QCOMPARE(read->rateDps, written.rateDps);
}

void TestCsvWriter::write_withDecimals_isThatText()
{
    Recording recording;
    recording.timeS = Eigen::Vector2d(0.0, 0.1);
    recording.temperatureC = Eigen::Vector2d(20.125, std::numeric_limits<double>::quiet_NaN());
    recording.rateDps = Eigen::MatrixX3d::Constant(2, 3, -1.5);
    const auto path = scratchFolder() / "decimals.csv";
    QVERIFY(writeCsv(path, recording, {.time = 3, .temperature = 1, .rate = {}}));
    QCOMPARE(readBytes(path), kHeader + "\n0.000,20.1,-1.5,-1.5,-1.5\n0.100,nan,-1.5,-1.5,-1.5\n");
}

void TestCsvWriter::write_commentsAndSidecar_readBack()
{
    const auto path = scratchFolder() / "identity.csv";
    auto writer = CsvWriter::create(path, {}, {"sensor_model: L3GD20H"});
    QVERIFY(writer);
    Recording recording;
    recording.timeS = recording.temperatureC = Eigen::Vector2d(1, 2);
    recording.rateDps = Eigen::MatrixX3d::Ones(2, 3);
    QVERIFY(writer->write(recording));
    QVERIFY(!std::filesystem::exists(path));
    QVERIFY(writer->commit());
    RecordingInfo info;
    info.sensor.serial = "SIM-\"1\"";
    info.simulated = true;
    QVERIFY(writeSidecar(path, info));
    const auto read = readLog(path, {});
    QVERIFY(read);
    QCOMPARE(read->info.sensor.model, std::string("L3GD20H"));
    QCOMPARE(read->info.sensor.serial, info.sensor.serial);
    QVERIFY(read->info.simulated);
}

void TestCsvWriter::write_folderMissing_saysSo()
{
    QCOMPARE(writeCsv(scratchFolder() / "no" / "such.csv", {}).error().code, Errc::OutputNotWritable);
}

void TestCsvWriter::compensate_table_keepsItsText_data()
{
    QTest::addColumn<QString>("in");
    QTest::addColumn<QString>("out");
    QTest::newRow("plain") << "time,temp,gx,gy,gz\n0,20,1,2,3\n"
                           << "time,temp,gx,gy,gz,comp_x_dps,comp_y_dps,comp_z_dps\n"
                              "0,20,1,2,3,-9,7,3\n";
    QTest::newRow("all that a table may have")
        << "# made by hand\r\nnote;gz_mdps;gx_mdps;gy_mdps;Temp;t\r\n\"a;b\";3000;1000;2000;20;0\r\n# "
           "pause\r\n\r\n"
           "c;3e3;1000;2000;20.0;1"
        << "# made by hand\r\nnote;gz_mdps;gx_mdps;gy_mdps;Temp;t;comp_x_dps;comp_y_dps;comp_z_dps\r\n"
           "\"a;b\";3000;1000;2000;20;0;-9;7;3\r\n# pause\r\n\r\nc;3e3;1000;2000;20.0;1;-9;7;3";
    QTest::newRow("no temperature in a row") << "time,temp,gx,gy,gz\n0,,1,2,3\n"
                                             << "time,temp,gx,gy,gz,comp_x_dps,comp_y_dps,comp_z_dps\n"
                                                "0,,1,2,3,nan,nan,3\n";
}

void TestCsvWriter::compensate_table_keepsItsText()
{
    QFETCH(QString, in);
    QFETCH(QString, out);
    const auto from = scratchFolder() / "in.csv";
    const auto to = scratchFolder() / "out.csv";
    writeBytes(from, in.toStdString());
    const auto done = writeCompensatedCsv(from, to, {}, tdeOf);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    QCOMPARE(QString::fromStdString(readBytes(to)), out);
}

void TestCsvWriter::compensate_manyRows_subtractsTheTde()
{
    Random random(4);
    Recording recording;
    constexpr Eigen::Index kSamples = 30000;
    recording.timeS = Eigen::VectorXd::LinSpaced(kSamples, 0, 100);
    recording.temperatureC = Eigen::VectorXd::NullaryExpr(kSamples, [&] { return random.uniform(-40, 85); });
    recording.rateDps = Eigen::MatrixX3d::NullaryExpr(kSamples, 3, [&] { return random.normal(); });
    const auto from = scratchFolder() / "many.csv";
    const auto to = scratchFolder() / "many_out.csv";
    QVERIFY(writeCsv(from, recording));
    const auto done = writeCompensatedCsv(from, to, {}, tdeOf);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    QCOMPARE(done->samples, std::int64_t{kSamples});
    ReadOptions options;
    options.csv.columns = {"", "", "comp_x_dps", "comp_y_dps", "comp_z_dps"};
    const auto read = readLog(to, options);
    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->rateDps, Eigen::MatrixX3d(recording.rateDps - tdeOf(recording.temperatureC)));
    const auto measured = readLog(to, {});
    QVERIFY(measured);
    QCOMPARE(measured->rateDps, recording.rateDps);
}

void TestCsvWriter::compensate_twice_isRefused()
{
    const auto from = scratchFolder() / "once.csv";
    writeBytes(from, "time,temp,gx,gy,gz,comp_x_dps,comp_y_dps,comp_z_dps\n0,20,1,2,3,-9,7,3\n");
    QCOMPARE(writeCompensatedCsv(from, scratchFolder() / "twice.csv", {}, tdeOf).error().code,
             Errc::InvalidOption);
}

void TestCsvWriter::compensate_badRow_leavesNoFile()
{
    const auto from = scratchFolder() / "bad.csv";
    const auto to = scratchFolder() / "never.csv";
    writeBytes(from, "time,temp,gx,gy,gz\n0,20,1,2,3\n1,20,1,two,3\n");
    QCOMPARE(writeCompensatedCsv(from, to, {}, tdeOf).error().code, Errc::NotANumber);
    QVERIFY(!std::filesystem::exists(to));
}

void TestCsvWriter::compensate_binaryLog_writesDefaultColumns()
{
    DataFlashEncoder log;
    log.format(140, "IMU", 24, "Qffff", "TimeUS,GyrX,GyrY,GyrZ,T");
    log.message(140, bytesOf(std::uint64_t{1500000}) + bytesOf(0.0f) + bytesOf(0.0f) + bytesOf(0.0f) +
                         bytesOf(20.0f));
    const auto from = scratchFolder() / "log.bin";
    const auto to = scratchFolder() / "bin_out.csv";
    writeBytes(from, log.bytes());
    const auto done = writeCompensatedCsv(from, to, {}, tdeOf);
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    QCOMPARE(readBytes(to), kHeader + ",comp_x_dps,comp_y_dps,comp_z_dps\n1.5,20,0,0,0,-10,5,0\n");
}

QTEST_APPLESS_MAIN(TestCsvWriter)
#include "tst_csv_writer.moc"
