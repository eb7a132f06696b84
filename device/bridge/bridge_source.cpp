#include "device/bridge/bridge_source.h"

#include "engine/base/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace driftbench {

namespace {

using namespace std::chrono_literals;

constexpr auto kReadTimeout = 40ms;
constexpr int kMostDamagedInARow = 16;
constexpr int kMostDrained = 100000; // reports; a bridge that can't be stopped must not hold us for ever

Result<std::uint32_t> chosenRate(const BridgeInfo &info, double rateHz)
{
    const double milliHz = std::round(rateHz * 1000.0);
    if (!(milliHz >= info.lowestRateMilliHz) || !(milliHz <= info.highestRateMilliHz))
        return invalidOption("The bridge samples with " + shortest(info.lowestRateMilliHz / 1000.0) + " to " +
                             shortest(info.highestRateMilliHz / 1000.0) + " Hz; " + shortest(rateHz) +
                             " Hz can't be chosen.");
    return static_cast<std::uint32_t>(milliHz);
}

Result<std::uint8_t> chosenRange(const BridgeInfo &info, double rangeDps)
{
    std::string known;
    for (std::size_t i = 0; i < info.ranges.size(); ++i) {
        if (info.ranges[i].fullScaleDps == rangeDps)
            return static_cast<std::uint8_t>(i);
        known += (known.empty() ? "" : ", ") + std::to_string(info.ranges[i].fullScaleDps);
    }
    return invalidOption("The bridge has the ranges " + known + " dps; " + shortest(rangeDps) +
                         " dps can't be chosen.");
}

Result<BridgeConfig> chosenConfig(const BridgeInfo &info, BridgeConfig config,
                                  const BridgeSourceOptions &options)
{
    if (options.rateHz != 0.0) {
        const auto rate = chosenRate(info, options.rateHz);
        if (!rate)
            return rate.error();
        config.rateMilliHz = *rate;
    }
    if (options.rangeDps != 0.0) {
        const auto range = chosenRange(info, options.rangeDps);
        if (!range)
            return range.error();
        config.range = *range;
    }
    if (config.range >= info.ranges.size() || config.rateMilliHz == 0)
        return Error{Errc::DamagedReport, "The bridge uses range " + std::to_string(config.range) + " and " +
                                              std::to_string(config.rateMilliHz) +
                                              " mHz, which its own info rules out; unplug it and plug it in "
                                              "again."};
    config.stream = true;
    config.compensate = options.compensate;
    config.pair = false;
    return config;
}

bool usesExternal(const BridgeInfo &info, BridgeThermometer thermometer)
{
    return thermometer == BridgeThermometer::External ||
           (thermometer == BridgeThermometer::Automatic && info.can(BRIDGE_CAN_EXTERNAL));
}

} // namespace

struct BridgeSource::Watch
{
    BridgeAssembler &assembler;
    SampleSink &sink;
    std::uint32_t producedBefore = 0; // samples that the device had produced when the stream started
    std::uint32_t received = 0;       // samples of this stream
    double lastReportS = 0.0;
    double askedS = 0.0; // when the silent device was last asked
    bool silent = false;
    int damagedInARow = 0;
};

Result<std::unique_ptr<BridgeSource>> BridgeSource::open(std::unique_ptr<HidTransport> transport,
                                                         HostClock &clock, BridgeSourceOptions options)
{
    if (!(options.blockS > 0.0) || !(options.stallS > 0.0) || !(options.reopenEveryS > 0.0))
        return invalidOption("The times of a bridge's source must be more than 0 s.");
    auto client = BridgeClient::open(std::move(transport), clock);
    if (!client)
        return client.error();
    if (options.thermometer == BridgeThermometer::External && !client->info().can(BRIDGE_CAN_EXTERNAL))
        return invalidOption("The bridge has no external thermometer; choose the one on the die.");
    const auto now = client->config();
    if (!now)
        return now.error();
    const auto config = chosenConfig(client->info(), *now, options);
    if (!config)
        return config.error();
    return std::unique_ptr<BridgeSource>(
        new BridgeSource(*std::move(client), clock, std::move(options), *config));
}

BridgeSource::BridgeSource(BridgeClient client, HostClock &clock, BridgeSourceOptions options,
                           const BridgeConfig &config)
    : m_client(std::move(client)), m_clock(clock), m_options(std::move(options)), m_config(config)
{
    m_info.name = m_client.name();
    m_info.sensor = m_client.info().sensor;
    m_info.sampleRateHz = config.rateMilliHz / 1000.0;
    m_info.rangeDps = m_client.info().ranges[config.range].fullScaleDps;
    m_info.simulated = m_client.identity().path.starts_with("simulated:");
    m_info.compensated = config.compensate;
}

BridgeAssembly BridgeSource::assembly() const
{
    return {m_client.info().ranges[m_config.range], m_info.sampleRateHz, m_options.blockS,
            usesExternal(m_client.info(), m_options.thermometer), m_config.compensate};
}

Result<SourceStats> BridgeSource::run(SampleSink &sink, std::stop_token stop)
{
    BridgeAssembler assembler(assembly(), sink);
    Status ended = stream(assembler, sink, stop);
    while (!ended && ended.error().code == Errc::DeviceUnplugged && m_options.reopen) {
        assembler.flush();
        sink.event(m_info.name + " was unplugged; waiting for it to come back.");
        ended = {};
        if (!waitForReturn(sink, stop))
            break;
        assembler.restart();
        sink.event(m_info.name + " is back.");
        ended = stream(assembler, sink, stop);
    }
    assembler.flush();
    if (!ended)
        return ended.error();
    return assembler.stats();
}

Status BridgeSource::stream(BridgeAssembler &assembler, SampleSink &sink, const std::stop_token &stop)
{
    Watch watch{assembler, sink};
    if (const Status started = start(watch); !started)
        return started;
    Flow flow = Flow::Continue;
    while (flow == Flow::Continue && !stop.stop_requested()) {
        const auto next = readOne(watch);
        if (!next)
            return next.error();
        flow = *next;
    }
    // The run is over whether or not the device hears it.
    BridgeConfig stopped = m_config;
    stopped.stream = false;
    if (m_client.configure(stopped))
        drain(flow == Flow::Continue ? &assembler : nullptr);
    return {};
}

Status BridgeSource::start(Watch &watch)
{
    const auto now = m_client.config();
    if (!now)
        return now.error();
    if (now->stream) {
        BridgeConfig stopped = *now;
        stopped.stream = false;
        if (const Status ok = m_client.configure(stopped); !ok)
            return ok;
    }
    drain(nullptr);
    const auto status = m_client.status();
    if (!status)
        return status.error();
    watch.producedBefore = status->producedSamples;
    watch.lastReportS = m_clock.nowS();
    return m_client.configure(m_config);
}

// Reads what was sent before the stream was stopped; without an assembler it is of an earlier stream.
void BridgeSource::drain(BridgeAssembler *assembler)
{
    BridgeReport report;
    for (int i = 0; i < kMostDrained; ++i) {
        const auto length = m_client.transport().read(report, 0ms);
        if (!length || *length == 0)
            return;
        const auto samples = decodeBridgeSamples(std::span(report).first(*length));
        if (assembler && samples && assembler->add(*samples, m_clock.nowS()) == Flow::Stop)
            return;
    }
}

Result<Flow> BridgeSource::readOne(Watch &watch)
{
    BridgeReport report;
    const auto length = m_client.transport().read(report, kReadTimeout);
    if (!length)
        return length.error();
    return *length > 0 ? take(std::span(report).first(*length), watch) : onSilence(watch);
}

Result<Flow> BridgeSource::take(std::span<const std::uint8_t> report, Watch &watch)
{
    if (report[0] != BRIDGE_REPORT_SAMPLES)
        return Flow::Continue; // of a newer minor version
    const double nowS = m_clock.nowS();
    if (watch.silent)
        watch.sink.event("Samples come again after " + fixed(nowS - watch.lastReportS, 1) + " s.");
    watch.silent = false;
    watch.lastReportS = nowS;
    const auto samples = decodeBridgeSamples(report);
    if (!samples) {
        if (++watch.damagedInARow == 1)
            watch.sink.event(samples.error().message);
        if (watch.damagedInARow >= kMostDamagedInARow)
            return samples.error();
        return Flow::Continue; // the next sequence number counts it as lost
    }
    watch.damagedInARow = 0;
    watch.received += static_cast<std::uint32_t>(samples->count);
    return watch.assembler.add(*samples, nowS);
}

Result<Flow> BridgeSource::onSilence(Watch &watch)
{
    if (watch.assembler.flush() == Flow::Stop)
        return Flow::Stop;
    const double nowS = m_clock.nowS();
    if (nowS - std::max(watch.lastReportS, watch.askedS) < m_options.stallS)
        return Flow::Continue;
    watch.askedS = nowS;
    const auto config = m_client.config();
    if (!config)
        return config.error();
    const auto status = m_client.status();
    if (!status)
        return status.error();
    if (!config->stream && status->producedSamples - watch.producedBefore < watch.received)
        return Error{Errc::DeviceUnplugged,
                     m_info.name + " was reset and has stopped streaming; check its supply."};
    if (!config->stream) {
        watch.sink.event(m_info.name + " has stopped streaming.");
        return Flow::Stop;
    }
    if (!watch.silent)
        watch.sink.event("No samples have come for " + fixed(nowS - watch.lastReportS, 1) + " s.");
    watch.silent = true;
    return Flow::Continue;
}

// False: stopped meanwhile. Why it can't be opened is told whenever the reason changes.
bool BridgeSource::waitForReturn(SampleSink &sink, const std::stop_token &stop)
{
    Errc told = Errc::DeviceNotFound;
    while (!stop.stop_requested()) {
        const Status back = reconnect();
        if (back)
            return true;
        const Errc code = back.error().code;
        if (code != told && code != Errc::DeviceNotFound && code != Errc::DeviceUnplugged)
            sink.event(back.error().message);
        told = code;
        m_clock.waitS(m_options.reopenEveryS);
    }
    return false;
}

Status BridgeSource::reconnect()
{
    auto transport = m_options.reopen();
    if (!transport)
        return transport.error();
    auto client = BridgeClient::open(*std::move(transport), m_clock);
    if (!client)
        return client.error();
    const SensorIdentity &sensor = client->info().sensor;
    if (sensor.model != m_info.sensor.model || sensor.serial != m_info.sensor.serial)
        return Error{Errc::WrongSensor, "A bridge with the gyro " + sensor.text() +
                                            " was plugged in; the run waits for " + m_info.sensor.text() +
                                            "."};
    if (client->info().ranges != m_client.info().ranges)
        return Error{Errc::WrongSensor,
                     m_info.sensor.text() + " came back with other ranges; end the run and start another."};
    m_client = *std::move(client);
    return {};
}

} // namespace driftbench
