#include "device/replay_source.h"

#include "engine/base/text.h"
#include "engine/formats/log_reader.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kGapFactor = 5.0;
constexpr double kLongestWaitS = 0.05; // so that a stop is not waited for
constexpr Eigen::Index kMostRows = 4096;

double medianIntervalS(const SampleBlock &block)
{
    std::vector<double> intervals;
    for (Eigen::Index i = 1; i < block.size(); ++i) {
        const double intervalS = block.timeS[i] - block.timeS[i - 1];
        if (std::isfinite(intervalS) && intervalS > 0.0)
            intervals.push_back(intervalS);
    }
    if (intervals.empty())
        return 0.0;
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    return *middle;
}

// Cuts the reader's blocks to those of a source, and hands each over when its time has come.
class Player
{
public:
    Player(const ReplayOptions &options, HostClock &clock, SampleSink &sink, std::stop_token stop)
        : m_options(options)
        , m_clock(clock)
        , m_sink(sink)
        , m_stop(std::move(stop))
        , m_block(SampleBlock::withRows(kMostRows))
    {
    }

    Flow play(const SampleBlock &log);
    Flow flush();
    const SourceStats &stats() const { return m_stats; }

private:
    Flow add(const SampleBlock &log, Eigen::Index row);
    Flow markGap(double timeS);
    Flow waitUntil(double timeS);

    const ReplayOptions &m_options;
    HostClock &m_clock;
    SampleSink &m_sink;
    std::stop_token m_stop;
    SampleBlock m_block;
    Eigen::Index m_count = 0;
    SourceStats m_stats;
    bool m_started = false;
    double m_originS = 0.0; // of the log's times
    double m_startS = 0.0;  // on the clock
    double m_lastS = 0.0;
    double m_intervalS = 0.0;
};

Flow Player::play(const SampleBlock &log)
{
    if (!m_started) {
        m_started = true;
        m_originS = std::isfinite(log.timeS[0]) ? log.timeS[0] : 0.0;
        m_startS = m_clock.nowS();
        m_intervalS = medianIntervalS(log);
    }
    for (Eigen::Index row = 0; row < log.size(); ++row) {
        if (add(log, row) == Flow::Stop)
            return Flow::Stop;
    }
    return Flow::Continue;
}

Flow Player::add(const SampleBlock &log, Eigen::Index row)
{
    const double timeS = log.timeS[row] - m_originS;
    if (m_stats.samples > 0 && markGap(timeS) == Flow::Stop)
        return Flow::Stop;
    m_block.timeS[m_count] = timeS;
    m_block.temperatureC[m_count] = log.temperatureC[row];
    m_block.rateDps.row(m_count) = log.rateDps.row(row);
    ++m_count;
    ++m_stats.samples;
    if (std::isfinite(timeS))
        m_lastS = timeS;
    const bool full = m_count == kMostRows || m_lastS - m_block.timeS[0] >= m_options.blockS;
    return full ? flush() : Flow::Continue;
}

Flow Player::markGap(double timeS)
{
    if (m_intervalS == 0.0 || !(timeS - m_lastS > kGapFactor * m_intervalS))
        return Flow::Continue;
    if (flush() == Flow::Stop)
        return Flow::Stop;
    const std::int64_t lost = std::llround((timeS - m_lastS) / m_intervalS) - 1;
    ++m_stats.gaps;
    m_stats.lostSamples += lost;
    m_sink.gap({m_lastS, timeS, lost, GapCause::ReportsLost});
    return Flow::Continue;
}

Flow Player::flush()
{
    if (m_stop.stop_requested() || waitUntil(m_lastS) == Flow::Stop)
        return Flow::Stop;
    if (m_count == 0)
        return Flow::Continue;
    const Flow flow = m_sink.samples(m_block, m_count);
    m_block.firstSample += m_count;
    m_count = 0;
    return flow;
}

Flow Player::waitUntil(double timeS)
{
    if (m_options.speed == 0.0)
        return Flow::Continue;
    const double dueS = m_startS + timeS / m_options.speed;
    for (double leftS = dueS - m_clock.nowS(); leftS > 0.0; leftS = dueS - m_clock.nowS()) {
        m_clock.waitS(std::min(leftS, kLongestWaitS));
        if (m_stop.stop_requested())
            return Flow::Stop;
    }
    return Flow::Continue;
}

} // namespace

Result<std::unique_ptr<ReplaySource>> ReplaySource::open(const std::filesystem::path &path, HostClock &clock,
                                                         ReplayOptions options)
{
    if (!(options.speed >= 0.0) || !std::isfinite(options.speed) || !(options.blockS > 0.0))
        return Error{Errc::InvalidOption, "The speed of the playback is " + shortest(options.speed) +
                                              " and its blocks last " + shortest(options.blockS) +
                                              " s; give 0 or more and more than 0."};
    double intervalS = 0.0;
    const BlockSink look = [&](const SampleBlock &block) {
        if (intervalS == 0.0)
            intervalS = medianIntervalS(block);
        return Flow::Continue;
    };
    auto info = readLogBlocks(path, options.read, look);
    if (!info)
        return info.error();
    std::unique_ptr<ReplaySource> source(new ReplaySource(path, clock, std::move(options)));
    source->m_info.name = path.filename().string();
    source->m_info.sensor = info->sensor;
    source->m_info.simulated = info->simulated;
    source->m_info.sampleRateHz = intervalS > 0.0 ? 1.0 / intervalS : 0.0;
    return source;
}

Result<SourceStats> ReplaySource::run(SampleSink &sink, std::stop_token stop)
{
    Player player(m_options, m_clock, sink, std::move(stop));
    bool stopped = false;
    const BlockSink play = [&](const SampleBlock &block) {
        const Flow flow = player.play(block);
        stopped = flow == Flow::Stop;
        return flow;
    };
    const auto info = readLogBlocks(m_path, m_options.read, play);
    if (stopped)
        return player.stats();
    if (!info)
        return info.error();
    for (const std::string &warning : info->warnings)
        sink.event(warning);
    player.flush();
    return player.stats();
}

} // namespace driftbench
