#include "vm/uhid_device.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

namespace driftbench::test {

namespace {

constexpr int kPollMs = 20; // how soon the server hears that it is to stop

void copyText(__u8 *to, std::size_t size, const std::string &text)
{
    std::copy_n(text.begin(), std::min(text.size(), size - 1), to);
}

uhid_event creation(const HidIdentity &identity, std::span<const std::uint8_t> descriptor)
{
    uhid_event event{};
    event.type = UHID_CREATE2;
    copyText(event.u.create2.name, sizeof event.u.create2.name, identity.product);
    copyText(event.u.create2.uniq, sizeof event.u.create2.uniq, identity.serial);
    event.u.create2.bus = BUS_USB;
    event.u.create2.vendor = identity.vendorId;
    event.u.create2.product = identity.productId;
    event.u.create2.rd_size = static_cast<__u16>(descriptor.size());
    std::copy(descriptor.begin(), descriptor.end(), event.u.create2.rd_data);
    return event;
}

} // namespace

Result<std::unique_ptr<UhidDevice>>
UhidDevice::create(HidTransport &device, std::span<const std::uint8_t> descriptor, ReportSink onInput)
{
    const int node = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
    const uhid_event event = creation(device.identity(), descriptor);
    if (node < 0 || ::write(node, &event, sizeof event) != sizeof event) {
        const std::string reason = std::strerror(errno);
        if (node >= 0)
            ::close(node);
        return Error{Errc::DeviceNotPermitted,
                     "No device can be made by /dev/uhid (" + reason + "); load uhid and be root."};
    }
    std::unique_ptr<UhidDevice> made(new UhidDevice(node, device, std::move(onInput)));
    made->start();
    return made;
}

UhidDevice::UhidDevice(int node, HidTransport &device, ReportSink onInput)
    : m_node(node), m_device(device), m_onInput(std::move(onInput))
{
}

UhidDevice::~UhidDevice()
{
    destroy();
    m_server.request_stop();
    m_server.join();
    m_pump.reset();
    ::close(m_node);
}

void UhidDevice::start()
{
    m_server = std::jthread([this](const std::stop_token &stop) { serve(stop); });
    m_pump.emplace(
        m_device, [this](std::span<const std::uint8_t> report) { deliver(report); }, [this] { destroy(); });
}

void UhidDevice::destroy()
{
    const std::lock_guard lock(m_mutex);
    if (m_gone)
        return;
    m_gone = true;
    uhid_event event{};
    event.type = UHID_DESTROY;
    static_cast<void>(::write(m_node, &event, sizeof event));
}

void UhidDevice::serve(const std::stop_token &stop)
{
    while (!stop.stop_requested()) {
        pollfd waiting{m_node, POLLIN, 0};
        if (::poll(&waiting, 1, kPollMs) <= 0)
            continue;
        uhid_event event{};
        if (::read(m_node, &event, sizeof event) > 0)
            answer(event);
    }
}

void UhidDevice::answer(const uhid_event &event)
{
    switch (event.type) {
    case UHID_OUTPUT:
        static_cast<void>(m_device.write({&event.u.output.data[0], event.u.output.size}));
        break;
    case UHID_GET_REPORT:
        answerGet(event);
        break;
    case UHID_SET_REPORT:
        answerSet(event);
        break;
    default:
        break;
    }
}

void UhidDevice::answerGet(const uhid_event &event)
{
    uhid_event reply{};
    reply.type = UHID_GET_REPORT_REPLY;
    reply.u.get_report_reply.id = event.u.get_report.id;
    const std::span<std::uint8_t> report(&reply.u.get_report_reply.data[0], UHID_DATA_MAX);
    report[0] = event.u.get_report.rnum;
    const auto got = m_device.getFeature(report);
    if (!got && got.error().code == Errc::DeviceUnplugged)
        return destroy();
    reply.u.get_report_reply.size = static_cast<__u16>(got ? *got : 0);
    reply.u.get_report_reply.err = got ? 0 : EIO;
    send(reply);
}

void UhidDevice::answerSet(const uhid_event &event)
{
    uhid_event reply{};
    reply.type = UHID_SET_REPORT_REPLY;
    reply.u.set_report_reply.id = event.u.set_report.id;
    const Status done = m_device.sendFeature({&event.u.set_report.data[0], event.u.set_report.size});
    if (!done && done.error().code == Errc::DeviceUnplugged)
        return destroy();
    reply.u.set_report_reply.err = done ? 0 : EIO;
    send(reply);
}

void UhidDevice::deliver(std::span<const std::uint8_t> report)
{
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(report.size());
    std::copy(report.begin(), report.end(), event.u.input2.data);
    if (send(event) && m_onInput)
        m_onInput(report);
}

// Fails only once the kernel has let go of the device.
bool UhidDevice::send(const uhid_event &event)
{
    const std::lock_guard lock(m_mutex);
    return !m_gone && ::write(m_node, &event, sizeof event) == sizeof event;
}

} // namespace driftbench::test
