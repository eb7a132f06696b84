#include "support/cli_process.h"
#include "support/test_data.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace driftbench::test;

// driftbench-cli physics, and the plots that it has drawn.
class TestCliPhysics : public QObject
{
    Q_OBJECT

private slots:
    void physics_defaults_printsTableSensitivitiesAndQuantities();
    void physics_json_addsUp();
    void physics_asPrinted_showsTheFactor();
    void physics_rangeIntoContact_goesUpToItAndSaysSo();
    void physics_out_writesTableAndPlots();
    void physics_noDisplacement_hasNothingToExplain();
    void physics_badValue_isOneSentence_data();
    void physics_badValue_isOneSentence();
    void report_damagedPhysics_isRefused();
};

static QJsonObject jsonOf(const QByteArray &text)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError)
        qFatal("not JSON: %s", qPrintable(error.errorString()));
    return document.object();
}

void TestCliPhysics::physics_defaults_printsTableSensitivitiesAndQuantities()
{
    const Outcome outcome = runCli({"physics"});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.errors, QByteArray());
    for (const char *expected : {"Contact of the combs at", "ΔC′ fF", "Sensitivity of ΔE at 85.00 °C",
                                 "elastic modulus", "ΔT, ΔT², √ΔT", "ΔT, ΔT², ΔT³"})
        QVERIFY2(outcome.output.contains(expected), expected);
}

void TestCliPhysics::physics_json_addsUp()
{
    const Outcome outcome = runCli({"physics", "--json", "--from", "-100", "--to", "150", "--step", "25"});
    QCOMPARE(outcome.exitCode, 0);
    const QJsonObject physics = jsonOf(outcome.output);
    const QJsonArray rows = physics["rows"].toArray();
    QCOMPARE(rows.size(), 11);
    for (const QJsonValue &value : rows) {
        const QJsonObject row = value.toObject();
        QCOMPARE(row["delta_T_C"].toDouble(), row["temperature_C"].toDouble() - 25.0);
        QVERIFY(std::abs(row["change_fF"].toDouble() - row["rest_change_fF"].toDouble() -
                         row["error_fF"].toDouble()) < 1e-13);
        QCOMPARE(row["rate_dps"].toDouble(),
                 row["error_fF"].toDouble() / physics["scale_factor_fF_per_dps"].toDouble());
        QCOMPARE(row["printed_change_fF_um"].isNull(), row["delta_T_C"].toDouble() <= 0.0);
    }
    // Of the contact: 25 + (2 - 0.1) x 4 / (12 x 2.4e-6 x 8^2)
    QVERIFY(std::abs(physics["contact_C"].toDouble() - (25.0 + 7.6 / 0.0018432)) < 1e-8);
    QCOMPARE(physics["sensitivities"].toObject()["parameters"].toArray().size(), 10);
    const QJsonArray quantities = physics["quantities"].toArray();
    QCOMPARE(quantities.size(), 4);
    QVERIFY(quantities[3].toObject()["rms_fF"].toDouble() < quantities[2].toObject()["rms_fF"].toDouble());
}

void TestCliPhysics::physics_asPrinted_showsTheFactor()
{
    const Outcome outcome = runCli({"physics", "--as-printed", "--from", "24", "--to", "50", "--step", "1"});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.output.count(" 0.500000000"), 25);
    QVERIFY(outcome.output.contains("half of the right prefactor"));
}

void TestCliPhysics::physics_rangeIntoContact_goesUpToItAndSaysSo()
{
    const QStringList touching{"physics", "--length", "100", "--displacement", "0.2"};
    const Outcome outcome = runCli(touching);
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.output.contains("The combs touch at 50.000 °C; the range beyond has no capacitance."));
    QVERIFY(outcome.output.contains("thinner than nothing"));
    QVERIFY(!runCli({"physics"}).output.contains("thinner than nothing"));
    const QJsonObject physics = jsonOf(runCli(touching + QStringList{"--json"}).output);
    QVERIFY(physics["ends_at_contact"].toBool());
    QCOMPARE(physics["rows"].toArray().last().toObject()["temperature_C"].toDouble(), 45.0);

    const Outcome beyond = runCli(touching + QStringList{"--from", "60"});
    QCOMPARE(beyond.exitCode, 60);
    QVERIFY2(isOneSentence(beyond.errors) && beyond.errors.contains("touch at 50"), beyond.errors);
}

void TestCliPhysics::physics_out_writesTableAndPlots()
{
    const QTemporaryDir folder;
    const QString out = folder.filePath("combs");
    const Outcome outcome = runCli({"physics", "--out", out, "--csv", folder.filePath("table.csv")});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(outcome.errors.isEmpty(), outcome.errors);
    QVERIFY(outcome.output.contains("plots/index.html"));
    QCOMPARE(filesIn(out), (QStringList{"physics.csv", "physics.json", "plots"}));
    const QByteArray table = bytesOf(out + "/physics.csv");
    QVERIFY(table.startsWith("temperature_C,delta_T_C,rest_change_fF,change_fF,error_fF,rate_dps\n-40,-65,"));
    QCOMPARE(table.count('\n'), 27);
    QCOMPARE(bytesOf(folder.filePath("table.csv")), table);
    const QStringList plots = filesIn(out + "/plots");
    for (const char *figure : {"capacitance_error", "gap_profile", "quantities_residual"}) {
        for (const char *ending : {".svg", ".pdf", ".png"})
            QVERIFY2(plots.contains(QString(figure) + ending), figure);
    }
    QVERIFY(bytesOf(out + "/plots/index.html").contains("gap_profile.svg"));
    QVERIFY(bytesOf(out + "/plots/quantities_residual.svg").contains("Residual (aF)"));
}

void TestCliPhysics::physics_noDisplacement_hasNothingToExplain()
{
    const QTemporaryDir folder;
    const Outcome outcome = runCli({"physics", "--displacement", "0", "--out", folder.path()});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(outcome.errors.isEmpty(), outcome.errors);
    QVERIFY(outcome.output.contains("there is nothing to explain"));
    QVERIFY(!filesIn(folder.filePath("plots")).contains("quantities_residual.svg"));
}

void TestCliPhysics::physics_badValue_isOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("named");
    QTest::newRow("thickness") << QStringList{"--thickness", "-4"} << "thickness a0 is -4 µm";
    QTest::newRow("gap") << QStringList{"--gap", "0"} << "gap d0 is 0 µm";
    QTest::newRow("gaps") << QStringList{"--gaps", "0"} << "number of gaps is 0";
    QTest::newRow("poisson") << QStringList{"--poisson", "0.7"} << "Poisson ratio is 0.7";
    QTest::newRow("expansion") << QStringList{"--expansion", "nan"} << "expansion coefficient";
    QTest::newRow("straight") << QStringList{"--straight-at", "-300"} << "absolute zero";
    QTest::newRow("from") << QStringList{"--from", "-300"} << "absolute zero";
    QTest::newRow("range") << QStringList{"--from", "90"} << "from 90 to 85 °C";
    QTest::newRow("step") << QStringList{"--step", "0"} << "step of temperature is 0 °C";
    QTest::newRow("displacement") << QStringList{"--displacement", "2"} << "less than the gap";
    QTest::newRow("per dps") << QStringList{"--displacement-per-dps", "0"} << "displacement per dps is 0";
}

void TestCliPhysics::physics_badValue_isOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, named);
    const QTemporaryDir folder;
    const QString out = folder.filePath("combs");
    const Outcome outcome = runCli(QStringList{"physics", "--out", out} + arguments);
    QCOMPARE(outcome.exitCode, 60);
    QVERIFY2(isOneSentence(outcome.errors) && outcome.errors.contains(named.toUtf8()), outcome.errors);
    QVERIFY(filesIn(folder.path()).isEmpty());
}

void TestCliPhysics::report_damagedPhysics_isRefused()
{
    const QTemporaryDir folder;
    for (const char *text : {"{", "{}", R"({"combs": 3})"}) {
        writeBytes(folder.filePath("physics.json"), text);
        QProcess process;
        process.start(driftbench::test::programFolder() + "/driftbench-report",
                      {folder.path(), "--out", folder.filePath("plots")});
        const Outcome outcome = finish(process);
        QCOMPARE(outcome.exitCode, 40);
        QVERIFY2(outcome.errors.contains("physics.json is damaged"), outcome.errors);
    }
}

QTEST_APPLESS_MAIN(TestCliPhysics)
#include "tst_cli_physics.moc"
