#include "engine/formats/log_reader.h"
#include "engine/models/model_file.h"
#include "support/cli_process.h"
#include "support/test_data.h"

#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

// What a user does with the models of a fit: apply, evaluate, export.
class TestCliApplyExport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void apply_simulatedRun_isMeasuredMinusModel();
    void apply_json_countsTheSamples();
    void apply_partlyOutsideTheRange_saysSoAndHoldsTheEdge();
    void apply_whollyOutsideByForce_holdsTheEdge();
    void apply_otherSensorByForce_goesOn();
    void apply_dataflash_writesTheDefaultColumns();

    void evaluate_heldOutModel_isTheComparison_data();
    void evaluate_heldOutModel_isTheComparison();
    void evaluate_runTheModelWasTrainedOn_saysSo();
    void evaluate_text_namesEveryRunAndAxis();

    void export_everyFormat_ofEveryAxis_data();
    void export_everyFormat_ofEveryAxis();
    void export_json_listsItsNotes();
    void export_chamber_isOfYOnlyUnlessForced_data();
    void export_chamber_isOfYOnlyUnlessForced();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    bool fitChamber(const std::filesystem::path &first) const;

    QTemporaryDir m_folder;
};

namespace {

using Json = nlohmann::json;

// The last three fields of a row.
Eigen::Vector3d compensatedDps(const QByteArray &line)
{
    const QList<QByteArray> fields = line.split(',');
    Eigen::Vector3d rateDps;
    for (int axis = 0; axis < 3; ++axis)
        rateDps[axis] = fields[fields.size() - 3 + axis].toDouble();
    return rateDps;
}

// Whether out is in with three more columns: what the model leaves of the rates.
bool isCompensated(const QString &out, const QString &in, const QString &modelFile)
{
    const TrainedModel model = loadModel(modelFile.toStdString()).value();
    const Recording recording = readLog(in.toStdString(), {}).value();
    const Eigen::MatrixX3d expected =
        recording.rateDps - predictAtTemperature(model, recording.temperatureC).tdeDps;
    const QList<QByteArray> before = bytesOf(in).split('\n');
    const QList<QByteArray> after = bytesOf(out).split('\n');
    if (after.size() != before.size() || after[0] != before[0] + ",comp_x_dps,comp_y_dps,comp_z_dps")
        return false;
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (!after[i + 1].startsWith(before[i + 1] + ','))
            return false;
        if ((compensatedDps(after[i + 1]) - expected.row(i).transpose()).cwiseAbs().maxCoeff() > 1e-12)
            return false;
    }
    return true;
}

bool same(const Json &a, const Json &b)
{
    if (a.is_null() || b.is_null())
        return a == b;
    return std::abs(a.get<double>() - b.get<double>()) <= 1e-9 * std::max(1.0, std::abs(b.get<double>()));
}

} // namespace

void TestCliApplyExport::initTestCase()
{
    QVERIFY(m_folder.isValid());
    simulateQuietly(m_folder.path(), {"--runs", "4"});
    const Outcome fitted = runCli({"fit", path("run1.csv"), path("run2.csv"), path("run3.csv"), "--models",
                                   "constant,linear,cubic,rbf", "--out", path("fit")});
    QVERIFY2(fitted.exitCode == 0, fitted.errors.constData());
}

bool TestCliApplyExport::fitChamber(const std::filesystem::path &first) const
{
    if (QFile::exists(path("chamber")))
        return true;
    QStringList arguments{"fit", "--models", "constant,linear,cubic,rbf", "--out", path("chamber")};
    for (const char *name : {"run1_cooling.csv", "run2_heating.csv", "run3_cooling.csv"})
        arguments.append(QString::fromStdString((first.parent_path() / name).string()));
    return runCli(arguments).exitCode == 0;
}

void TestCliApplyExport::apply_simulatedRun_isMeasuredMinusModel()
{
    for (const QString &name : {QString("linear"), QString("rbf"), QString("auto")}) {
        const QString model = path("fit/models/" + name + ".json");
        const QString out = path(name + ".csv");
        const Outcome outcome = runCli({"apply", "--model", model, path("run2.csv"), out});
        QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
        QCOMPARE(outcome.output, out.toUtf8() + "  3700 samples\n");
        QVERIFY(isCompensated(out, path("run2.csv"), model));
    }
}

void TestCliApplyExport::apply_json_countsTheSamples()
{
    const Outcome outcome = runCli(
        {"apply", "--model", path("fit/models/rbf.json"), path("run1.csv"), path("json.csv"), "--json"});
    const Json json = Json::parse(outcome.output.toStdString());
    QCOMPARE(json["samples"].get<int>(), 3700);
    QCOMPARE(json["outside_trained_range"].get<int>(), 0);
    QCOMPARE(json["out"].get<std::string>(), path("json.csv").toStdString());
}

void TestCliApplyExport::apply_partlyOutsideTheRange_saysSoAndHoldsTheEdge()
{
    const QString model = path("fit/models/rbf.json");
    writeBytes(path("range.csv"), "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps\n"
                                  "0,20,1,2,3\n1,150,1,2,3\n2,500,1,2,3\n3,-90,1,2,3\n");
    const Outcome outcome = runCli({"apply", "--model", model, path("range.csv"), path("edge.csv")});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(isOneSentence(outcome.errors) && outcome.errors.contains("3 of 4 samples"),
             outcome.errors.constData());
    const QList<QByteArray> lines = bytesOf(path("edge.csv")).split('\n');
    QVERIFY(compensatedDps(lines[2]) == compensatedDps(lines[3]));
    QVERIFY(compensatedDps(lines[2]) != compensatedDps(lines[4]));
}

void TestCliApplyExport::apply_whollyOutsideByForce_holdsTheEdge()
{
    const QString model = path("fit/models/cubic.json");
    writeBytes(path("hot.csv"),
               "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps\n0,150,1,2,3\n1,151,1,2,3\n");
    const Outcome outcome =
        runCli({"apply", "--model", model, path("hot.csv"), path("hot_compensated.csv"), "--force"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.errors.contains("2 of 2 samples"));
    QVERIFY(isCompensated(path("hot_compensated.csv"), path("hot.csv"), model));
}

void TestCliApplyExport::apply_otherSensorByForce_goesOn()
{
    const QString model = path("fit/models/linear.json");
    writeBytes(path("other.csv"), bytesOf(path("run1.csv")));
    const QStringList arguments{
        "apply", "--model", model, path("other.csv"), path("other_compensated.csv"), "--sensor", "L3GD20H"};
    QCOMPARE(runCli(arguments).exitCode, static_cast<int>(Errc::ModelOfAnotherSensor));
    QVERIFY(!QFile::exists(path("other_compensated.csv")));
    QCOMPARE(runCli(arguments + QStringList{"--force"}).exitCode, 0);
    QVERIFY(isCompensated(path("other_compensated.csv"), path("other.csv"), model));
}

void TestCliApplyExport::apply_dataflash_writesTheDefaultColumns()
{
    REQUIRE_SHARED_DATA(log, "dataflash_warmup/log171.bin");
    const QString model = path("fit/models/linear.json");
    const Outcome outcome = runCli({"apply", "--model", model, QString::fromStdString(log.string()),
                                    path("flight.csv"), "--instance", "2"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    const Recording written = readLog(path("flight.csv").toStdString(), {}).value();
    ReadOptions third;
    third.instance = 2;
    const Recording recording = readLog(log, third).value();
    QVERIFY(written.timeS == recording.timeS && written.rateDps == recording.rateDps);
    const Eigen::MatrixX3d tdeDps =
        predictAtTemperature(loadModel(model.toStdString()).value(), recording.temperatureC).tdeDps;
    const QList<QByteArray> lines = bytesOf(path("flight.csv")).split('\n');
    for (const Eigen::Index i : {Eigen::Index{0}, recording.size() / 2, recording.size() - 1}) {
        const Eigen::Vector3d expected = (recording.rateDps.row(i) - tdeDps.row(i)).transpose();
        QVERIFY((compensatedDps(lines[i + 1]) - expected).norm() < 1e-12);
    }
}

void TestCliApplyExport::evaluate_heldOutModel_isTheComparison_data()
{
    QTest::addColumn<QString>("judging");
    QTest::newRow("absolute") << "absolute";
    QTest::newRow("anchored") << "anchored";
}

void TestCliApplyExport::evaluate_heldOutModel_isTheComparison()
{
    QFETCH(const QString, judging);
    const QString folder = path("fit " + judging);
    QCOMPARE(runCli({"fit", path("run1.csv"), path("run2.csv"), path("run3.csv"), "--models",
                     "constant,cubic,rbf", "--judge", judging, "--out", folder})
                 .exitCode,
             0);
    const Json comparison = Json::parse(bytesOf(folder + "/comparison.json").toStdString());
    int compared = 0;
    for (const QString &run : {QString("run1"), QString("run3")}) {
        for (const QString &model : {QString("cubic"), QString("rbf")}) {
            const Outcome outcome =
                runCli({"evaluate", "--model", folder + "/held-out/" + run + "/" + model + ".json",
                        path(run + ".csv"), "--judge", judging, "--json"});
            QVERIFY2(outcome.exitCode == 0 && outcome.errors.isEmpty(), outcome.errors.constData());
            const Json evaluated = Json::parse(outcome.output.toStdString());
            QCOMPARE(evaluated["rows"].size(), std::size_t{3});
            for (const auto &row : evaluated["rows"]) {
                for (const auto &expected : comparison["rows"]) {
                    if (expected["run"] != row["run"] || expected["axis"] != row["axis"] ||
                        expected["model"] != row["model"])
                        continue;
                    for (const char *key : {"msd_before", "msd_after", "q", "noise_floor",
                                            "excess_over_floor", "rms10s_dps", "rms_dps"})
                        QVERIFY2(same(row[key], expected[key]),
                                 (std::string(key) + row[key].dump() + " " + expected[key].dump()).c_str());
                    QVERIFY(row["samples"] == expected["samples"]);
                    QVERIFY(row["trained_on"] == expected["trained_on"]);
                    ++compared;
                }
            }
        }
    }
    QCOMPARE(compared, 12);
}

void TestCliApplyExport::evaluate_runTheModelWasTrainedOn_saysSo()
{
    const QString model = path("fit/models/rbf.json");
    const Outcome trained = runCli({"evaluate", "--model", model, path("run1.csv")});
    QCOMPARE(trained.exitCode, 0);
    QVERIFY(isOneSentence(trained.errors) && trained.errors.contains("trained on a run named run1"));
    const Outcome unseen = runCli({"evaluate", "--model", model, path("run4.csv")});
    QCOMPARE(unseen.exitCode, 0);
    QVERIFY(!unseen.errors.contains("trained on a run"));
}

void TestCliApplyExport::evaluate_text_namesEveryRunAndAxis()
{
    const Outcome outcome =
        runCli({"evaluate", "--model", path("fit/models/auto.json"), path("run4.csv"), path("run2.csv")});
    QCOMPARE(outcome.exitCode, 0);
    const QList<QByteArray> lines = outcome.output.split('\n');
    QCOMPARE(lines.size(), 1 + 6 + 1);
    QVERIFY(lines[1].startsWith("run4 ") && lines[6].startsWith("run2 "));
    // The noise that the simulator is told by default is what is left.
    for (int i = 1; i <= 6; ++i) {
        const double leftDps = lines[i].simplified().split(' ')[6].toDouble();
        QVERIFY2(std::abs(leftDps - 0.14) < 0.01, lines[i].constData());
    }
}

void TestCliApplyExport::export_everyFormat_ofEveryAxis_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("holds");
    QTest::newRow("csv") << QStringList() << QByteArray("temperature_C");
    QTest::newRow("json") << QStringList() << QByteArray("\"simulated\": true");
    QTest::newRow("c") << QStringList{"--symbol", "mine"} << QByteArray("mine_");
    QTest::newRow("px4") << QStringList{"--device-id", "4325"} << QByteArray("TC_G0_ID");
    QTest::newRow("ardupilot") << QStringList{"--gyro", "2"} << QByteArray("INS_TCAL2_");
}

void TestCliApplyExport::export_everyFormat_ofEveryAxis()
{
    QFETCH(const QStringList, options);
    QFETCH(const QByteArray, holds);
    const QString format = QTest::currentDataTag();
    const QString out = path("table." + format);
    const QStringList arguments =
        QStringList{"export", "--model", path("fit/models/auto.json"), "--format", format, "--out", out} +
        options;
    const Outcome outcome = runCli(arguments);
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QCOMPARE(outcome.output, out.toUtf8() + '\n');
    const QByteArray exported = bytesOf(out);
    QVERIFY2(exported.contains(holds), exported.left(2000).constData());
    QVERIFY(!outcome.errors.contains("Not compensated"));
    QCOMPARE(runCli(arguments).exitCode, 0);
    QCOMPARE(bytesOf(out), exported);
    const Outcome some = runCli(arguments + QStringList{"--axes", "x,z"});
    QCOMPARE(some.exitCode, 0);
    QVERIFY(some.errors.contains("Not compensated: y (yes"));
    QVERIFY(bytesOf(out) != exported);
}

void TestCliApplyExport::export_json_listsItsNotes()
{
    const Outcome outcome = runCli({"export", "--model", path("fit/models/auto.json"), "--format", "csv",
                                    "--axes", "y", "--out", path("y.csv"), "--json"});
    QCOMPARE(outcome.exitCode, 0);
    const Json json = Json::parse(outcome.output.toStdString());
    QCOMPARE(json["format"].get<std::string>(), std::string("csv"));
    QVERIFY(json["notes"].dump().find("Not compensated: x") != std::string::npos);
}

void TestCliApplyExport::export_chamber_isOfYOnlyUnlessForced_data()
{
    QTest::addColumn<QStringList>("options");
    for (const char *format : {"csv", "json", "c", "ardupilot"})
        QTest::newRow(format) << QStringList();
    QTest::newRow("px4") << QStringList{"--device-id", "4325"};
}

void TestCliApplyExport::export_chamber_isOfYOnlyUnlessForced()
{
    QFETCH(const QStringList, options);
    REQUIRE_SHARED_DATA(first, "climate_chamber/run1_cooling.csv");
    QVERIFY(fitChamber(first));
    const QString out = path(QString("chamber.") + QTest::currentDataTag());
    const QStringList arguments =
        QStringList{
            "export", "--model", path("chamber/models/auto.json"), "--format", QTest::currentDataTag(),
            "--out",  out} +
        options;
    const Outcome asked = runCli(arguments + QStringList{"--axes", "x,y"});
    QCOMPARE(asked.exitCode, static_cast<int>(Errc::VerdictForbids));
    QVERIFY2(isOneSentence(asked.errors) && asked.errors.contains("x (not repeatable"),
             asked.errors.constData());
    QVERIFY(!QFile::exists(out));

    const Outcome plain = runCli(arguments);
    QVERIFY2(plain.exitCode == 0, plain.errors.constData());
    QVERIFY(plain.errors.contains("Not compensated: x (not repeatable") &&
            plain.errors.contains("z (not repeatable"));
    const QByteArray ofY = bytesOf(out);

    const Outcome forced = runCli(arguments + QStringList{"--force"});
    QCOMPARE(forced.exitCode, 0);
    QVERIFY(forced.errors.contains("Compensated by force: x (not repeatable"));
    QVERIFY(!forced.errors.contains("Not compensated"));
    QVERIFY(bytesOf(out) != ofY);
}

QTEST_GUILESS_MAIN(TestCliApplyExport)
#include "tst_cli_apply_export.moc"
