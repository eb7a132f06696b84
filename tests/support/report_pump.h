// Carries input reports from a device to whatever shows it to the kernel or to libhidapi, on a thread of its
// own, until the device is gone or the pump is destroyed.
#pragma once

#include "device/hid_transport.h"

#include <functional>
#include <thread>

namespace driftbench::test {

using ReportSink = std::function<void(std::span<const std::uint8_t>)>;

class ReportPump
{
public:
    // The device must outlive the pump. onGone is called on the pump's thread, once, if the device goes
    // first.
    ReportPump(HidTransport &device, ReportSink sink, std::function<void()> onGone);

private:
    std::jthread m_thread;
};

} // namespace driftbench::test
