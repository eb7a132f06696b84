#include "device/hidapi_transport.h"

#include "device/udev_rule.h"

#include <hidapi.h>

#include <cerrno>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <mutex>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace driftbench {

namespace {

using namespace std::chrono_literals;

// wchar_t holds a code point under Linux; other systems' pairs of surrogates do not occur in device names.
void appendUtf8(std::string &text, char32_t point)
{
    const auto tail = [point](int shift) { return static_cast<char>(0x80 | ((point >> shift) & 0x3F)); };
    if (point < 0x80) {
        text += static_cast<char>(point);
    } else if (point < 0x800) {
        text += {static_cast<char>(0xC0 | (point >> 6)), tail(0)};
    } else if (point < 0x10000) {
        text += {static_cast<char>(0xE0 | (point >> 12)), tail(6), tail(0)};
    } else {
        text += {static_cast<char>(0xF0 | (point >> 18)), tail(12), tail(6), tail(0)};
    }
}

std::string utf8(const wchar_t *wide)
{
    std::string text;
    for (; wide && *wide != L'\0'; ++wide)
        appendUtf8(text, static_cast<char32_t>(*wide));
    return text;
}

std::string systemText(int errorNumber)
{
    return std::generic_category().message(errorNumber);
}

// hidapi keeps its list and its last error for the whole process.
std::mutex &hidapiMutex()
{
    static std::mutex mutex;
    return mutex;
}

class Descriptor
{
public:
    explicit Descriptor(int number = -1) : m_number(number) {}
    ~Descriptor()
    {
        if (m_number >= 0)
            ::close(m_number);
    }
    Descriptor(Descriptor &&other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor &operator=(Descriptor &&) = delete;
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;

    int number() const { return m_number; }

private:
    int m_number;
};

// hidraw lets any number of programs open a node, and each would take the answers to the other's requests for
// its own. So whoever uses it locks it; a look at what the device is lasts less than a few tries.
bool lock(int descriptor)
{
    constexpr int kTries = 10;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            return true;
        if (errno != EWOULDBLOCK)
            return true; // a system without such locks
        std::this_thread::sleep_for(20ms);
    }
    return false;
}

// The node, locked, or why it can't be used. hidapi tells why only in words of the user's language, and 0.13
// crashes on a node that is no HID device.
struct Claim
{
    Descriptor descriptor;
    int errorNumber = 0;
};

Claim claim(const std::string &path)
{
    Claim made{Descriptor(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK))};
    int bytes = 0;
    if (made.descriptor.number() < 0 || ::ioctl(made.descriptor.number(), HIDIOCGRDESCSIZE, &bytes) < 0)
        made.errorNumber = errno;
    else if (!lock(made.descriptor.number()))
        made.errorNumber = EBUSY;
    return made;
}

// A cable that is pulled in the middle of an exchange makes it fail at once, as a damaged one; that the
// device has gone the kernel knows and tells all who have the node open a moment later.
bool mayBeGone(int errorNumber)
{
    return errorNumber == EIO || errorNumber == EPROTO || errorNumber == EILSEQ || errorNumber == EOVERFLOW ||
           errorNumber == ETIMEDOUT;
}

bool goesSoon(int descriptor)
{
    constexpr int kWaitMs = 250;
    pollfd end{descriptor, 0, 0}; // asks for nothing but the end
    return ::poll(&end, 1, kWaitMs) > 0;
}

Error openError(const std::string &path, int number)
{
    switch (number) {
    case EACCES:
    case EPERM:
        return {Errc::DeviceNotPermitted, "The device at " + path +
                                              " is there, but you are not permitted to open it; " +
                                              udevRuleHint()};
    case ENOENT:
    case ENODEV:
    case ENXIO:
        return {Errc::DeviceNotFound, "There is no device at " + path + "; plug it in."};
    case EBUSY:
        return {Errc::DeviceInUse, "Another program holds the device at " + path + "; close that program."};
    default:
        return {Errc::DeviceRefused, "The device at " + path + " can't be opened (" +
                                         (number != 0 ? systemText(number) : utf8(hid_error(nullptr))) +
                                         "); unplug it and plug it in again."};
    }
}

class HidapiTransport final : public HidTransport
{
public:
    HidapiTransport(hid_device *device, HidIdentity identity, Descriptor lock)
        : m_device(device), m_identity(std::move(identity)), m_lock(std::move(lock))
    {
    }
    ~HidapiTransport() override { hid_close(m_device); }
    HidapiTransport(const HidapiTransport &) = delete;
    HidapiTransport &operator=(const HidapiTransport &) = delete;

    const HidIdentity &identity() const override { return m_identity; }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override;
    Status write(std::span<const std::uint8_t> report) override;
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override;
    Status sendFeature(std::span<const std::uint8_t> report) override;

private:
    Error unplugged() const
    {
        return {Errc::DeviceUnplugged, "The device at " + m_identity.path +
                                           " was unplugged, or a driver of the kernel took it; plug it in "
                                           "again."};
    }
    Error exchangeError(const char *what, std::uint8_t id, int errorNumber) const;

    hid_device *m_device;
    HidIdentity m_identity;
    Descriptor m_lock; // as long as it is open; never read from
};

Error HidapiTransport::exchangeError(const char *what, std::uint8_t id, int errorNumber) const
{
    if (mayBeGone(errorNumber) && goesSoon(m_lock.number()))
        return unplugged();
    const std::string report = std::string(what) + " report " + std::to_string(id);
    switch (errorNumber) {
    case ENODEV:
    case ENXIO:
    case ENOENT:
    case ESHUTDOWN:
        return unplugged();
    case ETIMEDOUT:
        return {Errc::DeviceSilent, "The device at " + m_identity.path + " did not answer to " + report +
                                        " in time; unplug it and plug it in again."};
    default:
        return {Errc::DeviceRefused,
                "The device at " + m_identity.path + " refused to " + report + " (" +
                    (errorNumber != 0 ? systemText(errorNumber) : utf8(hid_error(m_device))) + ")."};
    }
}

Result<std::size_t> HidapiTransport::read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout)
{
    errno = 0;
    const int length =
        hid_read_timeout(m_device, report.data(), report.size(), static_cast<int>(timeout.count()));
    if (length >= 0)
        return static_cast<std::size_t>(length);
    // Nothing but the device's end and a signal makes a read of hidraw fail.
    if (errno == EINTR)
        return std::size_t{0};
    return unplugged();
}

Status HidapiTransport::write(std::span<const std::uint8_t> report)
{
    errno = 0;
    if (hid_write(m_device, report.data(), report.size()) < 0)
        return exchangeError("take", report[0], errno);
    return {};
}

Result<std::size_t> HidapiTransport::getFeature(std::span<std::uint8_t> report)
{
    const std::uint8_t id = report[0];
    errno = 0;
    const int length = hid_get_feature_report(m_device, report.data(), report.size());
    if (length < 0)
        return exchangeError("give", id, errno);
    return static_cast<std::size_t>(length);
}

Status HidapiTransport::sendFeature(std::span<const std::uint8_t> report)
{
    errno = 0;
    if (hid_send_feature_report(m_device, report.data(), report.size()) < 0)
        return exchangeError("take", report[0], errno);
    return {};
}

} // namespace

std::vector<HidIdentity> listHidDevices()
{
    const std::lock_guard lock(hidapiMutex());
    std::vector<HidIdentity> devices;
    hid_device_info *const first = hid_enumerate(0, 0);
    for (const hid_device_info *each = first; each; each = each->next) {
        // One of several usages of the same node is enough.
        if (!devices.empty() && devices.back().path == each->path)
            continue;
        devices.push_back({each->vendor_id, each->product_id, utf8(each->manufacturer_string),
                           utf8(each->product_string), utf8(each->serial_number), each->path,
                           each->interface_number});
    }
    hid_free_enumeration(first);
    return devices;
}

Result<std::unique_ptr<HidTransport>> openHidDevice(const HidIdentity &identity)
{
    Claim claimed = claim(identity.path);
    if (claimed.errorNumber != 0)
        return openError(identity.path, claimed.errorNumber);
    const std::lock_guard lock(hidapiMutex());
    if (hid_device *const device = hid_open_path(identity.path.c_str()))
        return std::unique_ptr<HidTransport>(
            std::make_unique<HidapiTransport>(device, identity, std::move(claimed.descriptor)));
    return openError(identity.path, 0);
}

} // namespace driftbench
