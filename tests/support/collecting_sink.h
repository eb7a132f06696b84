// A sink that keeps everything, and can stop after so many samples.
#pragma once

#include "device/sample_source.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace driftbench::test {

class CollectingSink final : public SampleSink
{
public:
    struct Row
    {
        double timeS;
        double temperatureC;
        std::array<double, 3> rateDps;
    };

    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        consistent = consistent && count > 0 && count <= block.size() &&
                     block.firstSample == static_cast<std::int64_t>(rows.size());
        longestBlockS = std::max(longestBlockS, block.timeS[count - 1] - block.timeS[0]);
        for (Eigen::Index i = 0; i < count; ++i)
            rows.push_back({block.timeS[i],
                            block.temperatureC[i],
                            {block.rateDps(i, 0), block.rateDps(i, 1), block.rateDps(i, 2)}});
        ++blocks;
        if (onSamples)
            onSamples();
        return rows.size() >= stopAfter ? Flow::Stop : Flow::Continue;
    }
    void gap(const SampleGap &gap) override
    {
        // Told between the blocks before and after it.
        consistent = consistent && !rows.empty() && gap.startS == rows.back().timeS;
        gaps.push_back(gap);
    }
    void event(const std::string &sentence) override { events.push_back(sentence); }

    bool hasEvent(const std::string &part) const
    {
        return std::any_of(events.begin(), events.end(),
                           [&](const std::string &event) { return event.find(part) != std::string::npos; });
    }
    bool timesRise() const
    {
        return std::is_sorted(rows.begin(), rows.end(),
                              [](const Row &a, const Row &b) { return a.timeS <= b.timeS; });
    }
    // Gaps of that cause and the samples lost in them.
    std::int64_t lost(GapCause cause) const
    {
        std::int64_t sum = 0;
        for (const SampleGap &gap : gaps)
            sum += gap.cause == cause ? gap.lostSamples : 0;
        return sum;
    }

    std::vector<Row> rows;
    std::vector<SampleGap> gaps;
    std::vector<std::string> events;
    std::size_t stopAfter = SIZE_MAX;
    std::function<void()> onSamples;
    double longestBlockS = 0.0;
    int blocks = 0;
    bool consistent = true;
};

} // namespace driftbench::test
