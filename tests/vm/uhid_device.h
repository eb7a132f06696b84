// A HID device for the kernel that this program runs under, by /dev/uhid: what the kernel asks goes to a
// HidTransport, what that one sends goes to the kernel, whose hidraw then has it like any other device's.
//
// The device must be thread-safe: input reports are read on one thread, requests come on another.
#pragma once

#include "support/report_pump.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

struct uhid_event;

namespace driftbench::test {

class UhidDevice
{
public:
    // Plugged in; device must outlive it. onInput is told, on a thread of its own, of each input report that
    // the kernel has taken. DeviceNotPermitted where there is no /dev/uhid to be opened.
    static Result<std::unique_ptr<UhidDevice>>
    create(HidTransport &device, std::span<const std::uint8_t> descriptor, ReportSink onInput = {});
    ~UhidDevice();
    UhidDevice(const UhidDevice &) = delete;
    UhidDevice &operator=(const UhidDevice &) = delete;

private:
    UhidDevice(int node, HidTransport &device, ReportSink onInput);

    void start();
    void destroy(); // once; the kernel sees the device go
    void serve(const std::stop_token &stop);
    void answer(const uhid_event &event);
    void answerGet(const uhid_event &event);
    void answerSet(const uhid_event &event);
    bool send(const uhid_event &event); // whether the kernel has taken it
    void deliver(std::span<const std::uint8_t> report);

    int m_node;
    HidTransport &m_device;
    ReportSink m_onInput;
    std::mutex m_mutex; // of m_gone and of what goes to the node
    bool m_gone = false;
    std::optional<ReportPump> m_pump;
    std::jthread m_server;
};

} // namespace driftbench::test
