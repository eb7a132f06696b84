// Samples of a gyro at 10 kHz as a bridge sends them, for measurements of session files: counts at 8.75 mdps,
// hundredths of a degree, microseconds. The same second of noise over and over, on a ramp of temperature.
#pragma once

#include "app/session/session_file.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace driftbench::bench {

[[noreturn]] inline void fail(const std::string &what)
{
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

template <class T>
T need(Result<T> result)
{
    if (!result)
        fail(result.error().message);
    return std::move(*result);
}

class GyroStream
{
public:
    static constexpr double kRateHz = 10000.0;

    // risingC: over that many samples the temperature rises by so much from 25 degrees.
    explicit GyroStream(double risingC = 0.0, std::int64_t overSamples = 1)
        : m_risingC(risingC)
        , m_overSamples(overSamples)
        , m_noise(SampleBlock::withRows(static_cast<Eigen::Index>(kRateHz)))
    {
        Random random(1);
        for (Eigen::Index i = 0; i < m_noise.size(); ++i) {
            m_noise.temperatureC[i] = std::round(2500.0 + random.normal()) / 100.0;
            for (int axis = 0; axis < 3; ++axis) // + 0.0: counts have no negative zero
                m_noise.rateDps(i, axis) = (std::round(random.normal() * 16.0) + 0.0) * 875.0 / 100000.0;
        }
    }

    void fill(std::int64_t first, Eigen::Index count, double *timeS, double *temperatureC,
              Eigen::MatrixX3d &rates, Eigen::Index row) const
    {
        const Eigen::Index from = static_cast<Eigen::Index>(first % m_noise.size());
        const double rise = m_risingC * static_cast<double>(first) / static_cast<double>(m_overSamples);
        const double riseC = std::round(100.0 * rise) / 100.0;
        for (Eigen::Index i = 0; i < count; ++i) {
            timeS[i] = static_cast<double>((first + i) * 100) / 1e6;
            temperatureC[i] = m_noise.temperatureC[from + i] + riseC;
        }
        rates.middleRows(row, count) = m_noise.rateDps.middleRows(from, count);
    }

private:
    double m_risingC;
    std::int64_t m_overSamples;
    SampleBlock m_noise;
};

// As one run of a new session file.
inline void importStream(const std::filesystem::path &path, const GyroStream &stream, std::int64_t samples)
{
    constexpr Eigen::Index kBlock = 400;
    auto file = need(SessionFile::create(path));
    Recording recording;
    recording.timeS.resize(samples);
    recording.temperatureC.resize(samples);
    recording.rateDps.resize(samples, 3);
    for (std::int64_t at = 0; at < samples; at += kBlock)
        stream.fill(at, kBlock, recording.timeS.data() + at, recording.temperatureC.data() + at,
                    recording.rateDps, at);
    need(file.importRun(recording, describeRecording({}, "large")));
}

} // namespace driftbench::bench
