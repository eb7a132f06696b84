#include "device/i2c/cp2112.h"

#include "device/i2c/hid_exchange.h"

#include <algorithm>

namespace driftbench {

using namespace cp2112;

namespace {

constexpr std::chrono::milliseconds kReplyTimeout(500);
// Every poll takes at least 1 ms; the chip's own timeouts end a transfer after 0.2 s at most.
constexpr int kMostPolls = 1000;
// Answers without data while the chip is still moving it.
constexpr int kMostEmptyFetches = 20;

} // namespace

Cp2112::Cp2112(std::unique_ptr<HidTransport> transport)
    : m_transport(std::move(transport)), m_name(bridgeName("CP2112", m_transport->identity()))
{
}

I2cLimits Cp2112::limits() const
{
    return {kDataPerReport, kLongestRead, kLongestTarget, kSlowestKHz, kFastestKHz};
}

Result<std::unique_ptr<Cp2112>> Cp2112::open(std::unique_ptr<HidTransport> transport, int kHz)
{
    if (kHz < kSlowestKHz || kHz > kFastestKHz)
        return Error{Errc::InvalidOption, "The CP2112 can't run I2C at " + std::to_string(kHz) +
                                              " kHz; choose " + std::to_string(kSlowestKHz) + " to " +
                                              std::to_string(kFastestKHz) + "."};
    std::unique_ptr<Cp2112> bus(new Cp2112(std::move(transport)));
    if (const Status ok = bus->prepare(kHz); !ok)
        return ok.error();
    return bus;
}

Status Cp2112::prepare(int kHz)
{
    if (const Status ok = cancel(); !ok)
        return ok;
    return m_transport->sendFeature(configRequest(kHz));
}

Status Cp2112::transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    return run(writeRequest(address, bytes), address);
}

Status Cp2112::transferRead(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    const auto length = static_cast<std::uint16_t>(bytes.size());
    if (const Status ok = run(readRequest(address, length), address); !ok)
        return ok;
    return fetch(address, bytes);
}

Status Cp2112::transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                     std::span<std::uint8_t> bytes)
{
    const auto length = static_cast<std::uint16_t>(bytes.size());
    if (const Status ok = run(writeReadRequest(address, written, length), address); !ok)
        return ok;
    return fetch(address, bytes);
}

// Starts a transfer and waits until the chip has ended it.
Status Cp2112::run(const Request &request, std::uint8_t address)
{
    if (const Status ok = m_transport->write(request); !ok)
        return ok;
    Progress progress = Progress::Busy;
    for (int poll = 0; poll < kMostPolls && progress == Progress::Busy; ++poll) {
        const Result<std::span<const std::uint8_t>> report = exchange(statusRequest(), kStatusResponse);
        if (!report)
            return report.error();
        const std::optional<StatusReply> reply = decodeStatus(*report);
        if (!reply)
            return damagedReply(address);
        progress = reply->progress;
    }
    if (progress == Progress::Complete)
        return {};
    if (const Status ok = cancel(); !ok)
        return ok;
    if (progress == Progress::Idle)
        return Error{Errc::DeviceRefused, m_name + " did not take a transfer with I2C address " +
                                              hexByte(address) + "; no other program may use the bridge."};
    return progress == Progress::NoAcknowledge ? noAcknowledge(address) : stuck(address);
}

Status Cp2112::fetch(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    std::size_t got = 0;
    for (int empty = 0; empty < kMostEmptyFetches;) {
        const std::size_t wanted = std::min(kDataPerReport, bytes.size() - got);
        const Result<std::span<const std::uint8_t>> report =
            exchange(fetchRequest(static_cast<std::uint16_t>(wanted)), kReadResponse);
        if (!report)
            return report.error();
        const std::optional<std::span<const std::uint8_t>> data = decodeData(*report);
        if (!data || data->size() > wanted)
            break;
        std::copy(data->begin(), data->end(), bytes.begin() + static_cast<std::ptrdiff_t>(got));
        got += data->size();
        if (got == bytes.size())
            return {};
        empty = data->empty() ? empty + 1 : 0;
    }
    if (const Status ok = cancel(); !ok)
        return ok;
    return damagedReply(address);
}

Result<std::span<const std::uint8_t>> Cp2112::exchange(const Request &request, std::uint8_t answer)
{
    if (const Status ok = m_transport->write(request); !ok)
        return ok.error();
    const Result<std::span<const std::uint8_t>> reply =
        awaitReport(*m_transport, answer, answer, m_reply, kReplyTimeout);
    if (reply && reply->empty())
        return bridgeSilent(m_name);
    return reply;
}

Status Cp2112::cancel()
{
    if (const Status ok = m_transport->write(cancelRequest()); !ok)
        return ok;
    return discardReports(*m_transport);
}

} // namespace driftbench
