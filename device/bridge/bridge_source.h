// A native gyro bridge as a source of samples: configured, streamed from, watched.
//
// Lost reports, overruns inside the device and times at which it was away are told as gaps; saturation,
// stalls and what else is odd as events. A bridge that says nothing is asked after stallS whether it still
// streams: one that has stopped by itself ends the run, one that was reset counts as unplugged.
//
// With a reopen function a bridge that is unplugged is waited for: it is called every reopenEveryS until the
// bridge of the same gyro is back, and the run goes on behind a gap. The wait ends with the stop token.
//
// Errors of open: those of the client; InvalidOption for a rate or range that the bridge does not have.
// Errors of run: those of the client; DeviceUnplugged without a reopen function; DamagedReport when only
// damaged reports come.
#pragma once

#include "device/bridge/bridge_assembler.h"
#include "device/bridge/bridge_client.h"

#include <functional>

namespace driftbench {

enum class BridgeThermometer
{
    Automatic, // the external one if there is one
    External,
    Die,
};

using ReopenTransport = std::function<Result<std::unique_ptr<HidTransport>>()>;

struct BridgeSourceOptions
{
    double rateHz = 0.0;   // 0: the one that the bridge has now
    double rangeDps = 0.0; // full scale; 0: the one that the bridge has now
    bool compensate = false;
    BridgeThermometer thermometer = BridgeThermometer::Automatic;
    double blockS = 0.04;
    double stallS = 1.0;
    double reopenEveryS = 0.5;
    ReopenTransport reopen{}; // empty: unplugging ends the run
};

class BridgeSource final : public SampleSource
{
public:
    // The clock must outlive the source.
    static Result<std::unique_ptr<BridgeSource>> open(std::unique_ptr<HidTransport> transport,
                                                      HostClock &clock, BridgeSourceOptions options);

    const SourceInfo &info() const override { return m_info; }
    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override;

    BridgeClient &client() { return m_client; } // not while it runs

private:
    struct Watch; // over one stream, from its start to its end

    BridgeSource(BridgeClient client, HostClock &clock, BridgeSourceOptions options,
                 const BridgeConfig &config);
    BridgeAssembly assembly() const;
    Status stream(BridgeAssembler &assembler, SampleSink &sink, const std::stop_token &stop);
    Status start(Watch &watch);
    void drain(BridgeAssembler *assembler);
    Result<Flow> readOne(Watch &watch);
    Result<Flow> take(std::span<const std::uint8_t> report, Watch &watch);
    Result<Flow> onSilence(Watch &watch);
    bool waitForReturn(SampleSink &sink, const std::stop_token &stop);
    Status reconnect();

    BridgeClient m_client;
    HostClock &m_clock;
    BridgeSourceOptions m_options;
    BridgeConfig m_config; // with which it streams
    SourceInfo m_info;
};

} // namespace driftbench
