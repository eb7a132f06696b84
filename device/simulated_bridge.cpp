#include "device/simulated_bridge.h"

namespace driftbench {

Result<std::unique_ptr<HidTransport>> SimulatedBridge::open(std::shared_ptr<SimulatedBoard> board)
{
    const auto session = board->connect();
    if (!session)
        return session.error();
    return std::unique_ptr<HidTransport>(new SimulatedBridge(std::move(board), *session));
}

Result<std::size_t> SimulatedBridge::read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout)
{
    return m_board->read(m_session, report, std::chrono::duration<double>(timeout).count());
}

Status SimulatedBridge::write(std::span<const std::uint8_t>)
{
    return Error{Errc::DeviceRefused, "The simulated bridge takes no output reports; send feature reports."};
}

Result<std::size_t> SimulatedBridge::getFeature(std::span<std::uint8_t> report)
{
    return m_board->get(m_session, report);
}

Status SimulatedBridge::sendFeature(std::span<const std::uint8_t> report)
{
    return m_board->set(m_session, report);
}

} // namespace driftbench
