// What can be known of hidapi and the udev rule without a device: paths that can't be opened, and what is in
// the rule.
#include "device/bridge/bridge_protocol.h"
#include "device/hidapi_transport.h"
#include "device/node_holders.h"
#include "device/udev_rule.h"
#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace driftbench;
using namespace driftbench::test;
namespace fs = std::filesystem;

class TestDeviceHidapi : public QObject
{
    Q_OBJECT

private slots:
    void open_nothingThere_isNotFound();
    void open_noHidDevice_isRefused();
    void open_notPermitted_namesTheRule();
    void list_everyDevice_hasAPath();
    void isHeldElsewhere_onlyWhileAnotherProgramHasItOpen();
    void udevRuleHint_ruleInstalled_saysHowToBringItIntoForce();
    void udevRuleHint_ruleBesideTheProgram_namesIt();
    void udevRuleHint_ruleNowhere_namesItsFile();
    void udevRule_everyLine_isMatchedAndSortsEarly();
};

namespace {

Error openError(const std::string &path)
{
    HidIdentity identity;
    identity.path = path;
    const auto device = openHidDevice(identity);
    return device ? Error{Errc::Cancelled, "It was opened."} : device.error();
}

fs::path putRule(const fs::path &folder)
{
    fs::create_directories(folder);
    std::ofstream(folder / "70-driftbench.rules") << "# empty\n";
    return folder / "70-driftbench.rules";
}

bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

void TestDeviceHidapi::open_nothingThere_isNotFound()
{
    const Error error = openError("/dev/hidraw-none");
    QCOMPARE(error.code, Errc::DeviceNotFound);
    QVERIFY(error.message.find("/dev/hidraw-none") != std::string::npos);
}

void TestDeviceHidapi::open_noHidDevice_isRefused()
{
    QCOMPARE(openError("/dev/null").code, Errc::DeviceRefused);
}

void TestDeviceHidapi::open_notPermitted_namesTheRule()
{
    if (::geteuid() == 0)
        QSKIP("root is permitted everything");
    QFile file(QString::fromStdString((scratchFolder() / "hidraw0").string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.setPermissions({}));
    const Error error = openError(file.fileName().toStdString());
    QCOMPARE(error.code, Errc::DeviceNotPermitted);
    QVERIFY(error.message.find("70-driftbench.rules") != std::string::npos);
}

void TestDeviceHidapi::list_everyDevice_hasAPath()
{
    for (const HidIdentity &device : listHidDevices())
        QVERIFY(!device.path.empty());
}

void TestDeviceHidapi::isHeldElsewhere_onlyWhileAnotherProgramHasItOpen()
{
    const fs::path node = fs::canonical(scratchFolder()) / "held";
    std::ofstream ours(node);
    QVERIFY(!isHeldElsewhere(node));
    QProcess other;
    other.start("sh", {"-c", "exec 3<\"$0\"; echo open; read line", QString::fromStdString(node.string())});
    QVERIFY(other.waitForReadyRead());
    QVERIFY(isHeldElsewhere(node));
    other.write("\n");
    QVERIFY(other.waitForFinished());
    QVERIFY(!isHeldElsewhere(node));
}

void TestDeviceHidapi::udevRuleHint_ruleInstalled_saysHowToBringItIntoForce()
{
    for (const char *folder : {"usr/lib/udev/rules.d", "usr/local/lib/udev/rules.d", "etc/udev/rules.d"}) {
        const fs::path root = scratchFolder() / "installed" / fs::path(folder).begin()->string() / folder;
        const fs::path rule = putRule(root / folder);
        const std::string hint = udevRuleHint(root, root / "usr/bin/driftbench-cli");
        QVERIFY2(contains(hint, rule.string()), hint.c_str());
        QVERIFY(contains(hint, "udevadm control --reload") && !contains(hint, "copy"));
    }
}

void TestDeviceHidapi::udevRuleHint_ruleBesideTheProgram_namesIt()
{
    const fs::path none = scratchFolder() / "empty root";
    const fs::path prefix = scratchFolder() / "prefix";
    const fs::path sources = scratchFolder() / "sources";
    const fs::path installed = putRule(prefix / "lib/udev/rules.d");
    const fs::path source = putRule(sources / "resources");
    const std::string fromPrefix = udevRuleHint(none, prefix / "bin/driftbench-cli");
    QVERIFY2(contains(fromPrefix, "copy") && contains(fromPrefix, installed.string()), fromPrefix.c_str());
    const std::string fromBuild = udevRuleHint(none, sources / "build/release/bin/driftbench-cli");
    QVERIFY2(contains(fromBuild, "copy") && contains(fromBuild, source.string()), fromBuild.c_str());
}

void TestDeviceHidapi::udevRuleHint_ruleNowhere_namesItsFile()
{
    const fs::path none = scratchFolder() / "empty root";
    for (const fs::path &program : {none / "bin/driftbench-cli", fs::path()}) {
        const std::string hint = udevRuleHint(none, program);
        QVERIFY(contains(hint, "copy the udev rule 70-driftbench.rules") &&
                contains(hint, "/etc/udev/rules.d"));
    }
}

void TestDeviceHidapi::udevRule_everyLine_isMatchedAndSortsEarly()
{
    const QDir resources(driftbench::test::sourceFolder() + "/resources");
    const QStringList rules = resources.entryList({"*.rules"});
    QCOMPARE(rules, QStringList{"70-driftbench.rules"});
    QVERIFY(rules.front() < QString("73-seat-late.rules"));
    QFile file(resources.filePath(rules.front()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    static const QRegularExpression rule(
        "^KERNEL==\"hidraw\\*\", SUBSYSTEM==\"hidraw\", ATTRS\\{idVendor\\}==\"([0-9a-f]{4})\", "
        "ATTRS\\{idProduct\\}==\"([0-9a-f]{4})\", TAG\\+=\"uaccess\"$");
    QStringList ids;
    for (const QString &line : QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)) {
        if (line.startsWith('#'))
            continue;
        const auto match = rule.match(line);
        QVERIFY2(match.hasMatch(), qPrintable(line));
        ids << match.captured(1) + ':' + match.captured(2);
    }
    const QString native = QString("%1:%2")
                               .arg(BRIDGE_VENDOR_ID, 4, 16, QLatin1Char('0'))
                               .arg(BRIDGE_PRODUCT_ID, 4, 16, QLatin1Char('0'));
    QCOMPARE(ids, (QStringList{native, "04d8:00dd", "10c4:ea90", "0403:6030"}));
}

QTEST_APPLESS_MAIN(TestDeviceHidapi)
#include "tst_device_hidapi.moc"
