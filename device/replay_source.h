// A log file that is played back as if it were being recorded: at real speed, so many times as fast, or as
// fast as it can be read.
//
// Times are counted from the first sample. A gap is where two samples lie more than 5 median intervals apart
// (as quality.h has it), the median being that of the first block; the log does not know the cause, it is
// told as ReportsLost with as many samples as the median interval gives. Values are passed on as they are,
// also those that are no numbers or go back in time: judging them is the engine's affair.
//
// Errors: those of the log readers (log_reader.h); InvalidOption for a speed below 0.
#pragma once

#include "device/host_clock.h"
#include "device/sample_source.h"
#include "engine/formats/read_options.h"

#include <filesystem>
#include <memory>

namespace driftbench {

struct ReplayOptions
{
    double speed = 1.0; // times real time; 0: as fast as it goes
    double blockS = 0.04;
    ReadOptions read{};
};

class ReplaySource final : public SampleSource
{
public:
    // Reads the log once, to say what is in it. The clock must outlive the source.
    static Result<std::unique_ptr<ReplaySource>> open(const std::filesystem::path &path, HostClock &clock,
                                                      ReplayOptions options);

    const SourceInfo &info() const override { return m_info; }
    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override;

private:
    ReplaySource(std::filesystem::path path, HostClock &clock, ReplayOptions options)
        : m_path(std::move(path)), m_clock(clock), m_options(std::move(options))
    {
    }

    std::filesystem::path m_path;
    HostClock &m_clock;
    ReplayOptions m_options;
    SourceInfo m_info;
};

} // namespace driftbench
