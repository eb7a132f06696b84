#include "device/compensation_check.h"

#include "engine/exports/device_compensation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace driftbench {

namespace {

using namespace std::chrono_literals;

constexpr auto kReadTimeout = 40ms;
constexpr int kMostDrained = 100000; // reports; a device that can't be stopped must not hold us for ever

Result<BridgeConfig> pairConfig(const BridgeInfo &info, BridgeConfig config, double rateHz)
{
    if (config.range >= info.ranges.size())
        return Error{Errc::DamagedReport, "The bridge uses range " + std::to_string(config.range) +
                                              ", which its own info rules out; unplug it and plug it in "
                                              "again."};
    const double milliHz =
        std::clamp(std::round(rateHz * 1000.0), static_cast<double>(info.lowestRateMilliHz),
                   static_cast<double>(info.highestRateMilliHz));
    config.rateMilliHz = static_cast<std::uint32_t>(milliHz);
    config.stream = true;
    config.compensate = true;
    config.pair = true;
    return config;
}

// A device that streams takes another rate only once it has stopped.
Status reconfigure(BridgeClient &client, const BridgeConfig &config)
{
    BridgeConfig stopped = config;
    stopped.stream = false;
    if (const Status done = client.configure(stopped); !done)
        return done;
    return config.stream ? client.configure(config) : Status();
}

void drain(HidTransport &transport)
{
    BridgeReport report;
    for (int i = 0; i < kMostDrained; ++i) {
        const auto length = transport.read(report, 0ms);
        if (!length || *length == 0)
            return;
    }
}

// Takes reports in the order in which they came and compares what belongs together.
class PairComparison
{
public:
    PairComparison(const DeviceImage &image, BridgeRange range, int wanted)
        : m_host(image, range.sensitivity), m_thermometer(image.thermometer), m_range(range)
    {
        m_check.wanted = wanted;
    }

    void add(const BridgeSamples &report)
    {
        if (report.has(BRIDGE_FLAG_TWIN) && m_compensated && belongsTo(report, *m_compensated))
            compare(*m_compensated, report);
        m_compensated.reset();
        if (report.has(BRIDGE_FLAG_COMPENSATED))
            m_compensated = report;
        else if (!report.has(BRIDGE_FLAG_TWIN))
            m_check.rawSamples += report.count;
    }
    const CompensationCheck &check() const { return m_check; }

private:
    static bool belongsTo(const BridgeSamples &twin, const BridgeSamples &report)
    {
        return twin.sequence == static_cast<std::uint16_t>(report.sequence + 1) &&
               twin.timeUs == report.timeUs && twin.count == report.count;
    }

    void compare(const BridgeSamples &report, const BridgeSamples &twin)
    {
        const auto milliC =
            m_thermometer == DeviceThermometer::External ? report.externalMilliC : report.dieMilliC;
        if (!milliC)
            return;
        const std::array<std::int32_t, 3> tdeCounts = m_host.tdeCounts(*milliC);
        for (std::size_t i = 0; i < static_cast<std::size_t>(report.count); ++i) {
            int worst = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int expected = DeviceCompensation::compensated(twin.counts[i][axis], tdeCounts[axis]);
                worst = std::max(worst, std::abs(report.counts[i][axis] - expected));
            }
            m_check.differing += worst > 0 ? 1 : 0;
            m_check.worstCounts = std::max(m_check.worstCounts, worst);
        }
        m_check.worstDps = m_range.rateDps(m_check.worstCounts);
        const double temperatureC = *milliC / 1000.0;
        m_check.lowestC = m_check.samples == 0 ? temperatureC : std::min(m_check.lowestC, temperatureC);
        m_check.highestC = m_check.samples == 0 ? temperatureC : std::max(m_check.highestC, temperatureC);
        m_check.samples += report.count;
    }

    DeviceCompensation m_host;
    DeviceThermometer m_thermometer;
    BridgeRange m_range;
    std::optional<BridgeSamples> m_compensated; // whose twin may come next
    CompensationCheck m_check;
};

Status readPairs(BridgeClient &client, PairComparison &pairs, double patienceS, const ProgressHook &hook)
{
    const double endS = client.clock().nowS() + patienceS;
    BridgeReport report;
    while (pairs.check().samples < pairs.check().wanted && client.clock().nowS() < endS) {
        const double share = static_cast<double>(pairs.check().samples) / pairs.check().wanted;
        if (driftbench::report(hook, "comparing the compensation", share) == Flow::Stop)
            return Error{Errc::Cancelled, "The comparison of the compensation was cancelled."};
        const auto length = client.transport().read(report, kReadTimeout);
        if (!length)
            return length.error();
        if (*length == 0 || report[0] != BRIDGE_REPORT_SAMPLES)
            continue;
        // A damaged report is like a lost one: what belongs to it is not compared.
        if (const auto samples = decodeBridgeSamples(std::span(report).first(*length)))
            pairs.add(*samples);
    }
    return {};
}

} // namespace

Result<CompensationCheck> checkCompensation(BridgeClient &client, const DeviceImage &image,
                                            const CompensationCheckOptions &options, const ProgressHook &hook)
{
    if (!client.info().can(BRIDGE_CAN_PAIR))
        return Error{Errc::DeviceRefused, "The device can't send raw samples beside compensated ones, so its "
                                          "compensation can't be compared; update its firmware."};
    const auto before = client.config();
    if (!before)
        return before.error();
    const auto config = pairConfig(client.info(), *before, options.rateHz);
    if (!config)
        return config.error();
    PairComparison pairs(image, client.info().ranges[config->range], options.samples);
    BridgeConfig stopped = *config;
    stopped.stream = false;
    if (const Status done = client.configure(stopped); !done)
        return done.error();
    drain(client.transport());
    Status done = client.configure(*config);
    if (done)
        done = readPairs(client, pairs, options.longestWaitS + options.samples * 1000.0 / config->rateMilliHz,
                         hook);
    const Status restored = reconfigure(client, *before);
    drain(client.transport());
    if (!done)
        return done.error();
    if (!restored)
        return restored.error();
    return pairs.check();
}

} // namespace driftbench
