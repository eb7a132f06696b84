// The list of devices: what is merged from made-up HID lists and a made-up kernel, and what a look inside
// made-up devices adds: each of the distinct messages, and never a device opened that is in use.
#include "device/discovery/device_scan.h"
#include "support/bridges.h"
#include "support/gyro_model.h"
#include "support/made_up_devices.h"
#include "support/simulated_device.h"
#include "support/thermometer_models.h"

#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace driftbench;
using namespace driftbench::test;
namespace fs = std::filesystem;

class TestDeviceDiscovery : public QObject
{
    Q_OBJECT

private slots:
    void list_nothingPlugged_hasTheSimulatedBridge();
    void list_devicesOfAllKinds_areInOrder();
    void list_sameOrNoSerial_isToldByPath();
    void list_uhidIdentity_isNotFiltered();
    void list_ft260_oneEntryForTwoInterfaces();
    void list_keptByTheKernel_saysHowToFreeIt();
    void list_inUse_isMarkedOrLost();
    void list_ownUsbIds_countInstead();
    void match_chosen_isTheRightOne();
    void status_everyMessage_isDistinct();
    void scan_nativeBridge_givesItsIdentity();
    void scan_i2cChips_giveGyroAndThermometer();
    void scan_errors_areThoseOfTheDevices();
    void scan_remembersAndForgets();
    void scan_inUse_isNeverOpened();
    void scan_chipHeldElsewhere_isNotOpenedUntilItIsFree();
    void scan_sysfsTree_isRead();
    void same_listsThatDiffer_areTold();
};

namespace {

HidIdentity at(std::uint16_t vendorId, std::uint16_t productId, const std::string &serial,
               const std::string &path, int interfaceNumber = -1)
{
    return {vendorId, productId, "", "", serial, path, interfaceNumber};
}

HidIdentity native(const std::string &serial, const std::string &path)
{
    return at(0x1209, 0x0001, serial, path);
}

KernelDriverReport nothingKept(UsbId)
{
    return {};
}

DeviceList listed(const std::vector<HidIdentity> &seen, const DeviceListOptions &options = {})
{
    return listDevices(seen, nothingKept, options);
}

std::vector<std::string> sources(const DeviceList &list)
{
    std::vector<std::string> texts;
    for (const DeviceEntry &entry : list)
        texts.push_back(entry.source);
    return texts;
}

MadeUpDevices::Open failing(Errc code)
{
    return [code]() -> Result<std::unique_ptr<HidTransport>> { return Error{code, "It is as it is."}; };
}

} // namespace

void TestDeviceDiscovery::list_nothingPlugged_hasTheSimulatedBridge()
{
    const DeviceList list = listed({});
    QCOMPARE(sources(list), std::vector<std::string>{"simulated"});
    QVERIFY(list[0].usable() && list[0].kind == DeviceKind::SimulatedBridge);
    QCOMPARE(somethingPluggedIn(list).error().code, Errc::DeviceNotFound);
    QVERIFY(somethingPluggedIn(listed({native("A", "p")})).ok());
    QCOMPARE(listed({at(0x046D, 0xC077, "", "/dev/hidraw0")}).size(), std::size_t(1)); // a mouse
}

void TestDeviceDiscovery::list_devicesOfAllKinds_areInOrder()
{
    const DeviceList list =
        listed({at(0x0403, 0x6030, "F", "p0", 0), at(0x10C4, 0xEA90, "C", "p1", 0), native("A-1", "p2"),
                at(0x04D8, 0x00DD, "", "p3", 2), native("A-2", "p4")});
    QCOMPARE(sources(list),
             (std::vector<std::string>{"simulated", "hid:A-1", "hid:A-2", "i2c:mcp2221a:p3/auto",
                                       "i2c:cp2112:C/auto", "i2c:ft260:F/auto"}));
    for (const DeviceEntry &entry : list) {
        QVERIFY(entry.usable());
        QVERIFY(parseSourceChoice(entry.source).ok());
    }
}

void TestDeviceDiscovery::list_sameOrNoSerial_isToldByPath()
{
    const DeviceList list =
        listed({native("", "p1"), native("X", "p2"), native("X", "p3"), native("Y", "p4")});
    QCOMPARE(sources(list), (std::vector<std::string>{"simulated", "hid:p1", "hid:p2", "hid:p3", "hid:Y"}));
}

void TestDeviceDiscovery::list_uhidIdentity_isNotFiltered()
{
    QCOMPARE(listed({at(0x1209, 1, "U-1", "/dev/hidraw0", -1)}).size(), std::size_t(2));
}

void TestDeviceDiscovery::list_ft260_oneEntryForTwoInterfaces()
{
    const DeviceList list = listed({at(0x0403, 0x6030, "F", "uart", 1), at(0x0403, 0x6030, "F", "i2c", 0)});
    QCOMPARE(list.size(), std::size_t(2));
    QCOMPARE(list[1].identity.path, std::string("i2c"));
    // Where the interfaces are not known both may be it, and where there is only the other it is shown.
    QCOMPARE(listed({at(0x0403, 0x6030, "F", "a", -1), at(0x0403, 0x6030, "F", "b", -1)}).size(),
             std::size_t(3));
    QCOMPARE(listed({at(0x0403, 0x6030, "F", "uart", 1)}).size(), std::size_t(2));
}

void TestDeviceDiscovery::list_keptByTheKernel_saysHowToFreeIt()
{
    const KernelReports kernel = [](UsbId id) {
        KernelDriverReport report;
        if (id.vendorId == 0x04D8) {
            report.state = KernelDriverState::HeldByDriver;
            report.advice = "Free the MCP2221A.";
        }
        if (id.vendorId == 0x10C4) {
            report.state = KernelDriverState::NoDriver;
            report.advice = "Load hid_cp2112.";
        }
        if (id.vendorId == 0x0403)
            report.state = KernelDriverState::Usable;
        return report;
    };
    const DeviceList list = listDevices({}, kernel, {});
    QCOMPARE(list.size(), std::size_t(3));
    for (std::size_t i : {1u, 2u}) {
        QCOMPARE(list[i].status.error().code, Errc::DeviceHeldByKernel);
        QVERIFY(!list[i].usable());
        QCOMPARE(deviceStatusText(list[i]), std::string_view("held by the kernel"));
    }
    QCOMPARE(list[1].sentence(), std::string("Free the MCP2221A."));
    QCOMPARE(list[2].name, std::string("CP2112"));
    // One that is seen is not kept, whatever else there is of its kind.
    QCOMPARE(listDevices({at(0x04D8, 0x00DD, "", "p1")}, kernel, {}).size(), std::size_t(3));
}

void TestDeviceDiscovery::list_inUse_isMarkedOrLost()
{
    DeviceListOptions options;
    options.inUse = {native("A-1", "p1"), native("A-9", "p9"), at(0x04D8, 0x00DD, "", "p5"),
                     at(0x1209, 1, "SIM-0001", "simulated:SIM-0001")};
    const DeviceList list = listed({native("A-1", "p7"), native("A-2", "p2")}, options);
    QVERIFY(list[0].inUse && list[0].status.ok());
    QVERIFY(list[1].inUse && list[1].status.ok() && !list[1].usable()); // it came back elsewhere
    QVERIFY(!list[2].inUse);
    QCOMPARE(list.size(), std::size_t(5));
    QCOMPARE(list[3].status.error().code, Errc::DeviceUnplugged);
    QVERIFY(list[3].sentence().find("A-9") != std::string::npos);
    QCOMPARE(list[4].name, std::string("MCP2221A"));
}

void TestDeviceDiscovery::list_ownUsbIds_countInstead()
{
    DeviceListOptions options;
    options.nativeIds = {{0xCAFE, 1}};
    QCOMPARE(sources(listed({native("A", "p1"), at(0xCAFE, 1, "B", "p2")}, options)),
             (std::vector<std::string>{"simulated", "hid:B"}));
}

void TestDeviceDiscovery::match_chosen_isTheRightOne()
{
    const std::vector<HidIdentity> seen{native("A", "p1"), native("B", "p2"), at(0x10C4, 0xEA90, "C", "p3")};
    QCOMPARE(findNativeBridge(seen, {"B"}, nothingKept)->path, std::string("p2"));
    QCOMPARE(findNativeBridge(seen, {"p1"}, nothingKept)->serial, std::string("A"));
    QCOMPARE(findNativeBridge(seen, {""}, nothingKept).error().code, Errc::InvalidOption);
    QCOMPARE(findI2cChip(seen, {I2cChip::Cp2112, ""}, nothingKept)->path, std::string("p3"));
    const KernelReports held = [](UsbId) {
        return KernelDriverReport{KernelDriverState::HeldByDriver, "mcp2221", "hid_mcp2221", {}, "Free it."};
    };
    QCOMPARE(findI2cChip(seen, {I2cChip::Mcp2221a, ""}, held).error().code, Errc::DeviceHeldByKernel);
    QCOMPARE(findI2cChip(seen, {I2cChip::Mcp2221a, ""}, nothingKept).error().code, Errc::DeviceNotFound);
}

void TestDeviceDiscovery::status_everyMessage_isDistinct()
{
    std::set<std::string_view> texts;
    DeviceEntry entry;
    texts.insert(deviceStatusText(entry));
    entry.inUse = true;
    texts.insert(deviceStatusText(entry));
    const std::array codes{Errc::DeviceNotFound,  Errc::DeviceNotPermitted, Errc::DeviceHeldByKernel,
                           Errc::DeviceInUse,     Errc::BusNoAcknowledge,   Errc::BusStuck,
                           Errc::DeviceUnplugged, Errc::ProtocolVersion,    Errc::WrongSensor,
                           Errc::DeviceSilent,    Errc::DamagedReport,      Errc::DeviceRefused};
    for (const Errc code : codes) {
        entry.status = Error{code, "Why."};
        texts.insert(deviceStatusText(entry));
        QVERIFY(!entry.usable());
        QCOMPARE(entry.sentence(), std::string("Why."));
    }
    QCOMPARE(texts.size(), codes.size() + 2);
}

void TestDeviceDiscovery::scan_nativeBridge_givesItsIdentity()
{
    MadeUpDevices devices;
    const auto board = *SimulatedBoard::create(quickBoard(1.0));
    devices.plugIn(native("USB-7", "p1"), [&] { return SimulatedBridge::open(board); });
    const DeviceList list = DeviceScanner(devices.access(&board->clock())).scan();
    QVERIFY(list[1].usable());
    QCOMPARE(list[1].details->sensor.text(), std::string("L3GD20H SIM-0001"));
    QCOMPARE(list[1].details->firmware, std::string("1.0.0"));
    QCOMPARE(list[1].details->protocol,
             std::to_string(BRIDGE_PROTOCOL_MAJOR) + "." + std::to_string(BRIDGE_PROTOCOL_MINOR));
    QCOMPARE(list[1].identityText(), std::string("L3GD20H SIM-0001"));
    QCOMPARE(list[1].source, std::string("hid:USB-7"));
}

void TestDeviceDiscovery::scan_i2cChips_giveGyroAndThermometer()
{
    for (const char *name : kBridgeNames) {
        for (const bool external : {false, true}) {
            Bridge bridge;
            GyroModel gyro("I3G4250D", bridge.clock);
            Mcp9808Model mcp9808(bridge.clock);
            bridge.wires.attach(0x69, gyro);
            if (external)
                bridge.wires.attach(0x1A, mcp9808);
            const I2cChipDescription &chip = describe(*i2cChipNamed(name));
            MadeUpDevices devices;
            devices.plugIn(at(chip.vendorId, chip.productId, "S1", "p1"),
                           [&]() -> Result<std::unique_ptr<HidTransport>> { return makeChip(name, bridge); });
            const DeviceList list = DeviceScanner(devices.access(&bridge.clock)).scan();
            QVERIFY2(list[1].usable(), list[1].sentence().c_str());
            QCOMPARE(list[1].source,
                     "i2c:" + std::string(chip.key) + ":S1/i3g4250d" + (external ? "+mcp9808" : ""));
            QCOMPARE(list[1].details->thermometer, std::string(external ? "MCP9808" : ""));
            QVERIFY(list[1].identityText().starts_with("S1 with I3G4250D"));
        }
    }
}

void TestDeviceDiscovery::scan_errors_areThoseOfTheDevices()
{
    MadeUpDevices devices;
    devices.plugIn(native("A", "p1"), failing(Errc::DeviceNotPermitted));
    devices.plugIn(native("B", "p2"), failing(Errc::DeviceInUse));
    const auto board = *SimulatedBoard::create(quickBoard(1.0));
    board->inject([](SimulatedFaults &faults) { faults.pretendMajor(2); });
    devices.plugIn(native("C", "p3"), [&] { return SimulatedBridge::open(board); });
    std::array<Bridge, 3> bridges;
    bridges[1].wires.holdLow(1000000);
    Tmp117Model stranger(bridges[2].clock);
    bridges[2].wires.attach(0x68, stranger);
    for (std::size_t i = 0; i < bridges.size(); ++i)
        devices.plugIn(at(0x04D8, 0x00DD, std::to_string(i), "m" + std::to_string(i)),
                       [&bridge = bridges[i]]() -> Result<std::unique_ptr<HidTransport>> {
                           return makeChip("MCP2221A", bridge);
                       });
    const DeviceList list = DeviceScanner(devices.access()).scan();
    const std::array expected{Errc::DeviceNotPermitted, Errc::DeviceInUse, Errc::ProtocolVersion,
                              Errc::BusNoAcknowledge,   Errc::BusStuck,    Errc::WrongSensor};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        QVERIFY(!list[i + 1].status.ok());
        QCOMPARE(list[i + 1].status.error().code, expected[i]);
        QVERIFY(list[i + 1].sentence().ends_with('.'));
    }
}

void TestDeviceDiscovery::scan_remembersAndForgets()
{
    MadeUpDevices devices;
    const auto board = *SimulatedBoard::create(quickBoard(1.0));
    bool permitted = false;
    devices.plugIn(native("A", "p1"), [&]() -> Result<std::unique_ptr<HidTransport>> {
        if (!permitted)
            return Error{Errc::DeviceNotPermitted, "Install the rule."};
        return SimulatedBridge::open(board);
    });
    DeviceScanner scanner(devices.access(&board->clock()));
    QCOMPARE(scanner.scan()[1].status.error().code, Errc::DeviceNotPermitted);
    permitted = true;
    QVERIFY(scanner.scan()[1].usable());
    QCOMPARE(devices.opened, 2);
    for (int i = 0; i < 5; ++i)
        QVERIFY(scanner.scan()[1].details.has_value());
    QCOMPARE(devices.opened, 2);
    QVERIFY(scanner.scan({{}, true})[1].details.has_value());
    QCOMPARE(devices.opened, 3);
    devices.unplug("p1");
    QCOMPARE(scanner.scan().size(), std::size_t(1));
    devices.plugIn(native("A", "p1"), [&] { return SimulatedBridge::open(board); });
    QVERIFY(scanner.scan()[1].usable());
    QCOMPARE(devices.opened, 4);
    // What was seen inside and can't change by itself is not looked for every second.
    devices.plugIn(native("B", "p2"), failing(Errc::DeviceSilent));
    scanner.scan();
    scanner.scan();
    QCOMPARE(devices.opened, 5);
}

void TestDeviceDiscovery::scan_inUse_isNeverOpened()
{
    MadeUpDevices devices;
    const auto board = *SimulatedBoard::create(quickBoard(1.0));
    devices.plugIn(native("A", "p1"), [&] { return SimulatedBridge::open(board); });
    devices.plugIn(native("B", "p2"), failing(Errc::DeviceSilent));
    DeviceScanner scanner(devices.access(&board->clock()));
    const ScanRequest both{{native("A", "p1"), native("B", "p2")}, true};
    DeviceList list = scanner.scan(both);
    QCOMPARE(devices.opened, 0);
    QVERIFY(list[1].inUse && !list[1].details && list[1].status.ok());
    QVERIFY(scanner.scan()[1].details.has_value());
    QCOMPARE(devices.opened, 2);
    list = scanner.scan(both);
    QCOMPARE(devices.opened, 2);
    QVERIFY(list[1].inUse && list[1].details.has_value()); // what is known of it stays
}

// A native bridge may be asked meanwhile; the transfers on an I2C bus would break.
void TestDeviceDiscovery::scan_chipHeldElsewhere_isNotOpenedUntilItIsFree()
{
    Bridge bridge;
    GyroModel gyro("L3GD20H", bridge.clock);
    bridge.wires.attach(0x6B, gyro);
    const auto board = *SimulatedBoard::create(quickBoard(1.0));
    MadeUpDevices devices;
    devices.plugIn(native("A", "p1"), [&] { return SimulatedBridge::open(board); });
    devices.plugIn(at(0x04D8, 0x00DD, "S1", "p2"),
                   [&]() -> Result<std::unique_ptr<HidTransport>> { return makeChip("MCP2221A", bridge); });
    bool held = true;
    HidAccess access = devices.access(&board->clock());
    access.heldElsewhere = [&held](const HidIdentity &) { return held; };
    DeviceScanner scanner(access);
    const DeviceList list = scanner.scan();
    QVERIFY(list[1].usable());
    QCOMPARE(list[2].status.error().code, Errc::DeviceInUse);
    QCOMPARE(devices.opened, 1);
    QCOMPARE(bridge.wires.transfers(), 0);
    held = false;
    QVERIFY(scanner.scan()[2].usable());
}

void TestDeviceDiscovery::scan_sysfsTree_isRead()
{
    QTemporaryDir folder;
    const fs::path root(folder.path().toStdString());
    const fs::path device = root / "devices/0003:04D8:00DD.0001";
    fs::create_directories(device);
    fs::create_directories(root / "bus/hid/devices");
    fs::create_directories(root / "bus/hid/drivers/mcp2221");
    fs::create_directory_symlink(device, root / "bus/hid/devices/0003:04D8:00DD.0001");
    fs::create_directory_symlink(root / "bus/hid/drivers/mcp2221", device / "driver");
    MadeUpDevices devices;
    HidAccess access = devices.access();
    access.sysfs = root;
    const DeviceList list = DeviceScanner(access).scan();
    QCOMPARE(list.size(), std::size_t(2));
    QCOMPARE(list[1].status.error().code, Errc::DeviceHeldByKernel);
    QVERIFY(list[1].sentence().find("rmmod hid_mcp2221") != std::string::npos);
}

void TestDeviceDiscovery::same_listsThatDiffer_areTold()
{
    const DeviceList list = listed({native("A", "p1")});
    QVERIFY(sameDevices(list, listed({native("A", "p1")})));
    QVERIFY(!sameDevices(list, listed({})));
    QVERIFY(!sameDevices(list, listed({native("A", "p2")})));
    DeviceList other = list;
    other[1].status = Error{Errc::BusStuck, "It is stuck."};
    QVERIFY(!sameDevices(list, other));
    DeviceList third = other;
    third[1].status = Error{Errc::BusStuck, "It is stuck elsewhere."};
    QVERIFY(!sameDevices(third, other));
    other = list;
    other[1].details = DeviceDetails{{"L3GD20H", ""}, "", "", ""};
    QVERIFY(!sameDevices(list, other));
    third = other;
    QVERIFY(sameDevices(third, other));
    third[1].inUse = true;
    QVERIFY(!sameDevices(third, other));
}

QTEST_APPLESS_MAIN(TestDeviceDiscovery)
#include "tst_device_discovery.moc"
