// The native gyro bridge as its host sees it: info, configuration, status and the commands for tables, over
// any HidTransport. docs/bridge-protocol.md has the rules that are kept here:
//
// - info is read first, and another major version ends it there (ProtocolVersion);
// - after each set the status is read until it shows the command and what it was to bring about; where it
// does
//   not in time (2 s for the first chunk and for verify, else 500 ms), the set is repeated, three times in
//   all;
// - a set that the device stalls is one whose result stands in the status.
//
// Errors: those of the transport and of the codec; for a refused command DeviceRefused with the reason as a
// sentence, but WrongSensor where a table is for another sensor and TableMismatch where the flash holds other
// bytes than were announced (lastResult() has the protocol's own number); DeviceSilent where nothing
// happened.
#pragma once

#include "device/bridge/bridge_codec.h"
#include "device/hid_transport.h"
#include "device/host_clock.h"
#include "engine/base/progress.h"

#include <functional>
#include <memory>
#include <optional>

namespace driftbench {

class BridgeClient
{
public:
    // The clock must outlive the client.
    static Result<BridgeClient> open(std::unique_ptr<HidTransport> transport, HostClock &clock);

    const BridgeInfo &info() const { return m_info; }
    HidTransport &transport() { return *m_transport; }
    HostClock &clock() { return *m_clock; }
    const HidIdentity &identity() const { return m_transport->identity(); }
    std::string name() const; // "native bridge SIM-0001"

    Result<BridgeStatus> status();
    Result<BridgeConfig> config();
    Status configure(const BridgeConfig &config);

    Status beginTable(std::uint16_t transaction, std::uint32_t bytes, std::uint32_t crc);
    // bytes: BRIDGE_CHUNK_BYTES, or what is left in the last chunk.
    Status sendChunk(std::uint16_t transaction, std::uint32_t offset, std::span<const std::uint8_t> bytes);
    Status verifyTable(std::uint16_t transaction);
    Status commitTable(std::uint16_t transaction);
    Status activateTable(std::uint32_t generation);
    Status rollBackTable(std::uint32_t generation); // the active one, which is revoked

    // Up to BRIDGE_READ_BYTES bytes of a bank; fewer at the end of its image, none past it.
    Result<std::vector<std::uint8_t>> readBank(std::uint8_t bank, std::uint32_t offset, std::uint8_t length);
    // The first `bytes` bytes of a bank. TableMismatch if it holds fewer; Cancelled if the hook says Stop.
    Result<std::vector<std::uint8_t>> readImage(std::uint8_t bank, std::uint32_t bytes,
                                                const ProgressHook &hook = {});

    // BRIDGE_RESULT_* of the last command that was answered.
    std::uint8_t lastResult() const { return m_lastResult; }

private:
    using Done = std::function<Result<bool>(const BridgeStatus &)>;

    BridgeClient(std::unique_ptr<HidTransport> transport, HostClock &clock, BridgeInfo info)
        : m_transport(std::move(transport)), m_clock(&clock), m_info(std::move(info))
    {
    }
    Status command(const BridgeReport &report, double patienceS, const Done &done);
    Result<std::optional<Status>> answer(std::uint8_t command, const Done &done);
    Error refusal(std::uint8_t command);

    std::unique_ptr<HidTransport> m_transport;
    HostClock *m_clock;
    BridgeInfo m_info;
    std::uint8_t m_lastResult = BRIDGE_RESULT_OK;
};

} // namespace driftbench
