#include "support/mocked_hidraw.h"

#include "device/bridge/bridge_protocol.h"
#include "device/simulated_bridge.h"
#include "support/report_pump.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <mutex>
#include <sys/ioctl.h>
#include <thread>
#include <umockdev.h>
#include <unistd.h>
#include <vector>

namespace driftbench::test {

namespace {

constexpr std::ptrdiff_t kMostWaiting = 2048; // of the 4095 bytes that a terminal holds
const std::vector<std::uint8_t> kDescriptor BRIDGE_REPORT_DESCRIPTOR;

std::string hex(std::uint32_t value, int digits)
{
    std::array<char, 16> text;
    std::snprintf(text.data(), text.size(), "%0*X", digits, value);
    return text.data();
}

// The one of the program: its environment names the folder to hidapi. At the end the folder goes.
UMockdevTestbed *testbed()
{
    static const std::unique_ptr<UMockdevTestbed, decltype(&g_object_unref)> bed(umockdev_testbed_new(),
                                                                                 &g_object_unref);
    return bed.get();
}

void require(gboolean done, GError *error)
{
    if (!done)
        qFatal("umockdev: %s", error ? error->message : "failed");
}

// The device files of one time plugged in, the parent first.
struct SysfsPaths
{
    explicit SysfsPaths(int number)
        : usb("/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(number + 1))
        , interface(usb + "/1-" + std::to_string(number + 1) + ":1.0")
        , hidName("0003:" + hex(BRIDGE_VENDOR_ID, 4) + ":" + hex(BRIDGE_PRODUCT_ID, 4) + "." +
                  hex(static_cast<std::uint32_t>(number) + 1, 4))
        , hid(interface + "/" + hidName)
        , node("hidraw" + std::to_string(number))
        , hidraw(hid + "/hidraw/" + node)
    {
    }

    std::string usb;
    std::string interface;
    std::string hidName;
    std::string hid;
    std::string node;
    std::string hidraw;
};

// umockdev(1) has the format.
std::string recordOf(const SysfsPaths &paths, const HidIdentity &identity)
{
    std::string descriptor;
    for (const std::uint8_t byte : kDescriptor)
        descriptor += hex(byte, 2);
    return "P: " + paths.usb +
           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: manufacturer=" + identity.manufacturer +
           "\\n\nA: product=" + identity.product + "\\n\nA: serial=" + identity.serial +
           "\\n\nA: bcdDevice=0100\\n\n\n" +
           //
           "P: " + paths.interface +
           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\\n\n\n" +
           //
           "P: " + paths.hid + "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:" + hex(BRIDGE_VENDOR_ID, 8) + ":" +
           hex(BRIDGE_PRODUCT_ID, 8) + "\nE: HID_NAME=" + identity.manufacturer + " " + identity.product +
           "\nE: HID_UNIQ=" + identity.serial + "\nH: report_descriptor=" + descriptor + "\n\n" +
           // Without the link to its device hidapi finds nothing.
           "P: " + paths.hidraw + "\nN: " + paths.node + "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/" +
           paths.node + "\nL: device=../../../" + paths.hidName + "\n";
}

} // namespace

struct MockedHidraw::Port
{
    Port(const std::shared_ptr<SimulatedBoard> &board, int nodeNumber);
    ~Port();

    static gboolean onIoctl(UMockdevIoctlBase *, UMockdevIoctlClient *client, gpointer port);
    static gboolean onRead(UMockdevIoctlBase *, UMockdevIoctlClient *client, gpointer port);

    void cutCable(); // once; readers see the device's end
    void deliver(std::span<const std::uint8_t> report);
    // What the ioctl gives back: a length, or the error number negated.
    int answer(unsigned long request, UMockdevIoctlData *argument);
    int getFeature(UMockdevIoctlData *argument, std::size_t length);
    int setFeature(UMockdevIoctlData *argument, std::size_t length);
    int failureOf(const Error &error) const;

    SysfsPaths paths;
    std::unique_ptr<HidTransport> device;
    UMockdevIoctlBase *ioctls = umockdev_ioctl_base_new();
    std::mutex mutex;
    int master = -1;                         // the far side of the node; -1: unplugged
    std::atomic<int> failure = 0;            // 0: as it is usual
    std::atomic<std::ptrdiff_t> waiting = 0; // bytes written there that nobody has read
    std::unique_ptr<ReportPump> pump;
};

namespace {

// The memory that the ioctl's argument points to.
UMockdevIoctlData *memoryOf(UMockdevIoctlData *argument, std::size_t length)
{
    GError *error = nullptr;
    UMockdevIoctlData *const memory = umockdev_ioctl_data_resolve(argument, 0, length, &error);
    require(memory != nullptr, error);
    return memory;
}

void write(UMockdevIoctlData *memory, std::size_t offset, std::span<const std::uint8_t> bytes)
{
    // Its bytes are not const in the interface, but are only copied.
    auto *const data = const_cast<guint8 *>(bytes.data());
    umockdev_ioctl_data_update(memory, offset, data, static_cast<gint>(bytes.size()));
}

} // namespace

MockedHidraw::Port::Port(const std::shared_ptr<SimulatedBoard> &board, int nodeNumber) : paths(nodeNumber)
{
    auto opened = SimulatedBridge::open(board);
    if (!opened)
        qFatal("%s", opened.error().message.c_str());
    device = *std::move(opened);
    GError *error = nullptr;
    require(umockdev_testbed_add_from_string(testbed(), recordOf(paths, device->identity()).c_str(), &error),
            error);
    const std::string path = "/dev/" + paths.node;
    g_signal_connect(ioctls, "handle-ioctl", G_CALLBACK(onIoctl), this);
    g_signal_connect(ioctls, "handle-read", G_CALLBACK(onRead), this);
    require(umockdev_testbed_attach_ioctl(testbed(), path.c_str(), ioctls, &error), error);
    master = umockdev_testbed_get_dev_fd(testbed(), path.c_str());
    // A program that is started meanwhile must not keep the device plugged in.
    if (master < 0 || ::fcntl(master, F_SETFD, FD_CLOEXEC) != 0 || ::fcntl(master, F_SETFL, O_NONBLOCK) != 0)
        qFatal("umockdev: no far side of %s", path.c_str());
    pump = std::make_unique<ReportPump>(
        *device, [this](std::span<const std::uint8_t> report) { deliver(report); }, [this] { cutCable(); });
}

MockedHidraw::Port::~Port()
{
    cutCable();
    pump.reset();
    GError *error = nullptr;
    umockdev_testbed_detach_ioctl(testbed(), ("/dev/" + paths.node).c_str(), &error);
    g_clear_error(&error);
    g_object_unref(ioctls);
}

void MockedHidraw::Port::cutCable()
{
    const std::lock_guard lock(mutex);
    if (master < 0)
        return;
    for (const std::string &path : {paths.hidraw, paths.hid, paths.interface, paths.usb})
        umockdev_testbed_remove_device(testbed(), ("/sys" + path).c_str());
    ::close(master);
    master = -1;
}

gboolean MockedHidraw::Port::onIoctl(UMockdevIoctlBase *, UMockdevIoctlClient *client, gpointer port)
{
    const int result = static_cast<Port *>(port)->answer(umockdev_ioctl_client_get_request(client),
                                                         umockdev_ioctl_client_get_arg(client));
    umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
    return TRUE;
}

gboolean MockedHidraw::Port::onRead(UMockdevIoctlBase *, UMockdevIoctlClient *client, gpointer port)
{
    int errorNumber = 0;
    const int length = umockdev_ioctl_client_execute(client, &errorNumber, nullptr);
    static_cast<Port *>(port)->waiting -= std::max(length, 0);
    umockdev_ioctl_client_complete(client, length, errorNumber);
    return TRUE;
}

// A terminal that is full takes a part of a report, and a reader that catches up gets that part: so it never
// becomes full.
void MockedHidraw::Port::deliver(std::span<const std::uint8_t> report)
{
    for (;;) {
        {
            const std::lock_guard lock(mutex);
            if (master < 0)
                return;
            if (waiting < kMostWaiting) {
                const ssize_t written = ::write(master, report.data(), report.size());
                if (written >= 0 && static_cast<std::size_t>(written) != report.size())
                    qFatal("umockdev: a report was torn on its way to %s", paths.node.c_str());
                waiting += std::max<ssize_t>(written, 0);
                return;
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

int MockedHidraw::Port::answer(unsigned long request, UMockdevIoctlData *argument)
{
    {
        const std::lock_guard lock(mutex);
        if (master < 0)
            return -ENODEV;
    }
    if (_IOC_TYPE(request) != 'H')
        return -ENOTTY;
    const std::size_t length = _IOC_SIZE(request);
    switch (_IOC_NR(request)) {
    case _IOC_NR(HIDIOCGRDESCSIZE): {
        const int size = static_cast<int>(kDescriptor.size());
        g_autoptr(UMockdevIoctlData) memory = memoryOf(argument, sizeof size);
        write(memory, 0, {reinterpret_cast<const std::uint8_t *>(&size), sizeof size});
        return 0;
    }
    case _IOC_NR(HIDIOCGRDESC): {
        g_autoptr(UMockdevIoctlData) memory = memoryOf(argument, sizeof(hidraw_report_descriptor));
        write(memory, offsetof(hidraw_report_descriptor, value), kDescriptor);
        return 0;
    }
    case _IOC_NR(HIDIOCGFEATURE(0)):
        return getFeature(argument, length);
    case _IOC_NR(HIDIOCSFEATURE(0)):
        return setFeature(argument, length);
    default:
        return -ENOTTY;
    }
}

int MockedHidraw::Port::getFeature(UMockdevIoctlData *argument, std::size_t length)
{
    g_autoptr(UMockdevIoctlData) memory = memoryOf(argument, length);
    std::vector<std::uint8_t> report(length);
    report[0] = memory->data[0];
    const auto got = device->getFeature(report);
    if (!got)
        return -failureOf(got.error());
    write(memory, 0, std::span(report).first(*got));
    return static_cast<int>(*got);
}

int MockedHidraw::Port::setFeature(UMockdevIoctlData *argument, std::size_t length)
{
    g_autoptr(UMockdevIoctlData) memory = memoryOf(argument, length);
    const Status done = device->sendFeature({memory->data, length});
    return done ? static_cast<int>(length) : -failureOf(done.error());
}

int MockedHidraw::Port::failureOf(const Error &error) const
{
    if (failure != 0)
        return failure;
    return error.code == Errc::DeviceUnplugged ? ENODEV : EPIPE;
}

MockedHidraw::MockedHidraw(std::shared_ptr<SimulatedBoard> board) : m_board(std::move(board))
{
    plugIn();
}

MockedHidraw::~MockedHidraw() = default;

bool MockedHidraw::isPreloaded()
{
    return ::dlopen("libumockdev-preload.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr;
}

void MockedHidraw::unplug()
{
    m_board->unplug();
    m_port->cutCable();
}

void MockedHidraw::plugIn()
{
    static std::atomic<int> next = 0; // umockdev takes no name twice
    m_board->plugIn();
    m_port.reset();
    m_port = std::make_unique<Port>(m_board, next++);
}

void MockedHidraw::failWith(int errorNumber)
{
    m_port->failure = errorNumber;
}

std::string MockedHidraw::node() const
{
    return "/dev/" + m_port->paths.node;
}

} // namespace driftbench::test
