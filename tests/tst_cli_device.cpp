// The `device` commands on the simulated bridge, whose flash file lasts from one command to the next.
#include "engine/models/model_file.h"
#include "support/cli_process.h"
#include "support/models_for_export.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace driftbench;
using namespace driftbench::test;

class TestCliDevice : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();

    void info_freshDevice_hasNoTable();
    void upload_model_isInUseForTheNextCommand();
    void upload_secondModel_rollbackBringsTheFirstBack();
    void upload_withoutActivation_leavesItCommitted();
    void upload_otherSensor_isRefusedAndNothingWritten();
    void upload_noVerdict_needsForce();
    void configure_rateAndRange_areShown();
    void command_badInput_saysWhichInOneSentence_data();
    void command_badInput_saysWhichInOneSentence();
    void readTable_out_isTheImage();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    Outcome device(const QStringList &arguments, const QString &flash = "bridge.bin") const
    {
        return runCli(QStringList{"device"} + arguments + QStringList{"--flash", path(flash)});
    }
    void write(const QString &name, std::uint64_t seed, const SensorIdentity &sensor,
               Verdict verdict = Verdict::Yes) const;

    QTemporaryDir m_folder;
};

namespace {

using Json = nlohmann::json;

Json parsed(const Outcome &outcome)
{
    return Json::parse(outcome.output.toStdString());
}

} // namespace

void TestCliDevice::write(const QString &name, std::uint64_t seed, const SensorIdentity &sensor,
                          Verdict verdict) const
{
    Random random(seed);
    TrainedModel model = randomCubic(random);
    model.sensor = sensor;
    model.verdicts = {verdict, verdict, verdict};
    QVERIFY(saveModel(model, path(name).toStdString()).ok());
}

void TestCliDevice::initTestCase()
{
    QVERIFY(m_folder.isValid());
    write("first.json", 1, {"I3G4250D", "SIM-0001"});
    write("second.json", 2, {"I3G4250D", "SIM-0001"});
    write("other.json", 3, {"I3G4250D", "SIM-0002"});
    write("unsure.json", 4, {"I3G4250D", "SIM-0001"}, Verdict::NotRepeatable);
}

void TestCliDevice::info_freshDevice_hasNoTable()
{
    const Outcome text = device({"info"}, "fresh.bin");
    QCOMPARE(text.exitCode, 0);
    QVERIFY(text.output.contains("I3G4250D SIM-0001") && text.output.contains("bank 0       empty"));
    const Json json = parsed(device({"info", "--json"}, "fresh.bin"));
    QCOMPARE(json["sensor"]["serial"].get<std::string>(), std::string("SIM-0001"));
    QCOMPARE(json["ranges"][0]["mdps_per_count"].get<double>(), 8.75);
    QVERIFY(!json["config"]["compensating"].get<bool>());
}

void TestCliDevice::upload_model_isInUseForTheNextCommand()
{
    const Outcome upload = device({"upload", "--model", path("first.json")}, "one.bin");
    QVERIFY2(upload.exitCode == 0, upload.errors.constData());
    QVERIFY(upload.output.contains("is in use now") && upload.output.contains("all equal"));
    const Json banks = parsed(device({"info", "--json"}, "one.bin"))["banks"];
    QCOMPARE(int(banks[0]["in_use"].get<bool>()) + int(banks[1]["in_use"].get<bool>()), 1);
    const Outcome read = device({"read-table"}, "one.bin");
    QCOMPARE(read.exitCode, 0);
    QVERIFY(read.output.contains("fixed point") && read.output.contains("x, y, z"));
}

void TestCliDevice::upload_secondModel_rollbackBringsTheFirstBack()
{
    const Json first = parsed(device({"upload", "--json", "--model", path("first.json")}, "two.bin"));
    const Json second =
        parsed(device({"upload", "--json", "--kind", "float", "--model", path("second.json")}, "two.bin"));
    QVERIFY(second["activated"].get<bool>() && second["generation"] > first["generation"]);
    for (const Json &check : {first["check"], second["check"]}) {
        QVERIFY(check["passed"].get<bool>() && check["samples"].get<int>() >= check["wanted"].get<int>());
        QCOMPARE(check["worst_counts"].get<int>(), 0);
    }
    QVERIFY(!second["rolled_back"].get<bool>());
    const Json rollback = parsed(device({"rollback", "--json"}, "two.bin"));
    const auto bank = first["bank"].get<std::size_t>();
    QVERIFY(rollback["after"][bank]["in_use"].get<bool>());
    QCOMPARE(rollback["after"][bank]["crc32"].get<std::string>(), first["crc32"].get<std::string>());
    QCOMPARE(device({"rollback"}, "two.bin").exitCode, 0);
    const Outcome nothing = device({"rollback"}, "two.bin");
    QCOMPARE(nothing.exitCode, static_cast<int>(Errc::DeviceRefused));
    QVERIFY(isOneSentence(nothing.errors));
}

void TestCliDevice::upload_withoutActivation_leavesItCommitted()
{
    const Json upload =
        parsed(device({"upload", "--json", "--no-activate", "--model", path("first.json")}, "three.bin"));
    QVERIFY(!upload["activated"].get<bool>());
    const Json info = parsed(device({"info", "--json"}, "three.bin"));
    QCOMPARE(info["banks"][upload["bank"].get<std::size_t>()]["state"].get<std::string>(),
             std::string("committed"));
}

void TestCliDevice::upload_otherSensor_isRefusedAndNothingWritten()
{
    const Outcome upload = device({"upload", "--model", path("other.json")}, "four.bin");
    QCOMPARE(upload.exitCode, static_cast<int>(Errc::WrongSensor));
    QVERIFY(isOneSentence(upload.errors) && upload.errors.contains("SIM-0002"));
    QVERIFY(device({"info"}, "four.bin").output.contains("bank 0       empty"));
}

void TestCliDevice::upload_noVerdict_needsForce()
{
    QCOMPARE(device({"upload", "--model", path("unsure.json")}, "five.bin").exitCode,
             static_cast<int>(Errc::VerdictForbids));
    QCOMPARE(device({"upload", "--force", "--model", path("unsure.json")}, "five.bin").exitCode, 0);
}

void TestCliDevice::configure_rateAndRange_areShown()
{
    const Json json = parsed(device({"configure", "--rate", "1000", "--range", "490", "--json"}));
    QCOMPARE(json["config"]["rate_hz"].get<double>(), 1000.0);
    QCOMPARE(json["config"]["range"].get<int>(), 1);
}

void TestCliDevice::command_badInput_saysWhichInOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    const int option = static_cast<int>(Errc::InvalidOption);
    QTest::newRow("device") << QStringList{"info", "--device", "toaster"} << option;
    QTest::newRow("sensor") << QStringList{"info", "--sensor", "X1"} << option;
    QTest::newRow("serial") << QStringList{"info", "--device", "hid:NOT-THERE"}
                            << static_cast<int>(Errc::DeviceNotFound);
    QTest::newRow("rate") << QStringList{"configure", "--rate", "0"} << option;
    QTest::newRow("rate nan") << QStringList{"configure", "--rate", "nan"} << option;
    QTest::newRow("range") << QStringList{"configure", "--range", "7"} << option;
    QTest::newRow("bank") << QStringList{"read-table", "--bank", "2"} << option;
    QTest::newRow("no table") << QStringList{"read-table"} << static_cast<int>(Errc::DeviceRefused);
    QTest::newRow("kind") << QStringList{"upload", "--kind", "octal", "--model", "x"} << option;
    QTest::newRow("model") << QStringList{"upload", "--model", "/no/such.json"}
                           << static_cast<int>(Errc::FileNotFound);
    QTest::newRow("no part") << QStringList{} << 2;
}

void TestCliDevice::command_badInput_saysWhichInOneSentence()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    const Outcome outcome = arguments.isEmpty() ? runCli({"device"}) : device(arguments, "bad.bin");
    QVERIFY2(outcome.exitCode == exitCode, outcome.errors.constData());
    QVERIFY2(isOneSentence(outcome.errors), outcome.errors.constData());
}

void TestCliDevice::readTable_out_isTheImage()
{
    const Json upload = parsed(device({"upload", "--json", "--model", path("second.json")}, "six.bin"));
    QCOMPARE(device({"read-table", "--out", path("table.bin")}, "six.bin").exitCode, 0);
    const QByteArray image = bytesOf(path("table.bin"));
    QCOMPARE(image.size(), qsizetype(upload["bytes"].get<int>()));
    QVERIFY(image.startsWith("DTB1"));
}

QTEST_APPLESS_MAIN(TestCliDevice)
#include "tst_cli_device.moc"
