#include "engine/compensation/fixed_point_table.h"
#include "engine/compensation/table_apply.h"
#include "engine/exports/export_model.h"
#include "engine/exports/table_csv.h"
#include "engine/exports/table_json.h"
#include "support/models_for_export.h"
#include "support/test_data.h"

#include <QFile>
#include <QProcess>
#include <QTest>
#include <cstring>
#include <nlohmann/json.hpp>

using namespace driftbench;
using namespace driftbench::test;

class TestExportTable : public QObject
{
    Q_OBJECT

private slots:
    void csvAndJson_randomModels_readBackExactly();
    void csv_simulatedAndLeftOut_saySoInTheHeader();
    void read_damagedTables_areRefused_data();
    void read_damagedTables_areRefused();
    void cHeader_compiledAsC99_equalsApplyAndFixedPoint();
    void cHeader_hostileTexts_stayInTheComment();
    void cHeader_badSymbol_isRefused();
    void exportModel_sameModel_givesSameBytes();
    void exportModel_axisWithoutYes_needsForce();
    void exportModelToFile_unwritable_isAnError();
};

static CompensationTable makeTable(Random &random, const std::array<bool, 3> &axes = {true, true, true})
{
    TrainedModel model = randomModel(random);
    model.simulated = random.below(2) == 0;
    model.verdicts[2] = std::nullopt;
    auto table = makeCompensationTable(model, axes, {});
    return *std::move(table);
}

static bool sameTable(const CompensationTable &a, const CompensationTable &b)
{
    const TableProvenance &p = a.provenance;
    const TableProvenance &q = b.provenance;
    return a.firstMilliC == b.firstMilliC && a.lastMilliC == b.lastMilliC && a.size() == b.size() &&
           a.tdeDps == b.tdeDps && a.compensated == b.compensated &&
           a.measuredErrorDps == b.measuredErrorDps &&
           a.interpolationErrorBoundDps == b.interpolationErrorBoundDps && p.modelName == q.modelName &&
           p.sensor.model == q.sensor.model && p.sensor.serial == q.sensor.serial &&
           p.referenceTemperatureC == q.referenceTemperatureC &&
           p.lowestTemperatureC == q.lowestTemperatureC && p.highestTemperatureC == q.highestTemperatureC &&
           p.simulated == q.simulated && p.trainedOn == q.trainedOn && p.judging == q.judging &&
           p.verdicts == q.verdicts && p.reasons == q.reasons;
}

void TestExportTable::csvAndJson_randomModels_readBackExactly()
{
    Random random = announced(20261107);
    for (int i = 0; i < 12; ++i) {
        const CompensationTable table = makeTable(random, {i % 2 == 0, true, true});
        for (const std::string &text : {tableToCsv(table), tableToJson(table)}) {
            const auto read = readTable(text, "table");
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
            QVERIFY(sameTable(*read, table));
        }
        const auto json = nlohmann::json::parse(tableToJson(table));
        const auto values =
            json.at("fixed_point").at("values").get<std::vector<std::array<std::int32_t, 3>>>();
        QVERIFY(values == makeFixedPointTable(table).values);
    }
}

void TestExportTable::csv_simulatedAndLeftOut_saySoInTheHeader()
{
    Random random(2);
    TrainedModel model = randomCubic(random);
    model.simulated = true;
    model.verdicts[0] = Verdict::NotRepeatable;
    model.reasons[0] = "the runs differ by 0.32 dps";
    const auto exported = exportModel(model, ExportFormat::Csv);
    QVERIFY(exported.ok());
    for (const char *part : {"SIMULATED", "compensated_x: no", "verdict_x: not repeatable",
                             "reason_x: the runs differ by 0.32 dps", "compensated_y: yes",
                             "sensor_serial: 3408138", "\ntemperature_C,tde_x_dps,tde_y_dps,tde_z_dps\n"})
        QVERIFY2(exported->text.find(part) != std::string::npos, part);
    QCOMPARE(exported->notes.size(), std::size_t(1));
}

void TestExportTable::read_damagedTables_areRefused_data()
{
    Random random(3);
    const CompensationTable table = makeTable(random);
    const QString csv = QString::fromStdString(tableToCsv(table));
    const QString json = QString::fromStdString(tableToJson(table));
    const QString lastRow = csv.section(QLatin1Char('\n'), -2, -2);
    QTest::addColumn<QString>("text");
    QTest::addColumn<Errc>("code");
    QTest::newRow("empty") << QString() << Errc::ModelDamaged;
    QTest::newRow("other csv") << QStringLiteral("time_s,temperature_C\n1,2\n") << Errc::ModelDamaged;
    QTest::newRow("csv cut between rows") << csv.left(csv.size() - lastRow.size() - 1) << Errc::ModelDamaged;
    QTest::newRow("csv cut inside a row")
        << csv.left(csv.lastIndexOf(QLatin1Char(','))) << Errc::ModelDamaged;
    QTest::newRow("csv with text") << QString(csv).replace(lastRow, QStringLiteral("1,2,x,4"))
                                   << Errc::ModelDamaged;
    QTest::newRow("csv not finite") << QString(csv).replace(lastRow, QStringLiteral("1,2,nan,4"))
                                    << Errc::ModelDamaged;
    QTest::newRow("json cut") << json.left(json.size() / 2) << Errc::ModelDamaged;
    QTest::newRow("json of something else") << QStringLiteral("{\"format\": 3}") << Errc::ModelDamaged;
    QTest::newRow("json without a field")
        << QString(json).replace(QStringLiteral("\"judging\""), QStringLiteral("\"jugding\""))
        << Errc::ModelDamaged;
    QTest::newRow("json edited") << QString(json).replace(QStringLiteral("\"shift\": "),
                                                          QStringLiteral("\"shift\": 1"))
                                 << Errc::ModelEdited;
    QTest::newRow("json newer") << QString(json).replace(QStringLiteral("\"version\": 1"),
                                                         QStringLiteral("\"version\": 2"))
                                << Errc::ModelTooNew;
}

void TestExportTable::read_damagedTables_areRefused()
{
    QFETCH(QString, text);
    QFETCH(Errc, code);
    const auto read = readTable(text.toStdString(), "table.txt");
    QVERIFY(!read.ok());
    QCOMPARE(read.error().code, code);
    QVERIFY(read.error().message.find("table.txt") != std::string::npos);
}

static void write(const std::filesystem::path &path, const std::string &text)
{
    QFile file(QString::fromStdString(path.string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text.data(), static_cast<qint64>(text.size()));
}

// Compiles a C99 program, runs it on the input and gives what it printed; an empty array and a failed check
// if any of this goes wrong.
static QByteArray compileAndRun(const std::filesystem::path &source, const QByteArray &input)
{
    const QString program = QString::fromStdString(source.string()) + QStringLiteral(".out");
    QProcess compiler;
    compiler.start(QStringLiteral("cc"),
                   {QStringLiteral("-std=c99"), QStringLiteral("-Wall"), QStringLiteral("-Wextra"),
                    QStringLiteral("-Wpedantic"), QStringLiteral("-Werror"), QStringLiteral("-O1"),
                    QString::fromStdString(source.string()), QStringLiteral("-o"), program});
    if (!compiler.waitForFinished(60000) || compiler.exitCode() != 0) {
        qWarning("%s", compiler.readAllStandardError().constData());
        return {};
    }
    QProcess run;
    run.start(program, {});
    run.write(input);
    run.closeWriteChannel();
    return run.waitForFinished(60000) && run.exitCode() == 0 ? run.readAllStandardOutput() : QByteArray();
}

// Millidegrees come in as int32; six floats (tde, compensated) and three int32 (tde_q) go out for each.
constexpr const char *kDriver = R"(
#include "header.h"
#include <stdio.h>
int main(void)
{
    int32_t milli_c;
    while (fread(&milli_c, sizeof milli_c, 1, stdin) == 1) {
        const float rate[3] = {1.0f, -2.0f, 0.25f};
        float out[6];
        int32_t q[3];
        drift_tde_dps((float)milli_c / 1000.0f, out);
        drift_compensate((float)milli_c / 1000.0f, rate, out + 3);
        drift_tde_q(milli_c, q);
        fwrite(out, sizeof out, 1, stdout);
        fwrite(q, sizeof q, 1, stdout);
    }
    return 0;
}
)";

struct Answer
{
    float tde[3];
    float compensated[3];
    std::int32_t q[3];
};

void TestExportTable::cHeader_compiledAsC99_equalsApplyAndFixedPoint()
{
    Random random = announced(20261108);
    const std::filesystem::path folder = scratchFolder() / "c_header";
    std::filesystem::create_directories(folder);
    for (int i = 0; i < 3; ++i) {
        const TrainedModel model = randomModel(random);
        ExportOptions options;
        options.symbol = "drift";
        options.axes = std::array<bool, 3>{true, i != 1, true};
        const auto header = exportModel(model, ExportFormat::C, options);
        QVERIFY(header.ok());
        write(folder / "header.h", header->text);
        write(folder / "main.c", kDriver);

        const auto table = makeCompensationTable(model, *options.axes, options.table);
        std::vector<std::int32_t> milliC;
        for (std::int32_t t = table->firstMilliC - 2000; t <= table->lastMilliC + 2000; ++t)
            milliC.push_back(t);
        milliC.insert(milliC.end(), {INT32_MIN, INT32_MAX});
        const QByteArray output = compileAndRun(
            folder / "main.c", QByteArray(reinterpret_cast<const char *>(milliC.data()),
                                          static_cast<qsizetype>(milliC.size() * sizeof(milliC[0]))));
        QCOMPARE(static_cast<std::size_t>(output.size()), milliC.size() * sizeof(Answer));

        const TableApply<float> apply(*table);
        const FixedPointTable fixed = makeFixedPointTable(*table);
        Eigen::VectorXf temperatureC(static_cast<Eigen::Index>(milliC.size()));
        for (std::size_t k = 0; k < milliC.size(); ++k)
            temperatureC[static_cast<Eigen::Index>(k)] = static_cast<float>(milliC[k]) / 1000.0F;
        const Eigen::MatrixX3f expected = apply.tde(temperatureC);
        const std::array<float, 3> rate{1.0F, -2.0F, 0.25F};
        for (std::size_t k = 0; k < milliC.size(); ++k) {
            Answer answer;
            std::memcpy(&answer, output.data() + k * sizeof(Answer), sizeof(Answer));
            const auto units = tdeUnits(fixed, milliC[k]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float tde = expected(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(axis));
                QVERIFY(answer.tde[axis] == tde);
                QVERIFY(answer.compensated[axis] == rate[axis] - tde);
                QVERIFY(answer.q[axis] == units[axis]);
            }
        }
    }
}

void TestExportTable::cHeader_hostileTexts_stayInTheComment()
{
    Random random(5);
    TrainedModel model = randomCubic(random);
    model.sensor.serial = "*/ int main(void) { return 1; } /*";
    model.trainedOn = {"run\n*/\n#error broken\n", "ends with \\", "what?\?/", "a**//b"};
    const auto header = exportModel(model, ExportFormat::C, {.symbol = "drift"});
    QVERIFY(header.ok());
    const std::filesystem::path folder = scratchFolder() / "c_hostile";
    std::filesystem::create_directories(folder);
    write(folder / "header.h", header->text);
    write(folder / "main.c", kDriver);
    const std::int32_t milliC = 0;
    const QByteArray output =
        compileAndRun(folder / "main.c", QByteArray(reinterpret_cast<const char *>(&milliC), sizeof(milliC)));
    QCOMPARE(static_cast<std::size_t>(output.size()), sizeof(Answer));
}

void TestExportTable::cHeader_badSymbol_isRefused()
{
    Random random(6);
    const TrainedModel model = randomCubic(random);
    for (const std::string &symbol : {std::string(), std::string("9lives"), std::string("a-b"),
                                      std::string("_x"), std::string(60, 'a')}) {
        const auto exported = exportModel(model, ExportFormat::C, {.symbol = symbol});
        QVERIFY(!exported.ok());
        QCOMPARE(exported.error().code, Errc::InvalidOption);
    }
}

void TestExportTable::exportModel_sameModel_givesSameBytes()
{
    for (const ExportFormat format : {ExportFormat::Csv, ExportFormat::Json, ExportFormat::C,
                                      ExportFormat::Px4, ExportFormat::ArduPilot}) {
        Random first(77);
        Random second(77);
        const auto a = exportModel(randomRbf(first), format);
        const auto b = exportModel(randomRbf(second), format);
        QVERIFY2(a.ok(), a.ok() ? "" : a.error().message.c_str());
        QVERIFY(!a->text.empty());
        QCOMPARE(a->text, b->text);
        QCOMPARE(exportFormatFromName(exportFormatName(format)), std::optional(format));
    }
}

void TestExportTable::exportModel_axisWithoutYes_needsForce()
{
    Random random(7);
    TrainedModel model = randomCubic(random);
    model.verdicts = {Verdict::WithCare, Verdict::NotRepeatable, Verdict::NoDrift};
    for (const ExportFormat format : {ExportFormat::Csv, ExportFormat::Json, ExportFormat::C,
                                      ExportFormat::Px4, ExportFormat::ArduPilot}) {
        const auto refused = exportModel(model, format);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().code, Errc::VerdictForbids);
        QVERIFY(exportModel(model, format, {.force = true}).ok());
    }
}

void TestExportTable::exportModelToFile_unwritable_isAnError()
{
    Random random(8);
    const TrainedModel model = randomCubic(random);
    const std::filesystem::path folder = scratchFolder();
    const auto written = exportModelToFile(model, ExportFormat::Csv, {}, folder / "table.csv");
    QVERIFY(written.ok());
    QFile file(QString::fromStdString((folder / "table.csv").string()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().toStdString(), exportModel(model, ExportFormat::Csv)->text);
    const auto refused =
        exportModelToFile(model, ExportFormat::Csv, {}, folder / "no such folder" / "table.csv");
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().code, Errc::OutputNotWritable);
}

QTEST_APPLESS_MAIN(TestExportTable)
#include "tst_export_table.moc"
