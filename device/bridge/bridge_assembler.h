// Reports of the native bridge, one after the other, become blocks of samples and gaps for a sink. Pure but
// for the sink: no device, no clock of its own.
//
//   time of sample i of a report = map(device time) + i x interval x rate      (clock_map.h)
//   lost between two reports = round(device time between them / interval) - samples of the first one
//
// with the mean interval of all reports that followed each other without a loss, because that of one report
// has the rounding of the device's microseconds.
//
// A gap where the sequence number skips is ReportsLost, where the overrun flag is set (or samples are missing
// without any sign) DeviceOverrun; where both are, reports account for at most 7 samples each and the overrun
// for the rest. The temperature of a report is that of all its samples; not a number where the chosen
// thermometer was not read.
#pragma once

#include "device/bridge/bridge_codec.h"
#include "device/clock_map.h"
#include "device/sample_source.h"

namespace driftbench {

struct BridgeAssembly
{
    BridgeRange range;
    double sampleRateHz = 0.0;
    double blockS = 0.0; // length of a block
    bool externalThermometer = false;
    bool compensated = false; // what was asked for
};

class BridgeAssembler
{
public:
    // The sink must outlive the assembler.
    BridgeAssembler(const BridgeAssembly &assembly, SampleSink &sink);

    // A report that arrived at hostS.
    Flow add(const BridgeSamples &report, double hostS);
    Flow flush(); // hands over what has gathered
    // The device was away: the next report ends a gap, and numbers and clock start anew.
    void restart();

    SourceStats stats() const;

private:
    bool isRepeat(const BridgeSamples &report) const;
    double elapsedS(const BridgeSamples &report, double startS) const;
    double intervalS() const;
    Flow markLoss(const BridgeSamples &report, double startS);
    void gap(double startS, std::int64_t lost, GapCause cause);
    Flow append(const BridgeSamples &report, double startS);
    double temperatureC(const BridgeSamples &report);
    void tellOnce(bool &told, bool happens, const char *sentence);
    void tellSaturation(const BridgeSamples &report, double startS);

    BridgeAssembly m_assembly;
    SampleSink &m_sink;
    ClockMap m_clock;
    SampleBlock m_block;
    Eigen::Index m_count = 0;
    SourceStats m_stats;
    bool m_started = false; // a report came
    bool m_away = false;    // since the last report
    std::uint16_t m_sequence = 0;
    std::uint32_t m_timeUs = 0; // of the last report, as its sequence number
    int m_reportSamples = 0;    // in the last report
    double m_startS = 0.0;      // of its first sample
    double m_lastS = 0.0;       // of its last sample
    double m_followedS = 0.0;   // device time and samples of reports that another followed
    std::int64_t m_followedSamples = 0;
    double m_saturatedS; // when it was last so
    bool m_toldNoTemperature = false;
    bool m_toldCompensation = false;
    bool m_toldOutsideTable = false;
};

} // namespace driftbench
