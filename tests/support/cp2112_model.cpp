#include "support/cp2112_model.h"

#include <algorithm>
#include <limits>

namespace driftbench::test {

namespace {

constexpr std::size_t kPiece = 61;
constexpr std::uint8_t kComplete = 2;
constexpr std::uint8_t kError = 3;

// The shortest form of each transfer report, and how many of its bytes say how long the rest is.
bool wholeTransfer(const Report &report)
{
    switch (report[0]) {
    case 0x10:
        return report.size() >= 4;
    case 0x11:
        return report.size() >= 5 && report[4] <= 16 && report.size() >= 5u + report[4];
    case 0x14:
        return report.size() >= 3 && report[2] <= kPiece && report.size() >= 3u + report[2];
    default:
        return false;
    }
}

} // namespace

Cp2112Model::Cp2112Model(SimulatedClock &clock, I2cBusModel &bus)
    : HidModel(clock, {0x10C4, 0xEA90, "Silicon Laboratories", "CP2112 HID USB-to-SMBus Bridge", "00A1B2C3",
                       "model:cp2112", 0})
    , m_bus(bus)
{
}

Status Cp2112Model::take(const Report &report)
{
    switch (report[0]) {
    case 0x10:
    case 0x11:
    case 0x14:
        if (!wholeTransfer(report) || (report[1] & 1) != 0)
            return refused();
        if (!busy())
            begin(report);
        return {};
    case 0x12:
        if (report.size() < 3)
            return refused();
        fetch(static_cast<std::size_t>(report[1]) << 8 | report[2]);
        return {};
    case 0x15:
        if (report.size() >= 2 && report[1] == 1)
            answer(status(), nowS() + kFrameS);
        return {};
    case 0x17:
        m_bus.recover();
        m_state = 0;
        m_read.clear();
        m_given = 0;
        return {};
    default:
        return refused();
    }
}

Result<Report> Cp2112Model::feature(std::uint8_t id)
{
    if (id == 0x05)
        return Report{0x05, 0x0C, 0x02};
    return refused();
}

Status Cp2112Model::takeFeature(const Report &report)
{
    if (report.size() < 14 || report[0] != 0x06 || report[6] != 0)
        return refused();
    m_bus.setKHz((report[1] << 24 | report[2] << 16 | report[3] << 8 | report[4]) / 1000.0);
    m_timeoutS = (report[9] << 8 | report[10]) * 1e-3;
    m_retries = report[12] << 8 | report[13];
    return {};
}

void Cp2112Model::begin(const Report &report)
{
    m_read.clear();
    m_given = 0;
    const std::uint8_t address = report[1] >> 1;
    if (report[0] == 0x14) {
        const Report bytes(report.begin() + 3, report.begin() + 3 + report[2]);
        finish(m_bus.write(address, bytes), bytes.size());
        return;
    }
    std::size_t written = 0;
    if (report[0] == 0x11) {
        const Report target(report.begin() + 5, report.begin() + 5 + report[4]);
        written = target.size() + 1;
        if (const Outcome outcome = m_bus.write(address, target); outcome != Outcome::Done) {
            finish(outcome, written);
            return;
        }
    }
    const std::size_t length = static_cast<std::size_t>(report[2]) << 8 | report[3];
    if (length < 1 || length > 512) {
        m_state = 0;
        return;
    }
    const Outcome outcome = m_bus.read(address, length, m_read);
    finish(outcome, written + length);
}

void Cp2112Model::finish(Outcome outcome, std::size_t bytes)
{
    constexpr double kForEver = std::numeric_limits<double>::infinity();
    m_state = outcome == Outcome::Done ? kComplete : kError;
    switch (outcome) {
    case Outcome::Done:
        m_condition = 5;
        m_doneS = nowS() + m_bus.durationS(bytes);
        return;
    case Outcome::NoAcknowledge:
        m_condition = 0;
        m_doneS = m_retries > 0    ? nowS() + m_bus.durationS(0) * (m_retries + 1)
                  : m_timeoutS > 0 ? nowS() + m_timeoutS
                                   : kForEver;
        return;
    case Outcome::HeldLow:
        m_condition = 1;
        m_doneS = m_timeoutS > 0 ? nowS() + m_timeoutS : kForEver;
        return;
    }
}

void Cp2112Model::fetch(std::size_t wanted)
{
    while (wanted > 0) {
        const std::size_t there = busy() ? 0 : m_read.size() - m_given;
        const std::size_t most = std::min({kPiece, wanted, there});
        const std::size_t count = most > 0 ? piece(most) : 0;
        Report reply(64);
        reply[0] = 0x13;
        reply[1] = busy() ? 1 : m_state;
        reply[2] = static_cast<std::uint8_t>(count);
        std::copy_n(m_read.begin() + static_cast<std::ptrdiff_t>(m_given), count, reply.begin() + 3);
        m_given += count;
        answer(reply, nowS() + kFrameS);
        // What was asked for beyond one report follows by itself; a short piece ends it.
        wanted = count == kPiece ? wanted - count : 0;
    }
}

Report Cp2112Model::status() const
{
    Report reply(64);
    reply[0] = 0x16;
    reply[1] = busy() ? 1 : m_state;
    reply[2] = busy() ? 2 : m_condition;
    const std::size_t bytes = busy() ? 0 : m_read.size();
    reply[5] = static_cast<std::uint8_t>(bytes >> 8);
    reply[6] = static_cast<std::uint8_t>(bytes & 0xFF);
    return reply;
}

} // namespace driftbench::test
