// What is connected to a simulated board: the HidTransport by which the host talks to it. One that was there
// when the board was unplugged stays unplugged; open another after it came back.
#pragma once

#include "device/simulated_board.h"

namespace driftbench {

class SimulatedBridge final : public HidTransport
{
public:
    // DeviceNotFound while the board is unplugged.
    static Result<std::unique_ptr<HidTransport>> open(std::shared_ptr<SimulatedBoard> board);

    const HidIdentity &identity() const override { return m_board->identity(); }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override;
    Status write(std::span<const std::uint8_t> report) override; // DeviceRefused: it has no output reports
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override;
    Status sendFeature(std::span<const std::uint8_t> report) override;

private:
    SimulatedBridge(std::shared_ptr<SimulatedBoard> board, int session)
        : m_board(std::move(board)), m_session(session)
    {
    }

    std::shared_ptr<SimulatedBoard> m_board;
    int m_session;
};

} // namespace driftbench
