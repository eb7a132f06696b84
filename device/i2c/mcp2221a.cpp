#include "device/i2c/mcp2221a.h"

#include "device/i2c/hid_exchange.h"

#include <algorithm>

namespace driftbench {

using namespace mcp2221a;

namespace {

// An answer takes two USB frames of 1 ms; a busy host may take much longer.
constexpr std::chrono::milliseconds kReplyTimeout(500);
// Every poll takes at least 1 ms, and no transfer here lasts 40 ms (192 bytes at 47 kHz).
constexpr int kMostPolls = 100;
constexpr int kMostCancels = 3;
constexpr std::size_t kLongestRead = 192; // the chip takes 65535; a gyro's FIFO holds 192

} // namespace

Mcp2221a::Mcp2221a(std::unique_ptr<HidTransport> transport)
    : m_transport(std::move(transport)), m_name(bridgeName("MCP2221A", m_transport->identity()))
{
}

I2cLimits Mcp2221a::limits() const
{
    return {kDataPerReport, kLongestRead, kDataPerReport, kSlowestKHz, kFastestKHz};
}

Result<std::unique_ptr<Mcp2221a>> Mcp2221a::open(std::unique_ptr<HidTransport> transport, int kHz)
{
    if (kHz < kSlowestKHz || kHz > kFastestKHz)
        return Error{Errc::InvalidOption, "The MCP2221A can't run I2C at " + std::to_string(kHz) +
                                              " kHz; choose " + std::to_string(kSlowestKHz) + " to " +
                                              std::to_string(kFastestKHz) + "."};
    std::unique_ptr<Mcp2221a> bus(new Mcp2221a(std::move(transport)));
    if (const Status ok = bus->prepare(kHz); !ok)
        return ok.error();
    return bus;
}

Status Mcp2221a::prepare(int kHz)
{
    m_untidy = true; // a former user may have left a transfer half done
    if (const Status ok = tidy(); !ok)
        return ok;
    for (int poll = 0; poll < kMostPolls; ++poll) {
        const Result<StatusReply> reply = status(speedRequest(kHz));
        if (!reply)
            return reply.error();
        if (!reply->sclHigh || !reply->sdaHigh)
            return Error{Errc::BusStuck, "The " + std::string(reply->sclHigh ? "SDA" : "SCL") +
                                             " line of the I2C bus on " + m_name +
                                             " is low; check the pull-up resistors, then switch the sensor "
                                             "off and on."};
        if (reply->speedSet)
            return {};
    }
    return Error{Errc::DeviceRefused, m_name + " does not take an I2C speed of " + std::to_string(kHz) +
                                          " kHz; unplug it and plug it in again."};
}

Status Mcp2221a::transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    if (const Status ok = tidy(); !ok)
        return ok;
    if (const Status ok = begin(writeRequest(Command::Write, address, bytes), address); !ok)
        return ok;
    return finishWrite(address);
}

Status Mcp2221a::transferRead(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    if (const Status ok = tidy(); !ok)
        return ok;
    const auto length = static_cast<std::uint16_t>(bytes.size());
    if (const Status ok = begin(readRequest(Command::Read, address, length), address); !ok)
        return ok;
    return collect(address, bytes);
}

Status Mcp2221a::transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                       std::span<std::uint8_t> bytes)
{
    if (const Status ok = tidy(); !ok)
        return ok;
    if (const Status ok = begin(writeRequest(Command::WriteWithoutStop, address, written), address); !ok)
        return ok;
    const auto length = static_cast<std::uint16_t>(bytes.size());
    if (const Status ok = begin(readRequest(Command::ReadAfterRepeatedStart, address, length), address); !ok)
        return ok;
    return collect(address, bytes);
}

Result<std::span<const std::uint8_t>> Mcp2221a::exchange(const Request &request)
{
    if (const Status ok = m_transport->write(request); !ok)
        return ok.error();
    const Result<std::span<const std::uint8_t>> reply =
        awaitReport(*m_transport, request[1], request[1], m_reply, kReplyTimeout);
    if (reply && reply->empty()) {
        m_untidy = true;
        return bridgeSilent(m_name);
    }
    return reply;
}

Result<StatusReply> Mcp2221a::status(const Request &request)
{
    const Result<std::span<const std::uint8_t>> report = exchange(request);
    if (!report)
        return report.error();
    const std::optional<StatusReply> reply = decodeStatus(*report);
    if (!reply)
        return Error{Errc::DamagedReport,
                     "The status of " + m_name + " can't be read; no other program may use the bridge."};
    return *reply;
}

Status Mcp2221a::tidy()
{
    if (!m_untidy)
        return {};
    if (const Status ok = discardReports(*m_transport); !ok)
        return ok;
    if (const Status ok = cancel(); !ok)
        return ok;
    m_untidy = false;
    return {};
}

// Requests are refused while the engine still works on the one before; asking again is cheaper than asking
// for the status first.
Status Mcp2221a::begin(const Request &request, std::uint8_t address)
{
    for (int poll = 0; poll < kMostPolls; ++poll) {
        const Result<std::span<const std::uint8_t>> report = exchange(request);
        if (!report)
            return report.error();
        const std::optional<bool> accepted = decodeAccepted(*report, static_cast<Command>(request[1]));
        if (!accepted)
            return damagedReply(address);
        if (*accepted)
            return {};
        const Result<StatusReply> reply = status(statusRequest());
        if (!reply)
            return reply.error();
        if (reply->engine == Engine::NoAcknowledge || reply->engine == Engine::TimedOut)
            break;
    }
    return giveUp(address);
}

Status Mcp2221a::finishWrite(std::uint8_t address)
{
    for (int poll = 0; poll < kMostPolls; ++poll) {
        const Result<StatusReply> reply = status(statusRequest());
        if (!reply)
            return reply.error();
        if (reply->engine == Engine::Idle)
            return {};
        if (reply->engine != Engine::Working)
            break;
    }
    return giveUp(address);
}

Status Mcp2221a::collect(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    std::size_t got = 0;
    for (int poll = 0; poll < kMostPolls; ++poll) {
        const Result<std::span<const std::uint8_t>> report = exchange(getDataRequest());
        if (!report)
            return report.error();
        const std::optional<DataReply> reply = decodeData(*report);
        if (!reply || reply->bytes.size() > bytes.size() - got) {
            if (const Status ok = cancel(); !ok)
                return ok;
            return damagedReply(address);
        }
        if (reply->state == DataReply::State::Failed)
            break;
        if (reply->engine == Engine::NoAcknowledge || reply->engine == Engine::TimedOut)
            break;
        std::copy(reply->bytes.begin(), reply->bytes.end(), bytes.begin() + static_cast<std::ptrdiff_t>(got));
        got += reply->bytes.size();
        if (got == bytes.size())
            return {};
    }
    return giveUp(address);
}

// Asks what went wrong before the cancel wipes it out.
Status Mcp2221a::giveUp(std::uint8_t address)
{
    const Result<StatusReply> reply = status(statusRequest());
    if (!reply)
        return reply.error();
    if (const Status ok = cancel(); !ok)
        return ok;
    return reply->engine == Engine::NoAcknowledge ? noAcknowledge(address) : stuck(address);
}

// A transfer on a bus that is held low is only marked for cancelling; the clock pulses of the next try may
// free the line.
Status Mcp2221a::cancel()
{
    for (int attempt = 0; attempt < kMostCancels; ++attempt) {
        if (const Result<StatusReply> reply = status(cancelRequest()); !reply)
            return reply.error();
        const Result<StatusReply> after = status(statusRequest());
        if (!after)
            return after.error();
        if (after->engine == Engine::Idle && after->sclHigh && after->sdaHigh)
            break;
    }
    return {};
}

} // namespace driftbench
