#include "support/report_pump.h"

#include <array>

namespace driftbench::test {

namespace {

constexpr std::chrono::milliseconds kTimeout{5}; // how soon it hears that it is to stop

}

ReportPump::ReportPump(HidTransport &device, ReportSink sink, std::function<void()> onGone)
    : m_thread([&device, sink = std::move(sink), onGone = std::move(onGone)](const std::stop_token &stop) {
        std::array<std::uint8_t, 64> report;
        while (!stop.stop_requested()) {
            const auto length = device.read(report, kTimeout);
            if (!length)
                return onGone();
            if (*length > 0)
                sink(std::span(report).first(*length));
        }
    })
{
}

} // namespace driftbench::test
