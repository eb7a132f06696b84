#include "engine/base/random.h"
#include "engine/base/text.h"
#include "engine/formats/csv_spelling.h"
#include "engine/formats/decimal.h"
#include "engine/formats/log_reader.h"
#include "support/log_encoders.h"
#include "support/test_data.h"

#include <QTest>

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace driftbench;
using namespace driftbench::test;

class TestCsvReader : public QObject
{
    Q_OBJECT

private slots:
    void scanDecimal_randomText_isNearestDouble();
    void scanDecimal_specialText_data();
    void scanDecimal_specialText();
    void read_headerSpelling_findsColumnsAndUnits_data();
    void read_headerSpelling_findsColumnsAndUnits();
    void readSpelling_otherQuantity_fitsNothing_data();
    void readSpelling_otherQuantity_fitsNothing();
    void read_shapeOfText_givesSameSamples_data();
    void read_shapeOfText_givesSameSamples();
    void read_badText_namesTheReason_data();
    void read_badText_namesTheReason();
    void read_optionsForUnits_convert();
    void read_nonFiniteAndEmptyFields_areKept();
    void read_damagedRows_areLeftOutWithTheirByte();
    void read_cutAtEveryByte_keepsWholeRows();
    void read_randomBytes_neverFails();
    void read_identity_fromCommentsAndSidecar();
    void read_implausibleUnits_warn_data();
    void read_implausibleUnits_warn();
    void read_blocks_joinToTheWhole();
    void read_oneColumnNamedTwice_givesItToBoth();
    void read_rawChamberLog_equalsPublishedConversion();
};

static std::filesystem::path scratch(std::string_view bytes)
{
    const auto path = scratchFolder() / "log.csv";
    writeBytes(path, bytes);
    return path;
}

static Result<Recording> readText(std::string_view text, const CsvOptions &options = {})
{
    return readLog(scratch(text), {.instance = {}, .csv = options});
}

static std::string joinedWarnings(const Recording &recording)
{
    std::string all;
    for (const std::string &warning : recording.info.warnings)
        all += warning + '\n';
    return all;
}

static std::string randomDecimal(Random &random)
{
    std::string text(random.below(3) == 0 ? "-" : "");
    const auto digits = [&](std::uint64_t most) {
        for (auto left = random.below(most + 1); left > 0; --left)
            text += static_cast<char>('0' + random.below(10));
    };
    text += static_cast<char>('0' + random.below(10));
    digits(random.below(4) == 0 ? 24 : 7);
    if (random.below(4) != 0) {
        text += '.';
        digits(random.below(4) == 0 ? 24 : 9);
    }
    if (random.below(4) == 0)
        text += (random.below(2) == 0 ? "e-" : "E+") + std::to_string(random.below(340));
    return text;
}

void TestCsvReader::scanDecimal_randomText_isNearestDouble()
{
    constexpr std::uint64_t kSeed = 20261122;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int i = 0; i < 300000; ++i) {
        const std::string text = randomDecimal(random) + ',';
        double value = 0.0;
        const char *const behind = scanDecimal(text.data(), text.data() + text.size(), value);
        const double expected = std::strtod(text.c_str(), nullptr);
        QVERIFY2(behind == text.data() + text.size() - 1, text.c_str());
        QVERIFY2(std::memcmp(&value, &expected, sizeof(value)) == 0, text.c_str());
    }
}

void TestCsvReader::scanDecimal_specialText_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("length"); // of the number, -1: none
    const std::string zeros(400, '0');
    for (const char *const text :
         {"0", "-0", "+1.5", "1.", ".5", "1e400", "-1e400", "1e-400", "9007199254740993",
          "9007199254740992.5", "123456789012345678901234567890", "0.1e1", "1E5", "2.2250738585072011e-308",
          "4.9e-324", "2.4703282292062327e-324", "1.7976931348623159e308"})
        QTest::newRow(text) << text << int(std::strlen(text));
    QTest::newRow("tiny without exponent") << QString::fromStdString("0." + zeros + "1") << 403;
    QTest::newRow("huge without exponent") << QString::fromStdString("1" + zeros) << 401;
    QTest::newRow("huge taken back") << QString::fromStdString("1" + zeros + "e-400") << 406;
    for (const char *const text : {"", "-", "+", ".", "abc", "-.", "e5", "nan"})
        QTest::newRow(*text == '\0' ? "nothing" : text) << text << -1;
}

void TestCsvReader::scanDecimal_specialText()
{
    QFETCH(QString, text);
    QFETCH(int, length);
    const std::string line = text.toStdString() + '\n';
    double value = 0.0;
    const char *const behind = scanDecimal(line.data(), line.data() + line.size(), value);
    if (length < 0) {
        QVERIFY(behind == nullptr);
        return;
    }
    QVERIFY(behind == line.data() + length);
    const double expected = std::strtod(line.c_str(), nullptr);
    QVERIFY(std::memcmp(&value, &expected, sizeof(value)) == 0);
}

void TestCsvReader::read_headerSpelling_findsColumnsAndUnits_data()
{
    QTest::addColumn<QString>("header");
    QTest::addColumn<double>("secondsPerUnit");
    QTest::addColumn<double>("dpsPerUnit");
    QTest::addColumn<double>("celsiusOfHundred");
    const double rad = 180.0 / 3.14159265358979323846;
    const auto row = [](const char *header, double seconds, double dps, double celsius) {
        QTest::newRow(header) << QString::fromUtf8(header) << seconds << dps << celsius;
    };
    row("time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps", 1, 1, 100);
    row("time,temp,gx,gy,gz", 1, 1, 100);
    row("t,T,x,y,z", 1, 1, 100);
    row("Time (ms),Temperature (°C),x rate (dps),y rate (dps),z rate (dps)", 1e-3, 1, 100);
    row("TimeUS,T,GyrX,GyrY,GyrZ", 1e-6, 1, 100);
    row("timestamp_us;imu.temperature;imu.gyro.x;imu.gyro.y;imu.gyro.z", 1e-6, 1, 100);
    row("time [µs]\ttemp [K]\tgyro_x [rad/s]\tgyro_y [rad/s]\tgyro_z [rad/s]", 1e-6, rad, 100 - 273.15);
    row("t_ns,temp_degC,rate_x_mdps,rate_y_mdps,rate_z_mdps", 1e-9, 1e-3, 100);
    row("elapsed_s,temp_f,wx,wy,wz", 1, 1, 340.0 / 9.0);
    row("seconds,die temperature,omega_x (deg/s),omega_y (deg/s),omega_z (deg/s)", 1, 1, 100);
    row("\"time, s\",\"temperature\",\"gyro x (°/s)\",\"gyro y (°/s)\",\"gyro z (°/s)\"", 1, 1, 100);
    row("msec,TEMP,GYRO_X_RADPS,GYRO_Y_RADPS,GYRO_Z_RADPS", 1e-3, rad, 100);
    row("time_s,sensor_temperature_K,gyro_rad[0],gyro_rad[1],gyro_rad[2]", 1, rad, 100 - 273.15);
    row("time_s,temperature,angular_velocity.x,angular_velocity.y,angular_velocity.z", 1, 1, 100);
    row("time_s,temperature,gyroscope_x_deg_s,gyroscope_y_deg_s,gyroscope_z_deg_s", 1, 1, 100);
    row("time_s,temperature,bmi088_gyro_x,bmi088_gyro_y,bmi088_gyro_z", 1, 1, 100);
}

void TestCsvReader::read_headerSpelling_findsColumnsAndUnits()
{
    QFETCH(QString, header);
    QFETCH(double, secondsPerUnit);
    QFETCH(double, dpsPerUnit);
    QFETCH(double, celsiusOfHundred);
    const std::string names = header.toStdString();
    const char separator = names.find('\t') != std::string::npos  ? '\t'
                           : names.find(';') != std::string::npos ? ';'
                                                                  : ',';
    std::string row = "3,100,1,-2,4\n";
    std::replace(row.begin(), row.end(), ',', separator);
    const auto recording = readText(names + '\n' + row);
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->timeS[0], 3 * secondsPerUnit);
    QVERIFY(std::abs(recording->temperatureC[0] - celsiusOfHundred) < 1e-12);
    QVERIFY((recording->rateDps.row(0) / dpsPerUnit - Eigen::RowVector3d(1, -2, 4)).norm() < 1e-12);
}

void TestCsvReader::readSpelling_otherQuantity_fitsNothing_data()
{
    QTest::addColumn<QString>("name");
    for (const char *const name : {"acc_x", "ax", "mag.y", "comp_x_dps", "imu.status", "ErrG", "AccZ",
                                   "gyro_bias_x", "pressure", "latitude", "ref_temperature", "", "1"})
        QTest::newRow(*name == '\0' ? "empty" : name) << name;
}

void TestCsvReader::readSpelling_otherQuantity_fitsNothing()
{
    QFETCH(QString, name);
    const ColumnSpelling spelling = readSpelling(name.toStdString());
    for (int i = 0; i < int(kCsvQuantityCount); ++i)
        QCOMPARE(spelling.fit(static_cast<CsvQuantity>(i)), 0);
}

static const std::string kHeader = "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps";

void TestCsvReader::read_shapeOfText_givesSameSamples_data()
{
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, const std::string &text) {
        QTest::newRow(name) << QString::fromStdString(text);
    };
    row("plain", kHeader + "\n0,20.5,1,-2,0.25\n1,21,1e0,-2.0,.25\n");
    row("CRLF", kHeader + "\r\n0,20.5,1,-2,0.25\r\n1,21,1,-2,.25\r\n");
    row("byte order mark", "\xEF\xBB\xBF" + kHeader + "\n0,20.5,1,-2,0.25\n1,21,1,-2,.25\n");
    row("comments and blank lines", "# made by hand\n\n% so\n// it is\n" + kHeader +
                                        "\n\n0,20.5,1,-2,0.25\n# pause\n   \n1,21,1,-2,.25\n\n");
    row("quotes",
        "\"time\",\"temp\",\"gx\",\"gy\",\"gz\"\n\"0\",\"20.5\",\"1\",\"-2\",\"0.25\"\n1,21,1,-2,.25\n");
    row("blanks", kHeader + "\n 0, 20.5, 1, -2, 0.25\n 1 , 21 , +1 , -2 , .25 \n");
    row("other columns and order",
        "gz,note,gy,gx,time,acc_x,temp,end\n0.25,\"a,b\",-2,1,0,9,20.5,\n.25,,-2,1,1,9,21,x,y\n");
    row("no line end at the end", kHeader + "\n0,20.5,1,-2,0.25\n1,21,1,-2,.25");
    row("header as a comment", "# " + kHeader + "\n0,20.5,1,-2,0.25\n1,21,1,-2,.25\n");
    row("header repeated", kHeader + "\n0,20.5,1,-2,0.25\n" + kHeader + "\n1,21,1,-2,.25\n");
    row("tabs", "time\ttemp\tgx\tgy\tgz\n0\t20.5\t1\t-2\t0.25\n1\t21\t1\t-2\t.25\n");
    row("semicolons", "time;temp;gx;gy;gz\n0;20.5;1;-2;0.25\n1;21;1;-2;.25\n");
}

void TestCsvReader::read_shapeOfText_givesSameSamples()
{
    QFETCH(QString, text);
    const auto recording = readText(text.toStdString());
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 2);
    QCOMPARE(recording->timeS, Eigen::Vector2d(0, 1));
    QCOMPARE(recording->temperatureC, Eigen::Vector2d(20.5, 21));
    QVERIFY(recording->rateDps.row(0) == Eigen::RowVector3d(1, -2, 0.25));
    QVERIFY(recording->rateDps.row(1) == Eigen::RowVector3d(1, -2, 0.25));
}

void TestCsvReader::read_badText_namesTheReason_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("said");
    const auto row = [](const char *name, const std::string &text, Errc code, const char *said) {
        QTest::newRow(name) << QString::fromStdString(text) << int(code) << said;
    };
    row("text in a number column", kHeader + "\n0,20,1,2,3\n1,20,1,oops,3\n", Errc::NotANumber,
        "line 3, column 4 (gyro_y_dps): \"oops\"");
    row("decimal comma", "time;temp;gx;gy;gz\n0;20,5;1;2;3\n", Errc::NotANumber, "decimal point");
    row("wrong column", "time,temp,gx,gy,speed\n0,20,1,2,3\n", Errc::MissingColumn,
        "time, temp, gx, gy, speed");
    row("no time", "temperature,gx,gy,gz\n20,1,2,3\n", Errc::MissingColumn, "the time");
    row("no header", "0,20,1,2,3\n1,20,1,2,3\n", Errc::MissingColumn, "5 columns");
    row("only a header", kHeader + "\n", Errc::TooFewSamples, "no samples");
    row("only comments", "# nothing\n\n", Errc::TooFewSamples, "no rows");
    row("counts without sensitivity", "time,temp,gx_raw,gy_raw,gz_raw\n0,20,1,2,3\n", Errc::InvalidOption,
        "sensitivity");
    row("nothing but damage", kHeader + "\n0,20\n1,20\n", Errc::DamagedLog, "damaged");
    row("prose", "Dear reader,\nthis is a letter.\n", Errc::MissingColumn, "Dear reader");
    row("endless line", std::string(3000000, 'x'), Errc::UnknownFormat, "megabyte");
}

void TestCsvReader::read_badText_namesTheReason()
{
    QFETCH(QString, text);
    QFETCH(int, code);
    QFETCH(QString, said);
    const auto recording = readText(text.toStdString());
    QVERIFY(!recording);
    QVERIFY2(int(recording.error().code) == code, recording.error().message.c_str());
    QVERIFY2(QString::fromStdString(recording.error().message).contains(said),
             recording.error().message.c_str());
    QVERIFY(recording.error().message.find("log.csv") != std::string::npos);
}

void TestCsvReader::read_optionsForUnits_convert()
{
    CsvOptions options;
    options.columns = {"1", "5", "Alpha", "beta", "4"};
    options.separator = ';';
    options.timeUnit = TimeUnit::Milliseconds;
    options.rateUnit = RateUnit::Counts;
    options.temperatureUnit = TemperatureUnit::Kelvin;
    options.sensitivityMdpsPerCount = 8.75;
    const auto named = readText("when;alpha;beta;c;d\n1500;100;-200;400;300.15\n", options);
    QVERIFY2(named, named ? "" : named.error().message.c_str());
    QCOMPARE(named->timeS[0], 1.5);
    QVERIFY(std::abs(named->temperatureC[0] - 27.0) < 1e-12);
    QVERIFY((named->rateDps.row(0) - Eigen::RowVector3d(0.875, -1.75, 3.5)).norm() < 1e-12);
    options.columns = {"1", "5", "2", "3", "4"};
    const auto numbered = readText("1500;100;-200;400;300.15\n", options);
    QVERIFY2(numbered, numbered ? "" : numbered.error().message.c_str());
    QCOMPARE(numbered->rateDps, named->rateDps);
    options.columns[0] = "6";
    const auto missing = readText("1500;100;-200;400;300.15\n", options);
    QCOMPARE(missing.error().code, Errc::MissingColumn);
}

void TestCsvReader::read_nonFiniteAndEmptyFields_areKept()
{
    const auto recording = readText(kHeader + "\n0,nan,1,,3\n1,20,inf,-Inf,NA\n");
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->size(), 2);
    QVERIFY(std::isnan(recording->temperatureC[0]) && std::isnan(recording->rateDps(0, 1)));
    QVERIFY(std::isinf(recording->rateDps(1, 0)) && recording->rateDps(1, 1) < 0.0);
    QVERIFY(std::isnan(recording->rateDps(1, 2)));
}

void TestCsvReader::read_damagedRows_areLeftOutWithTheirByte()
{
    std::string text = kHeader + "\n# " + std::string(1000, '-') + "\n0,20,1,2,3\n";
    const std::size_t byte = text.size();
    text += "1,20,1\n2,20,1,2,3\n" + std::string(50, '\0') + "\n3,20,1,2,3\n";
    const auto recording = readText(text);
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    QCOMPARE(recording->timeS, Eigen::Vector3d(0, 2, 3));
    const std::string warnings = joinedWarnings(*recording);
    QVERIFY2(warnings.find("line 4 (byte " + std::to_string(byte) + "): 2 rows") != std::string::npos,
             warnings.c_str());
}

void TestCsvReader::read_cutAtEveryByte_keepsWholeRows()
{
    const std::string text =
        kHeader + "\n0.5,20.25,1.5,2.5,3.5\n1.5,21.25,1.5,2.5,3.5\n2.5,22.25,1.5,2.5,3.5\n";
    const std::size_t firstRow = kHeader.size() + 1;
    for (std::size_t bytes = firstRow + 22; bytes <= text.size(); ++bytes) {
        const auto recording = readText(text.substr(0, bytes));
        QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
        const auto whole = static_cast<Eigen::Index>((bytes - firstRow) / 22);
        QVERIFY(recording->size() == whole || recording->size() == whole + 1);
        QVERIFY(recording->timeS.head(whole) == Eigen::Vector3d(0.5, 1.5, 2.5).head(whole));
        const bool insideRow = (bytes - firstRow) % 22 != 0;
        if (insideRow && recording->size() == whole) {
            const std::string byte =
                "(byte " + std::to_string(firstRow + 22 * static_cast<std::size_t>(whole)) + ")";
            QVERIFY(joinedWarnings(*recording).find(byte) != std::string::npos);
        }
    }
}

void TestCsvReader::read_randomBytes_neverFails()
{
    constexpr std::uint64_t kSeed = 7;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    constexpr std::string_view kAlphabet{"0123456789.,-+eE;\t \"\r\n#xtyz\0\xFF", 29};
    for (int i = 0; i < 400; ++i) {
        std::string text = random.below(2) == 0 ? kHeader + '\n' : "";
        for (auto left = random.below(300); left > 0; --left)
            text += kAlphabet[random.below(kAlphabet.size())];
        const auto recording = readText(text + 'x');
        QVERIFY(recording ? recording->size() > 0 : recording.error().message.ends_with('.'));
    }
}

void TestCsvReader::read_identity_fromCommentsAndSidecar()
{
    const std::string text =
        "# sensor_model: I3G4250D\n# sensor_serial: S1\n# simulated: true\n" + kHeader + "\n0,20,1,2,3\n";
    const auto byComment = readText(text);
    QVERIFY(byComment);
    QCOMPARE(byComment->info.sensor.text(), std::string("I3G4250D S1"));
    QVERIFY(byComment->info.simulated);
    const auto sidecar = scratchFolder() / "log.csv.meta.json";
    writeBytes(sidecar, R"({"sensor":{"serial":"S2"},"simulated":false,"more":[1]})");
    const auto bySidecar = readText(text);
    writeBytes(sidecar, R"({"sensor":)");
    const auto damaged = readText(text);
    std::filesystem::remove(sidecar);
    QVERIFY(bySidecar && damaged);
    QCOMPARE(bySidecar->info.sensor.text(), std::string("I3G4250D S2"));
    QVERIFY(!bySidecar->info.simulated);
    QCOMPARE(damaged->info.sensor.serial, std::string("S1"));
    QVERIFY(joinedWarnings(*damaged).find("meta.json") != std::string::npos);
}

void TestCsvReader::read_implausibleUnits_warn_data()
{
    QTest::addColumn<QString>("header");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("step");
    QTest::addColumn<QString>("said"); // empty: no warning
    QTest::newRow("dps") << "time,temp,gx,gy,gz" << 0.14 << 0.1 << "";
    QTest::newRow("quiet dps") << "time,temp,gx,gy,gz" << 0.004 << 0.1 << "";
    QTest::newRow("no noise") << "time,temp,gx,gy,gz" << 0.0 << 0.1 << "";
    QTest::newRow("rad/s as dps") << "time,temp,gx,gy,gz" << 0.0005 << 0.1 << "rad/s";
    QTest::newRow("rad/s with a wrong label")
        << "time,temp,gx_dps,gy_dps,gz_dps" << 0.0005 << 0.1 << "stated unit";
    QTest::newRow("mdps as dps") << "time,temp,gx,gy,gz" << 140.0 << 0.1 << "mdps";
    QTest::newRow("us as s") << "time,temp,gx,gy,gz" << 0.14 << 10000.0 << "unit of time";
    QTest::newRow("timestamp in us") << "timestamp,temp,gx,gy,gz" << 0.14 << 10000.0 << "microseconds";
    QTest::newRow("timestamp in s") << "timestamp,temp,gx,gy,gz" << 0.14 << 0.1 << "";
}

void TestCsvReader::read_implausibleUnits_warn()
{
    QFETCH(QString, header);
    QFETCH(double, noise);
    QFETCH(double, step);
    QFETCH(QString, said);
    Random random(11);
    std::string text = header.toStdString() + '\n';
    for (int i = 0; i < 500; ++i) {
        text += shortest(i * step) + ",20";
        for (int axis = 0; axis < 3; ++axis)
            text += ',' + shortest(noise * random.normal());
        text += '\n';
    }
    const auto recording = readText(text);
    QVERIFY2(recording, recording ? "" : recording.error().message.c_str());
    const std::string warnings = joinedWarnings(*recording);
    QVERIFY2(said.isEmpty() ? warnings.empty() : QString::fromStdString(warnings).contains(said),
             warnings.c_str());
}

void TestCsvReader::read_blocks_joinToTheWhole()
{
    std::string text = kHeader + '\n';
    constexpr int kRows = 40000;
    for (int i = 0; i < kRows; ++i)
        text += std::to_string(i) + "." + std::to_string(i % 7) + ",20,1,2," + std::to_string(i) + "\n";
    const auto path = scratch(text);
    std::int64_t samples = 0;
    double sum = 0.0;
    const auto info = readLogBlocks(path, {}, [&](const SampleBlock &block) {
        if (block.firstSample != samples || block.size() == 0)
            return Flow::Stop;
        samples += block.size();
        sum += block.rateDps.col(2).sum();
        return Flow::Continue;
    });
    QVERIFY2(info, info ? "" : info.error().message.c_str());
    QCOMPARE(samples, std::int64_t{kRows});
    QCOMPARE(sum, kRows * (kRows - 1) / 2.0);
    const auto whole = readLog(path, {});
    QVERIFY(whole);
    for (int i = 0; i < kRows; ++i)
        QCOMPARE(whole->rateDps(i, 2), double(i));
}

void TestCsvReader::read_oneColumnNamedTwice_givesItToBoth()
{
    CsvOptions options;
    options.columns = {"t", "a", "b", "b", "a"};
    const auto recording = readText("t,a,b\n0,1,2\n1,3,4\n", options);
    QVERIFY(recording.ok());
    QCOMPARE(recording->temperatureC[1], 3.0);
    QCOMPARE(recording->rateDps(1, 0), 4.0);
    QCOMPARE(recording->rateDps(1, 1), 4.0);
    QCOMPARE(recording->rateDps(1, 2), 3.0);
}

void TestCsvReader::read_rawChamberLog_equalsPublishedConversion()
{
    REQUIRE_SHARED_DATA(path, "climate_chamber/raw_as_published.tsv");
    const std::filesystem::path &raw = path;
    const std::filesystem::path converted = path.parent_path() / "chamber_all.csv";
    CsvOptions options;
    options.separator = '\t';
    options.timeUnit = TimeUnit::Microseconds;
    options.rateUnit = RateUnit::RadiansPerSecond;
    const auto a = readLog(raw, {.instance = {}, .csv = options});
    const auto b = readLog(converted, {});
    QVERIFY2(a, a ? "" : a.error().message.c_str());
    QVERIFY2(b, b ? "" : b.error().message.c_str());
    QCOMPARE(a->size(), b->size());
    QVERIFY(((a->timeS.array() - a->timeS[0]).matrix() - b->timeS).cwiseAbs().maxCoeff() < 1e-6);
    QVERIFY((a->temperatureC - b->temperatureC).cwiseAbs().maxCoeff() < 1e-5);
    QVERIFY((a->rateDps - b->rateDps).cwiseAbs().maxCoeff() < 1e-6);
    QVERIFY(a->info.warnings.empty() && b->info.warnings.empty());
    const auto bySpelling = readLog(raw, {});
    QVERIFY(bySpelling);
    QCOMPARE(bySpelling->timeS, a->timeS);
    QVERIFY(joinedWarnings(*bySpelling).find("rad/s") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestCsvReader)
#include "tst_csv_reader.moc"
