#include "support/mcp2221a_model.h"

#include <algorithm>

namespace driftbench::test {

namespace {

constexpr std::size_t kReport = 64;
constexpr std::size_t kPiece = 60;
constexpr double kStartTimeoutS = 0.03;

} // namespace

Mcp2221aModel::Mcp2221aModel(SimulatedClock &clock, I2cBusModel &bus)
    : HidModel(clock, {0x04D8, 0x00DD, "Microchip Technology Inc.", "MCP2221 USB-I2C/UART Combo",
                       "0002137645", "model:mcp2221a", 2})
    , m_bus(bus)
{
}

Status Mcp2221aModel::take(const Report &written)
{
    if (written.size() != kReport + 1 || written[0] != 0)
        return refused();
    const Report request(written.begin() + 1, written.end());
    settle();
    switch (request[0]) {
    case 0x10:
        answer(status(request), nowS() + kFrameS);
        return {};
    case 0x40:
        answer(data(), nowS() + kFrameS);
        return {};
    case 0x90:
    case 0x91:
    case 0x93:
    case 0x94:
        answer(transfer(request), nowS() + kFrameS);
        return {};
    default: {
        Report unknown(kReport);
        unknown[0] = request[0];
        unknown[1] = 0x01;
        answer(unknown, nowS() + kFrameS);
        return {};
    }
    }
}

Result<Report> Mcp2221aModel::feature(std::uint8_t)
{
    return refused();
}

Status Mcp2221aModel::takeFeature(const Report &)
{
    return refused();
}

void Mcp2221aModel::settle()
{
    if (nowS() < m_doneS)
        return;
    if (m_failed) {
        m_doing = Doing::NotAcknowledged;
        m_failed = false;
    }
    if (m_doing == Doing::Writing)
        m_doing = m_stop ? Doing::Nothing : Doing::HoldingBus;
}

std::uint8_t Mcp2221aModel::engine() const
{
    const bool working = nowS() < m_doneS;
    switch (m_doing) {
    case Doing::Nothing:
        return 0x00;
    case Doing::Writing:
        return 0x41;
    case Doing::HoldingBus:
        return 0x45;
    case Doing::Reading:
        return working ? 0x50 : 0x55;
    case Doing::NotAcknowledged:
        return 0x25;
    case Doing::Starting:
        return working ? 0x10 : 0x12;
    }
    return 0xFF;
}

Report Mcp2221aModel::status(const Report &request)
{
    Report reply(kReport);
    reply[0] = 0x10;
    if (request[2] == 0x10) {
        m_bus.recover();
        reply[2] = m_doing == Doing::Nothing ? 0x11 : 0x10;
        if (m_doing != Doing::Starting || !m_bus.heldLow()) {
            m_doing = Doing::Nothing;
            m_failed = false;
            m_doneS = nowS();
        }
    }
    if (request[3] == 0x20) {
        const bool takes = m_doing == Doing::Nothing;
        reply[3] = takes ? 0x20 : 0x21;
        reply[4] = request[4];
        if (takes)
            m_bus.setKHz(12000.0 / (request[4] + 3));
    }
    reply[8] = engine();
    reply[20] = m_doing == Doing::NotAcknowledged ? 0x40 : 0x00;
    reply[22] = 1;
    reply[23] = m_bus.heldLow() ? 0 : 1;
    reply[46] = 'A';
    return reply;
}

Report Mcp2221aModel::transfer(const Report &request)
{
    Report reply(kReport);
    reply[0] = request[0];
    const bool continues = request[0] == 0x93;
    const bool fits = continues ? m_doing == Doing::HoldingBus : m_doing == Doing::Nothing;
    if (!fits) {
        reply[1] = 0x01;
        reply[2] = engine();
        return reply;
    }
    if (request[0] == 0x90 || request[0] == 0x94)
        startWrite(request);
    else
        startRead(request);
    return reply;
}

void Mcp2221aModel::startWrite(const Report &request)
{
    const std::size_t length = std::min<std::size_t>(request[1] | request[2] << 8, kPiece);
    const auto from = request.begin() + 4;
    const Outcome outcome =
        m_bus.write(request[3] >> 1, Report(from, from + static_cast<std::ptrdiff_t>(length)));
    m_doing = outcome == Outcome::HeldLow ? Doing::Starting : Doing::Writing;
    m_failed = outcome == Outcome::NoAcknowledge;
    m_stop = request[0] == 0x90;
    m_doneS =
        nowS() + (outcome == Outcome::HeldLow ? kStartTimeoutS : m_bus.durationS(m_failed ? 0 : length));
}

void Mcp2221aModel::startRead(const Report &request)
{
    m_read.clear();
    m_given = 0;
    const std::size_t length = request[1] | request[2] << 8;
    const Outcome outcome = m_bus.read(request[3] >> 1, length, m_read);
    m_doing = outcome == Outcome::HeldLow ? Doing::Starting : Doing::Reading;
    m_failed = outcome == Outcome::NoAcknowledge;
    m_doneS =
        nowS() + (outcome == Outcome::HeldLow ? kStartTimeoutS : m_bus.durationS(m_failed ? 0 : length));
}

// The chip reads into a buffer of 60 bytes and hands it over when it is full, or at the end.
Report Mcp2221aModel::data()
{
    Report reply(kReport);
    reply[0] = 0x40;
    const std::size_t rest = m_read.size() - m_given;
    const std::size_t whole = std::min(kPiece, rest);
    const double readyS = m_doneS - m_bus.durationS(rest - whole);
    if (m_doing != Doing::Reading || m_failed || nowS() < readyS) {
        reply[1] = 0x41;
        reply[2] = engine();
        reply[3] = 127;
        return reply;
    }
    const std::size_t count = piece(whole);
    std::copy_n(m_read.begin() + static_cast<std::ptrdiff_t>(m_given), count, reply.begin() + 4);
    m_given += count;
    reply[2] = m_given == m_read.size() ? 0x55 : 0x54;
    reply[3] = static_cast<std::uint8_t>(count);
    if (m_given == m_read.size())
        m_doing = Doing::Nothing;
    return reply;
}

} // namespace driftbench::test
