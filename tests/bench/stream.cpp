// What a native bridge's stream costs the host: decoding, the clock map, assembling, blocks. The reports of a
// simulated bridge are recorded once and then played back to the source, so that neither the firmware nor the
// simulator is in the figure; what all of them take together stands beside it.
//
//   driftbench-stream [SECONDS of the stream, 20] [HZ, 10000]
#include "device/bridge/bridge_source.h"
#include "device/firmware/bridge_bytes.h"
#include "device/simulated_bridge.h"
#include "device/simulated_clock.h"
#include "engine/physics/sensor_presets.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace driftbench;

namespace {

struct Recorded
{
    std::vector<BridgeReport> reports;
    BridgeReport info{}, config{}, status{};
};

// Keeps what passes.
class RecordingTransport final : public HidTransport
{
public:
    RecordingTransport(std::unique_ptr<HidTransport> below, Recorded &into)
        : m_below(std::move(below)), m_into(into)
    {
    }
    const HidIdentity &identity() const override { return m_below->identity(); }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override
    {
        auto length = m_below->read(report, timeout);
        if (length && *length == BRIDGE_REPORT_SIZE)
            std::copy_n(report.begin(), BRIDGE_REPORT_SIZE, m_into.reports.emplace_back().begin());
        return length;
    }
    Status write(std::span<const std::uint8_t> report) override { return m_below->write(report); }
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
    {
        auto length = m_below->getFeature(report);
        BridgeReport &kept = report[0] == BRIDGE_REPORT_INFO     ? m_into.info
                             : report[0] == BRIDGE_REPORT_CONFIG ? m_into.config
                                                                 : m_into.status;
        std::copy_n(report.begin(), BRIDGE_REPORT_SIZE, kept.begin());
        return length;
    }
    Status sendFeature(std::span<const std::uint8_t> report) override { return m_below->sendFeature(report); }

private:
    std::unique_ptr<HidTransport> m_below;
    Recorded &m_into;
};

// Gives the recorded reports as soon as it is asked to stream, at the times at which they were due.
class ReplayTransport final : public HidTransport
{
public:
    ReplayTransport(Recorded recorded, SimulatedClock &clock, double reportS)
        : m_recorded(std::move(recorded)), m_clock(clock), m_reportS(reportS)
    {
        m_recorded.config[BRIDGE_CONFIG_STREAM] = 0;
    }
    const HidIdentity &identity() const override { return m_identity; }
    Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override
    {
        if (m_recorded.config[BRIDGE_CONFIG_STREAM] == 0 || m_next == m_recorded.reports.size()) {
            m_recorded.config[BRIDGE_CONFIG_STREAM] = 0;
            m_clock.waitS(static_cast<double>(timeout.count()) * 0.001);
            return std::size_t{0};
        }
        m_clock.waitS(m_reportS);
        std::copy_n(m_recorded.reports[m_next++].begin(), BRIDGE_REPORT_SIZE, report.begin());
        return std::size_t{BRIDGE_REPORT_SIZE};
    }
    Status write(std::span<const std::uint8_t>) override { return Error{Errc::DeviceRefused, "No outputs."}; }
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
    {
        const BridgeReport &kept = report[0] == BRIDGE_REPORT_INFO     ? m_recorded.info
                                   : report[0] == BRIDGE_REPORT_CONFIG ? m_recorded.config
                                                                       : m_recorded.status;
        std::copy(kept.begin(), kept.end(), report.begin());
        // As many as were played back: fewer would mean that the device was reset.
        if (report[0] == BRIDGE_REPORT_STATUS)
            bridge_put_u32(&report[BRIDGE_STATUS_PRODUCED],
                           static_cast<std::uint32_t>(m_next * BRIDGE_SAMPLES_PER_REPORT));
        return kept.size();
    }
    Status sendFeature(std::span<const std::uint8_t> report) override
    {
        std::copy_n(report.begin(), BRIDGE_REPORT_SIZE, m_recorded.config.begin());
        m_recorded.status[BRIDGE_STATUS_COMMAND] = report[0];
        m_recorded.status[BRIDGE_STATUS_RESULT] = BRIDGE_RESULT_OK;
        return {};
    }

private:
    Recorded m_recorded;
    SimulatedClock &m_clock;
    double m_reportS;
    std::size_t m_next = 0;
    HidIdentity m_identity;
};

// Touches every value, as whoever stores them would.
class SummingSink final : public SampleSink
{
public:
    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        sum += block.rateDps.topRows(count).sum() + block.timeS.head(count).sum();
        rows += count;
        return Flow::Continue;
    }
    void gap(const SampleGap &gap) override { lost += gap.lostSamples; }
    void event(const std::string &) override {}

    double sum = 0.0;
    std::int64_t rows = 0;
    std::int64_t lost = 0;
};

template <class T>
T orExit(Result<T> result)
{
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().message.c_str());
        std::exit(1);
    }
    return *std::move(result);
}

// Processor seconds of a run.
double run(std::unique_ptr<HidTransport> transport, HostClock &clock, double rateHz, SummingSink &sink)
{
    BridgeSourceOptions options;
    options.rateHz = rateHz;
    const auto source = orExit(BridgeSource::open(std::move(transport), clock, options));
    const std::clock_t start = std::clock();
    orExit(source->run(sink, {}));
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::shared_ptr<SimulatedBoard> makeBoard(double durationS)
{
    SimulationOptions simulation = orExit(presetSimulation("L3GD20H", Eigen::Vector3d::Zero()));
    simulation.sensor.serial = "SIM-0001";
    simulation.profile = orExit(TemperatureProfile::build("bench", 20.0, {HoldSegment{durationS}}));
    SimulatedBoardOptions options{std::move(simulation)};
    options.speed = 0.0;
    return orExit(SimulatedBoard::create(std::move(options)));
}

} // namespace

int main(int argc, char **argv)
{
    const double durationS = argc > 1 ? std::atof(argv[1]) : 20.0;
    const double rateHz = argc > 2 ? std::atof(argv[2]) : 10000.0;
    const auto board = makeBoard(durationS);
    Recorded recorded;
    SummingSink first;
    const double allS =
        run(std::make_unique<RecordingTransport>(orExit(SimulatedBridge::open(board)), recorded),
            board->clock(), rateHz, first);
    const double streamS = static_cast<double>(first.rows) / rateHz;
    std::printf("%lld samples x 3 axes at %g Hz: %.1f s of stream in %zu reports, %lld lost\n",
                static_cast<long long>(first.rows), rateHz, streamS, recorded.reports.size(),
                static_cast<long long>(first.lost));
    std::printf("firmware, simulator and host: %.2f %% of a core\n", 100.0 * allS / streamS);
    std::vector<double> shares;
    for (int repetition = 0; repetition < 9; ++repetition) {
        SimulatedClock clock(0.0);
        SummingSink sink;
        const double hostS =
            run(std::make_unique<ReplayTransport>(recorded, clock, BRIDGE_SAMPLES_PER_REPORT / rateHz), clock,
                rateHz, sink);
        if (sink.rows != first.rows || sink.lost != 0) {
            std::fprintf(stderr, "the replay gave %lld samples and lost %lld\n",
                         static_cast<long long>(sink.rows), static_cast<long long>(sink.lost));
            return 1;
        }
        shares.push_back(100.0 * hostS / streamS);
    }
    std::sort(shares.begin(), shares.end());
    std::printf("host alone, 9 runs: median %.3f %% of a core (%.3f to %.3f)\n", shares[shares.size() / 2],
                shares.front(), shares.back());
    return 0;
}
