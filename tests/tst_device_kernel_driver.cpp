// What sysfs says about the bridges' kernel drivers, on trees made like those of a 6.1 kernel.
#include "device/discovery/kernel_driver_state.h"

#include <QTemporaryDir>
#include <QTest>

using namespace driftbench;
namespace fs = std::filesystem;

class TestDeviceKernelDriver : public QObject
{
    Q_OBJECT

private slots:
    void bridge_notPluggedIn_isSaid();
    void mcp2221a_heldByItsDriver_isToldHowToFreeIt();
    void mcp2221a_underHidGeneric_isUsable();
    void cp2112_withoutDriver_isNeverBlacklisted();
    void cp2112_withItsDriver_isUsable();
    void ft260_twoInterfaces_areBothListed();
    void ft260_failedProbe_isToldApart();
    void devices_otherBusOrId_areIgnored();
    void devices_severalOfOneKind_bestCounts();
    void anyBridge_noSysfs_isNotPluggedIn();
};

namespace {

constexpr std::uint16_t kMicrochip = 0x04D8;
constexpr std::uint16_t kMcp2221a = 0x00DD;
constexpr std::uint16_t kSilabs = 0x10C4;
constexpr std::uint16_t kCp2112 = 0xEA90;
constexpr std::uint16_t kFtdi = 0x0403;
constexpr std::uint16_t kFt260 = 0x6030;

// Links lead where those of the kernel do: the device into /sys/devices, the driver into
// /sys/bus/hid/drivers.
class FakeSysfs
{
public:
    FakeSysfs() : m_root(m_folder.path().toStdString())
    {
        fs::create_directories(m_root / "bus/hid/devices");
    }

    const fs::path &root() const { return m_root; }
    void loadModule(const std::string &module) { fs::create_directories(m_root / "module" / module); }
    void addDevice(const std::string &name, const std::string &driver, const std::string &module,
                   const std::string &hidraw)
    {
        const fs::path device = m_root / "devices/usb1/1-1" / name;
        fs::create_directories(device);
        fs::create_directory_symlink(device, m_root / "bus/hid/devices" / name);
        if (!driver.empty()) {
            const fs::path folder = m_root / "bus/hid/drivers" / driver;
            fs::create_directories(folder);
            fs::create_directory_symlink(folder, device / "driver");
            if (!module.empty() && !fs::exists(folder / "module")) {
                loadModule(module);
                fs::create_directory_symlink(m_root / "module" / module, folder / "module");
            }
        }
        if (!hidraw.empty())
            fs::create_directories(device / "hidraw" / hidraw);
    }

private:
    QTemporaryDir m_folder;
    fs::path m_root;
};

bool contains(const std::string &text, const char *part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

void TestDeviceKernelDriver::bridge_notPluggedIn_isSaid()
{
    const FakeSysfs sysfs;
    const KernelDriverReport report = kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a);
    QCOMPARE(report.state, KernelDriverState::NotPluggedIn);
    QCOMPARE(report.status().error().code, Errc::DeviceNotFound);
    QVERIFY(contains(report.advice, "MCP2221A 04d8:00dd"));
}

void TestDeviceKernelDriver::mcp2221a_heldByItsDriver_isToldHowToFreeIt()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:04D8:00DD.0001", "mcp2221", "hid_mcp2221", "");
    const KernelDriverReport report = kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a);
    QCOMPARE(report.state, KernelDriverState::HeldByDriver);
    QCOMPARE(report.driver, std::string("mcp2221"));
    QCOMPARE(report.module, std::string("hid_mcp2221"));
    QCOMPARE(report.status().error().code, Errc::DeviceHeldByKernel);
    QVERIFY(contains(report.advice, "rmmod hid_mcp2221"));
    QVERIFY(contains(report.advice, "blacklist hid_mcp2221"));
}

void TestDeviceKernelDriver::mcp2221a_underHidGeneric_isUsable()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:04D8:00DD.0001", "hid-generic", "hid_generic", "hidraw3");
    const KernelDriverReport report = kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a);
    QCOMPARE(report.state, KernelDriverState::Usable);
    QCOMPARE(report.hidrawNodes, std::vector<std::string>{"hidraw3"});
    QVERIFY(report.status().ok() && report.advice.empty());
}

void TestDeviceKernelDriver::cp2112_withoutDriver_isNeverBlacklisted()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:10C4:EA90.0002", "", "", "");
    KernelDriverReport report = kernelDriverState(sysfs.root(), kSilabs, kCp2112);
    QCOMPARE(report.state, KernelDriverState::NoDriver);
    QVERIFY(contains(report.advice, "modprobe hid_cp2112"));
    QVERIFY(contains(report.advice, "never blacklist"));
    sysfs.loadModule("hid_cp2112");
    report = kernelDriverState(sysfs.root(), kSilabs, kCp2112);
    QVERIFY(!contains(report.advice, "modprobe") && contains(report.advice, "could not start"));
}

void TestDeviceKernelDriver::cp2112_withItsDriver_isUsable()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:10C4:EA90.0002", "cp2112", "hid_cp2112", "hidraw0");
    QVERIFY(kernelDriverState(sysfs.root(), kSilabs, kCp2112).status().ok());
    // It holds the chip for a moment while it starts.
    FakeSysfs starting;
    starting.addDevice("0003:10C4:EA90.0002", "cp2112", "hid_cp2112", "");
    const KernelDriverReport report = kernelDriverState(starting.root(), kSilabs, kCp2112);
    QCOMPARE(report.state, KernelDriverState::HeldByDriver);
    QVERIFY(!contains(report.advice, "blacklist"));
}

void TestDeviceKernelDriver::ft260_twoInterfaces_areBothListed()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:0403:6030.0005", "ft260", "hid_ft260", "hidraw1");
    sysfs.addDevice("0003:0403:6030.0006", "ft260", "hid_ft260", "hidraw2");
    const KernelDriverReport report = kernelDriverState(sysfs.root(), kFtdi, kFt260);
    QCOMPARE(report.state, KernelDriverState::Usable);
    QCOMPARE(report.hidrawNodes, (std::vector<std::string>{"hidraw1", "hidraw2"}));
}

void TestDeviceKernelDriver::ft260_failedProbe_isToldApart()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:0403:6030.0005", "", "", "");
    QVERIFY(contains(kernelDriverState(sysfs.root(), kFtdi, kFt260).advice, "hid_generic"));
    sysfs.loadModule("hid_ft260");
    QVERIFY(contains(kernelDriverState(sysfs.root(), kFtdi, kFt260).advice, "hid_ft260 could not start"));
}

void TestDeviceKernelDriver::devices_otherBusOrId_areIgnored()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0005:04D8:00DD.0001", "hid-generic", "", "hidraw0"); // Bluetooth
    sysfs.addDevice("0003:04D8:00DE.0001", "hid-generic", "", "hidraw1");
    QCOMPARE(kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a).state, KernelDriverState::NotPluggedIn);
    const KernelDriverReport other = kernelDriverState(sysfs.root(), 0x1209, 0x0001);
    QVERIFY(contains(other.advice, "HID device 1209:0001"));
}

void TestDeviceKernelDriver::devices_severalOfOneKind_bestCounts()
{
    FakeSysfs sysfs;
    sysfs.addDevice("0003:04D8:00DD.0001", "", "", "");
    sysfs.addDevice("0003:04D8:00DD.0002", "mcp2221", "hid_mcp2221", "");
    QCOMPARE(kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a).state, KernelDriverState::HeldByDriver);
    sysfs.addDevice("0003:04D8:00DD.0003", "hid-generic", "hid_generic", "hidraw7");
    const KernelDriverReport report = kernelDriverState(sysfs.root(), kMicrochip, kMcp2221a);
    QCOMPARE(report.state, KernelDriverState::Usable);
    QCOMPARE(report.driver, std::string("hid-generic"));
}

void TestDeviceKernelDriver::anyBridge_noSysfs_isNotPluggedIn()
{
    QCOMPARE(kernelDriverState("/does/not/exist", kMicrochip, kMcp2221a).state,
             KernelDriverState::NotPluggedIn);
}

QTEST_APPLESS_MAIN(TestDeviceKernelDriver)
#include "tst_device_kernel_driver.moc"
