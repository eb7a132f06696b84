// A source that plays a script: blocks of samples, gaps, events, waits; then it ends, fails, or goes on until
// it is stopped. Sample i of the script has time i / rateHz, temperature i and rates i, -i, i / 2.
#pragma once

#include "device/sample_source.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

namespace driftbench::test {

struct ScriptedSamples
{
    Eigen::Index count = 0;
};
struct ScriptedWait
{
    std::chrono::milliseconds time{0};
};
using ScriptStep = std::variant<ScriptedSamples, ScriptedWait, SampleGap, std::string, Error>;

class ScriptedSource final : public SampleSource
{
public:
    ScriptedSource(std::vector<ScriptStep> script, bool endless, double rateHz = 1000.0)
        : m_script(std::move(script)), m_endless(endless), m_rateHz(rateHz)
    {
        m_info.name = "script";
        m_info.sensor = {"L3GD20H", "T-1"};
        m_info.sampleRateHz = rateHz;
        m_info.simulated = true;
    }

    const SourceInfo &info() const override { return m_info; }

    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override
    {
        SourceStats stats;
        do {
            for (const ScriptStep &step : m_script) {
                if (stop.stop_requested())
                    return stats;
                if (const auto *error = std::get_if<Error>(&step))
                    return *error;
                if (play(step, sink, stats) == Flow::Stop)
                    return stats;
            }
        } while (m_endless);
        return stats;
    }

    static SampleBlock block(std::int64_t first, Eigen::Index count, double rateHz)
    {
        SampleBlock block = SampleBlock::withRows(count);
        block.firstSample = first;
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto number = static_cast<double>(first + i);
            block.timeS[i] = number / rateHz;
            block.temperatureC[i] = number;
            block.rateDps.row(i) << number, -number, number / 2.0;
        }
        return block;
    }

private:
    Flow play(const ScriptStep &step, SampleSink &sink, SourceStats &stats)
    {
        if (const auto *samples = std::get_if<ScriptedSamples>(&step)) {
            const SampleBlock rows = block(stats.samples, samples->count, m_rateHz);
            stats.samples += samples->count;
            return sink.samples(rows, samples->count);
        }
        if (const auto *wait = std::get_if<ScriptedWait>(&step))
            std::this_thread::sleep_for(wait->time);
        else if (const auto *gap = std::get_if<SampleGap>(&step))
            sink.gap(*gap);
        else
            sink.event(std::get<std::string>(step));
        return Flow::Continue;
    }

    std::vector<ScriptStep> m_script;
    bool m_endless;
    double m_rateHz;
    SourceInfo m_info;
};

} // namespace driftbench::test
