// What the models of USB-HID bridges share: a report a millisecond each way, reports that wait to be read,
// and faults of the connection.
#pragma once

#include "device/hid_transport.h"
#include "device/simulated_clock.h"
#include "engine/base/random.h"

#include <deque>
#include <optional>
#include <vector>

namespace driftbench::test {

using Report = std::vector<std::uint8_t>;

class HidModel : public HidTransport
{
public:
    HidModel(SimulatedClock &clock, HidIdentity identity) : m_clock(clock), m_identity(std::move(identity)) {}

    // Faults.
    void unplugAfter(int calls) { m_callsUntilUnplugged = calls; }
    void goSilent(bool silent) { m_silent = silent; } // takes reports, answers none
    void inject(const Report &report) { m_input.push_front({report, m_clock.nowS()}); }
    void answerWithRandomBytes(std::uint64_t seed) { m_garbler.emplace(seed); }
    // Data in pieces as short as one byte, where the chip may choose.
    void splitData(std::uint64_t seed) { m_splitter.emplace(seed); }

    int reports() const { return m_reports; } // that went either way

    const HidIdentity &identity() const final { return m_identity; }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) final;
    Status write(std::span<const std::uint8_t> report) final;
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) final;
    Status sendFeature(std::span<const std::uint8_t> report) final;

protected:
    static constexpr double kFrameS = 1e-3;

    SimulatedClock &clock() { return m_clock; }
    double nowS() const { return m_clock.nowS(); }
    void answer(Report report, double readyS);
    void dropAnswers() { m_input.clear(); }
    std::size_t piece(std::size_t most); // how many bytes to give at once
    Error refused() const;

private:
    struct Pending
    {
        Report report;
        double readyS;
    };

    virtual Status take(const Report &report) = 0;
    virtual Result<Report> feature(std::uint8_t id) = 0;
    virtual Status takeFeature(const Report &report) = 0;
    Status plugged();
    void garble(Report &report);

    SimulatedClock &m_clock;
    HidIdentity m_identity;
    std::deque<Pending> m_input;
    int m_callsUntilUnplugged = -1;
    bool m_silent = false;
    std::optional<Random> m_garbler;
    std::optional<Random> m_splitter;
    int m_reports = 0;
};

} // namespace driftbench::test
