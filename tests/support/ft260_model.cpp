#include "support/ft260_model.h"

#include <algorithm>

namespace driftbench::test {

namespace {

constexpr std::size_t kPiece = 60;
constexpr double kSleepAfterS = 5.0;
constexpr std::uint8_t kStart = 2;
constexpr std::uint8_t kRepeated = 1; // beside start
constexpr std::uint8_t kStop = 4;
constexpr std::uint8_t kFailed = 0x02;
constexpr std::uint8_t kAddressNoAck = 0x04;
constexpr std::uint8_t kArbitrationLost = 0x10;

} // namespace

Ft260Model::Ft260Model(SimulatedClock &clock, I2cBusModel &bus, int interfaceNumber)
    : HidModel(clock, {0x0403, 0x6030, "FTDI", "FT260", "FT5Q1Z7A", "model:ft260", interfaceNumber})
    , m_bus(bus)
    , m_activeS(clock.nowS())
{
}

bool Ft260Model::asleep() const
{
    return nowS() - m_activeS > kSleepAfterS;
}

Status Ft260Model::take(const Report &report)
{
    if (asleep()) {
        ++m_lostInSleep;
        m_activeS = nowS(); // the report wakes it and is gone
        return {};
    }
    m_activeS = nowS();
    if (!m_enabled || identity().interfaceNumber != 0)
        return refused();
    if (report[0] >= 0xD0 && report[0] <= 0xDE) {
        startWrite(report);
        return {};
    }
    if (report[0] == 0xC2 && report.size() >= 5) {
        startRead(report);
        return {};
    }
    return refused();
}

Result<Report> Ft260Model::feature(std::uint8_t id)
{
    m_activeS = nowS();
    switch (id) {
    case 0xA0:
        return Report{0xA0, 0x02, 0x60, 0x02, 0x00, 0, 0, 0, 0, 0, 0, 0, 0};
    case 0xA1: {
        Report reply(26);
        reply[0] = 0xA1;
        reply[1] = identity().interfaceNumber == 0 ? 1 : 2;
        reply[2] = 2;
        reply[4] = 1;
        reply[5] = m_enabled ? 1 : 0;
        return reply;
    }
    case 0xC0: {
        const bool busy = nowS() < m_doneS;
        const auto kHz = static_cast<int>(m_bus.kHz());
        std::uint8_t bits = busy ? 0x01 : static_cast<std::uint8_t>(0x20 | m_error);
        if (m_open || m_bus.heldLow())
            bits |= 0x40;
        return Report{0xC0, bits, static_cast<std::uint8_t>(kHz & 0xFF), static_cast<std::uint8_t>(kHz >> 8),
                      0};
    }
    default:
        return refused();
    }
}

Status Ft260Model::takeFeature(const Report &report)
{
    m_activeS = nowS();
    if (report.size() < 2 || report[0] != 0xA1)
        return refused();
    switch (report[1]) {
    case 0x02:
        m_enabled = report.size() >= 3 && report[2] == 1;
        return {};
    case 0x20:
        m_bus.recover();
        m_open = false;
        m_error = 0;
        m_doneS = nowS();
        dropAnswers();
        return {};
    case 0x22:
        if (report.size() < 4)
            return refused();
        m_bus.setKHz(report[2] | report[3] << 8);
        return {};
    default:
        return refused();
    }
}

// Whether the conditions fit what was before; if not, the controller reports an error.
bool Ft260Model::begin(std::uint8_t conditions, std::uint8_t address)
{
    const bool starts = (conditions & kStart) != 0;
    const bool repeated = starts && (conditions & kRepeated) != 0;
    if (nowS() < m_doneS || starts == (m_open && !repeated) || (repeated && !m_open) || address > 0x7F) {
        m_error = kFailed | kArbitrationLost;
        return false;
    }
    m_open = true;
    m_error = 0;
    return true;
}

void Ft260Model::note(Outcome outcome, std::size_t bytes)
{
    m_doneS = nowS() + m_bus.durationS(outcome == Outcome::Done ? bytes : 0);
    if (outcome == Outcome::NoAcknowledge)
        m_error = kFailed | kAddressNoAck;
    if (outcome == Outcome::HeldLow)
        m_error = kFailed | kArbitrationLost;
    if (outcome != Outcome::Done)
        m_open = false;
}

void Ft260Model::startWrite(const Report &report)
{
    const std::size_t length = report.size() > 3 ? report[3] : 0;
    if (length < 1 || length > kPiece || report[0] != 0xD0 + (length - 1) / 4 || report.size() < 4 + length) {
        m_error = kFailed;
        return;
    }
    if (!begin(report[2], report[1]))
        return;
    const auto from = report.begin() + 4;
    note(m_bus.write(report[1], Report(from, from + static_cast<std::ptrdiff_t>(length))), length);
    if ((report[2] & kStop) != 0)
        m_open = false;
}

void Ft260Model::startRead(const Report &report)
{
    if (!begin(report[2], report[1]))
        return;
    const std::size_t length = report[3] | static_cast<std::size_t>(report[4]) << 8;
    const double beganS = nowS();
    Report bytes;
    const Outcome outcome = m_bus.read(report[1], length, bytes);
    note(outcome, length);
    if ((report[2] & kStop) != 0)
        m_open = false;
    for (std::size_t given = 0; given < bytes.size();) {
        const std::size_t count = piece(std::min(kPiece, bytes.size() - given));
        Report reply(64);
        reply[0] = static_cast<std::uint8_t>(0xD0 + (count - 1) / 4);
        reply[1] = static_cast<std::uint8_t>(count);
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(given), count, reply.begin() + 2);
        given += count;
        answer(reply, beganS + m_bus.durationS(given) + kFrameS);
    }
}

} // namespace driftbench::test
