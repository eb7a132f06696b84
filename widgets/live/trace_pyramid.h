// Traces that are still being measured, ready to be drawn at any zoom: lowest, highest and mean value over
// stretches of 16, 64, 256, ... samples, kept up to date as samples arrive.
//
// Every level holds at most kStretches stretches, and the samples themselves are kept for the last kSamples:
// memory does not depend on how long it goes on (a level costs 30 MB; an hour at 10 kHz takes about 120 MB in
// all). What is old is there in coarser steps: to a quarter millionth of its age.
//
// envelopes() takes the coarsest level that still has a stretch for every column, and coarser ones where that
// one no longer reaches back. Its cost grows with the columns, not with the samples.
//
// A jump of time by more than five intervals is a gap. A stretch does not span a gap that is longer than
// itself, and the envelope's lines break there.
#pragma once

#include "widgets/live/chunk_ring.h"

#include <QVector>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace driftbench {

class TracePyramid
{
public:
    // Raw x, y, z; compensated x, y, z; temperature. A value that is not finite is left out of what is drawn.
    static constexpr std::size_t kTraces = 7;
    static constexpr std::size_t kRaw = 0;
    static constexpr std::size_t kCompensated = 3;
    static constexpr std::size_t kTemperature = 6;
    using Values = std::array<float, kTraces>;

    static constexpr std::size_t kSamples = std::size_t{1} << 20;
    static constexpr std::size_t kStretches = std::size_t{1} << 18;
    static constexpr std::int64_t kFirstStretch = 16; // samples
    static constexpr std::int64_t kGrowth = 4;        // from a level to the next
    static constexpr double kGapIntervals = 5.0;

    struct Envelopes
    {
        QVector<double> timeS; // mean of each column; where a line breaks, between its ends
        std::array<QVector<double>, kTraces> low, high, mean;
    };

    TracePyramid();

    // Times must rise; samples that do not are counted and left out.
    void add(double timeS, const Values &values);

    bool empty() const { return m_count == 0; }
    std::int64_t samples() const { return m_count; }
    std::int64_t leftOut() const { return m_leftOut; }
    double firstS() const { return m_firstS; } // of all, also of what is kept in coarse steps only
    double lastS() const { return m_lastS; }
    double intervalS() const; // mean between samples, without the gaps

    // Over fromS..toS in columns of columnS, aligned to multiples of it so that what moves along does not
    // flicker. What reaches over the ends of the range is in it.
    Envelopes envelopes(double fromS, double toS, double columnS) const;

    // Means of all traces over fromS..toS, as far as the levels part it; nothing without a sample there. NaN
    // for a trace that has none.
    std::optional<std::array<double, kTraces>> means(double fromS, double toS) const;

    std::size_t bytes() const; // about

private:
    struct Sample
    {
        double timeS = 0.0;
        Values values{};
    };
    struct Stretch
    {
        double firstS = 0.0, lastS = 0.0;
        std::int64_t count = 0;
        Values low{}, high{}, mean{};
    };
    struct Level
    {
        std::int64_t samples; // of a full stretch
        ChunkRing<Stretch> closed{kStretches};
        Stretch open;
    };

    static Stretch stretchOf(const Sample &sample);
    static void merge(Stretch &into, const Stretch &part);
    void close(std::size_t level);
    void closeForGap(double gapS);
    int levelFor(double columnS) const; // -1: the samples
    std::optional<double> oldestOf(int level) const;
    // What lies in fromS..toS, in order of time, in steps of the level or coarser where it does not reach.
    template <class F>
    void visit(int level, double fromS, double toS, F &&each) const;
    template <class F>
    void visitLevel(int level, double fromS, double toS, F &&each) const;

    ChunkRing<Sample> m_samples{kSamples};
    std::vector<Level> m_levels;
    std::int64_t m_count = 0;
    std::int64_t m_leftOut = 0;
    std::int64_t m_intervals = 0;
    double m_firstS = 0.0;
    double m_lastS = 0.0;
    double m_coveredS = 0.0;
};

} // namespace driftbench
