// A long recording made shorter as it is read, so that an hour at 10 kHz fits where a minute does: each point
// is the mean of up to n samples in a row, n a power of two (samplesAPoint).
//
//   time, temperature, rates   means over the samples of the point
//   points (recording.h)       how many samples, and the variance of each rate among them
//
// Sums over samples come out of the points as they were, sum y = sum n mean, sum y^2 = sum n (mean^2 +
// variance): thermal curves, MSD and noise floors are those of all samples, but for the change of temperature
// and curve within a point. What varies faster than a point is in the variance, no longer in the means.
//
// What is wrong with a recording must not vanish in a mean. A point ends early where time stands still, goes
// backwards or jumps by more than a point lasts, and where values begin or cease to be finite. A sample that
// repeats the time stamp before it is left out, with a warning. Where neighbours lie kStairsC apart in
// temperature (a thermometer with a step of a degree) the point has the reading that most of its samples
// have.
#pragma once

#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace driftbench {

inline constexpr std::int64_t kMostPoints = std::int64_t{1}
                                            << 20; // of a run; up to here samples stay as they are

// 1, or the smallest power of two that leaves at most mostPoints.
std::int64_t samplesAPoint(std::int64_t samples, std::int64_t mostPoints = kMostPoints);

class BlockMeans
{
public:
    static constexpr double kStairsC = 0.9; // as QualityOptions::coarseTemperatureC

    // room: how many samples there will be; more is no error.
    BlockMeans(std::int64_t samplesAPoint, std::int64_t room);

    void add(const double *timeS, const double *temperatureC, const std::array<const double *, 3> &rateDps,
             Eigen::Index count);
    // With the samples that don't fill a point. Nothing may be added after it.
    Recording finish(RecordingInfo info);

private:
    struct Sample
    {
        double timeS, temperatureC;
        std::array<double, 3> rateDps;
    };

    void add(const Sample &sample);
    bool continues(const Sample &sample, bool finite) const;
    void put(const Sample &sample);
    void endPoint();
    void resizeRows(Eigen::Index rows);
    double temperatureOfPoint();

    std::int64_t m_samplesAPoint;
    Recording m_made;
    Eigen::Index m_points = 0;
    std::int64_t m_repeats = 0;

    // The point in work: its first sample, and sums of what later ones differ from it, which lose no digits
    // and are exactly zero where a value stands still.
    Sample m_first{};
    int m_count = 0;
    bool m_finite = true;
    double m_lastS = std::numeric_limits<double>::quiet_NaN();
    double m_sumTimeS = 0.0;
    std::array<double, 3> m_sumDps{};
    std::array<double, 3> m_squares{};
    std::vector<double> m_temperatureC;
    double m_pointLastsS = 0.0; // the last one that was full
};

// The recording itself where it has few samples.
Recording shortened(Recording recording, std::int64_t mostPoints = kMostPoints);

// "Its 50 000 000 samples are taken as 781 250 means of 64 in a row."; empty where each row is one sample.
std::string meansText(const Recording &recording);

} // namespace driftbench
