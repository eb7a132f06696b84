#include "device/i2c/ft260.h"

#include "device/i2c/hid_exchange.h"

#include <algorithm>

namespace driftbench {

using namespace ft260;

namespace {

// Between two looks at the status while data is awaited; a report of it takes less.
constexpr std::chrono::milliseconds kDataTimeout(20);
constexpr int kMostDataTimeouts = 25;
// Every poll of the status takes at least 1 ms, and no write here lasts 10 ms (63 bytes at 60 kHz).
constexpr int kMostPolls = 100;

} // namespace

Ft260::Ft260(std::unique_ptr<HidTransport> transport)
    : m_transport(std::move(transport)), m_name(bridgeName("FT260", m_transport->identity()))
{
}

I2cLimits Ft260::limits() const
{
    return {kDataPerReport, kLongestRead, kDataPerReport, kSlowestKHz, kFastestKHz};
}

Result<std::unique_ptr<Ft260>> Ft260::open(std::unique_ptr<HidTransport> transport, int kHz)
{
    if (kHz < kSlowestKHz || kHz > kFastestKHz)
        return Error{Errc::InvalidOption, "The FT260 can't run I2C at " + std::to_string(kHz) +
                                              " kHz; choose " + std::to_string(kSlowestKHz) + " to " +
                                              std::to_string(kFastestKHz) + "."};
    std::unique_ptr<Ft260> bus(new Ft260(std::move(transport)));
    if (const Status ok = bus->prepare(kHz); !ok)
        return ok.error();
    return bus;
}

Status Ft260::prepare(int kHz)
{
    if (const Status ok = checkChip(); !ok)
        return ok;
    if (const Status ok = m_transport->sendFeature(enableRequest()); !ok)
        return ok;
    if (const Status ok = reset(); !ok)
        return ok;
    return m_transport->sendFeature(speedRequest(kHz));
}

Status Ft260::checkChip()
{
    Feature version = versionQuery();
    const Result<std::size_t> versionSize = m_transport->getFeature(version);
    if (!versionSize)
        return versionSize.error();
    Feature feature = settingsQuery();
    const Result<std::size_t> size = m_transport->getFeature(feature);
    if (!size)
        return size.error();
    const auto bytes = [](const Feature &report, std::size_t count) {
        return std::span<const std::uint8_t>(report).first(std::min(count, report.size()));
    };
    const std::optional<Settings> settings = decodeSettings(bytes(feature, *size));
    if (!isFt260(bytes(version, *versionSize)) || !settings || !settings->i2cWired)
        return Error{Errc::DeviceRefused,
                     m_name + " is not the I2C interface of an FT260; open interface 0 and check that the "
                              "chip's mode pins enable I2C."};
    if (!settings->ready)
        return Error{Errc::DeviceRefused, m_name + " has no power for I2C yet; plug it into a port of the "
                                                   "computer instead of a hub."};
    return {};
}

Status Ft260::transferWrite(std::uint8_t address, std::span<const std::uint8_t> bytes)
{
    if (const Status ok = wake(address); !ok)
        return ok;
    return send(address, Start | Stop, bytes);
}

Status Ft260::transferRead(std::uint8_t address, std::span<std::uint8_t> bytes)
{
    if (const Status ok = wake(address); !ok)
        return ok;
    return receive(address, Start | Stop, bytes);
}

Status Ft260::transferWriteThenRead(std::uint8_t address, std::span<const std::uint8_t> written,
                                    std::span<std::uint8_t> bytes)
{
    if (const Status ok = wake(address); !ok)
        return ok;
    if (const Status ok = send(address, Start, written); !ok)
        return ok;
    return receive(address, RepeatedStart | Stop, bytes);
}

// A bus that is busy before we begin is held by somebody else: a sensor with a line low.
Status Ft260::wake(std::uint8_t address)
{
    Result<BusStatus> now = status();
    for (int poll = 0; now && (now->controllerBusy || now->busBusy) && poll < kMostPolls; ++poll)
        now = status();
    if (!now)
        return now.error();
    if (now->controllerBusy || now->busBusy)
        return fail(address, *now);
    return {};
}

Status Ft260::send(std::uint8_t address, std::uint8_t conditions, std::span<const std::uint8_t> bytes)
{
    if (const Status ok = m_transport->write(writeRequest(address, conditions, bytes)); !ok)
        return ok;
    Result<BusStatus> now = status();
    for (int poll = 0; now && now->controllerBusy && poll < kMostPolls; ++poll)
        now = status();
    if (!now)
        return now.error();
    if (now->failed || now->controllerBusy)
        return fail(address, *now);
    return {};
}

Status Ft260::receive(std::uint8_t address, std::uint8_t conditions, std::span<std::uint8_t> bytes)
{
    const auto length = static_cast<std::uint16_t>(bytes.size());
    if (const Status ok = m_transport->write(readRequest(address, conditions, length)); !ok)
        return ok;
    std::size_t got = 0;
    BusStatus now;
    for (int timeouts = 0; timeouts < kMostDataTimeouts;) {
        const Result<std::span<const std::uint8_t>> report =
            awaitReport(*m_transport, kFirstDataReport, kLastDataReport, m_reply, kDataTimeout);
        if (!report)
            return report.error();
        if (report->empty()) {
            ++timeouts;
            const Result<BusStatus> asked = status();
            if (!asked)
                return asked.error();
            now = *asked;
            if (now.failed)
                break;
            continue;
        }
        const std::optional<std::span<const std::uint8_t>> data = decodeData(*report);
        if (!data || data->size() > bytes.size() - got) {
            if (const Status ok = reset(); !ok)
                return ok;
            return damagedReply(address);
        }
        std::copy(data->begin(), data->end(), bytes.begin() + static_cast<std::ptrdiff_t>(got));
        got += data->size();
        if (got == bytes.size())
            return {};
    }
    return fail(address, now);
}

Result<BusStatus> Ft260::status()
{
    Feature feature = statusQuery();
    const Result<std::size_t> size = m_transport->getFeature(feature);
    if (!size)
        return size.error();
    const std::optional<BusStatus> now =
        decodeStatus(std::span<const std::uint8_t>(feature).first(std::min(*size, feature.size())));
    if (!now)
        return Error{Errc::DamagedReport,
                     "The status of " + m_name + " can't be read; no other program may use the bridge."};
    return *now;
}

Status Ft260::fail(std::uint8_t address, const BusStatus &status)
{
    if (const Status ok = reset(); !ok)
        return ok;
    return status.noAcknowledge && !status.arbitrationLost ? noAcknowledge(address) : stuck(address);
}

Status Ft260::reset()
{
    if (const Status ok = m_transport->sendFeature(resetRequest()); !ok)
        return ok;
    return discardReports(*m_transport);
}

} // namespace driftbench
