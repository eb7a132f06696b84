// `devices`: the simulated bridge is always there, in words and as JSON.
#include "device/source_choice.h"
#include "support/cli_process.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace driftbench;
using namespace driftbench::test;

class TestCliDevices : public QObject
{
    Q_OBJECT

private slots:
    void devices_always_listTheSimulatedBridgeFirst();
    void devices_json_isForMachines();
    void devices_badId_isOneSentence();
};

void TestCliDevices::devices_always_listTheSimulatedBridgeFirst()
{
    const Outcome outcome = runCli({"devices"});
    QCOMPARE(outcome.exitCode, 0);
    const QList<QByteArray> lines = outcome.output.split('\n');
    QVERIFY(lines[0].contains("source") && lines[0].contains("status"));
    QVERIFY2(lines[1].startsWith("  simulated  simulated bridge"), lines[1].constData());
    QVERIFY(lines[1].contains("ready"));
}

void TestCliDevices::devices_json_isForMachines()
{
    const Outcome outcome = runCli({"devices", "--json", "--usb-id", "dead:beef"});
    QCOMPARE(outcome.exitCode, 0);
    const auto devices = nlohmann::json::parse(outcome.output.toStdString())["devices"];
    QVERIFY(!devices.empty());
    QCOMPARE(devices[0]["source"].get<std::string>(), std::string("simulated"));
    QVERIFY(devices[0]["usable"].get<bool>());
    QCOMPARE(devices[0]["code"].get<int>(), 0);
    for (const auto &device : devices)
        QVERIFY(device["sentence"].get<std::string>().ends_with('.'));
}

void TestCliDevices::devices_badId_isOneSentence()
{
    const Outcome outcome = runCli({"devices", "--usb-id", "1209"});
    QCOMPARE(outcome.exitCode, static_cast<int>(Errc::InvalidOption));
    QVERIFY(isOneSentence(outcome.errors));
}

QTEST_APPLESS_MAIN(TestCliDevices)
#include "tst_cli_devices.moc"
