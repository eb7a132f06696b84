// Recordings for tests of session files, and how to compare them: bit for bit.
#pragma once

#include "app/session/database.h"
#include "app/session/session_file.h"
#include "engine/base/random.h"
#include "support/test_data.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace driftbench::test {

// A new name in the scratch folder.
inline std::filesystem::path newSessionPath()
{
    static int number = 0;
    return scratchFolder() / ("session" + std::to_string(++number) + ".driftbench");
}

// As a program of before stored overviews wrote it.
inline void makeVersion1(const std::filesystem::path &path)
{
    const auto database = Database::open(path, DatabaseMode::ReadWrite);
    const Status made = database ? database->script("DROP TABLE overview; VACUUM; PRAGMA user_version = 1;")
                                 : Status(database.error());
    if (!made)
        qFatal("%s", made.error().message.c_str());
}

enum class ColumnKind
{
    Arbitrary, // any finite double
    Wild,      // NaN with payload, infinities, both zeros, denormals
    Decimals,
    Float32,
    Counts, // times a sensitivity
    Clock,  // a line with jitter
    Constant,
};
inline constexpr int kColumnKinds = 7;

inline double columnValue(ColumnKind kind, Random &random, Eigen::Index i)
{
    switch (kind) {
    case ColumnKind::Arbitrary:
        return random.normal() * std::pow(10.0, static_cast<double>(random.below(20)) - 10.0);
    case ColumnKind::Wild: {
        const std::uint64_t bits =
            random.below(4) == 0 ? 0x7ff8000000000000ULL + random.below(1000) : random.bits();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return random.below(8) == 0 ? -0.0 : value;
    }
    case ColumnKind::Decimals:
        return std::round(random.normal() * 1e4) / 1e4;
    case ColumnKind::Float32:
        return static_cast<double>(static_cast<float>(random.normal()));
    case ColumnKind::Counts:
        return std::round(random.normal() * 300.0) * 0.00875;
    case ColumnKind::Clock:
        return 1000.0 + static_cast<double>(i) * 0.001 * (1.0 + 1e-5) + 1e-7 * random.normal();
    case ColumnKind::Constant:
        return 25.0;
    }
    return 0.0;
}

inline Recording randomRecording(std::uint64_t seed, Eigen::Index size)
{
    Random random(seed);
    Recording recording;
    recording.timeS.resize(size);
    recording.temperatureC.resize(size);
    recording.rateDps.resize(size, 3);
    std::array<ColumnKind, 5> kinds{};
    for (ColumnKind &kind : kinds)
        kind = static_cast<ColumnKind>(random.below(kColumnKinds));
    for (Eigen::Index i = 0; i < size; ++i) {
        recording.timeS[i] = columnValue(kinds[0], random, i);
        recording.temperatureC[i] = columnValue(kinds[1], random, i);
        for (int axis = 0; axis < 3; ++axis)
            recording.rateDps(i, axis) = columnValue(kinds[static_cast<std::size_t>(2 + axis)], random, i);
    }
    recording.info = {"logs/random.csv", "csv", 1,
                      {"L3GD20H", "77"}, true,  {"The reader noticed something."}};
    return recording;
}

// What a device at that rate would give: counts at 8.75 mdps, temperature in hundredths of a degree.
inline Recording measuredRecording(std::uint64_t seed, Eigen::Index size, double rateHz)
{
    Random random(seed);
    Recording recording;
    recording.timeS.resize(size);
    recording.temperatureC.resize(size);
    recording.rateDps.resize(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
        recording.timeS[i] = static_cast<double>(i) / rateHz;
        recording.temperatureC[i] =
            std::round(2000.0 + 1e-3 * static_cast<double>(i) + random.normal()) / 100.0;
        for (int axis = 0; axis < 3; ++axis)
            recording.rateDps(i, axis) = std::round(random.normal() * 16.0) * 875.0 / 100000.0;
    }
    recording.info.sensor = {"L3GD20H", "SIM-0001"};
    recording.info.simulated = true;
    return recording;
}

template <class Columns>
bool sameBits(const Columns &a, const Columns &b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           (a.size() == 0 ||
            std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(*a.data())) == 0);
}

inline bool sameSamples(const Recording &a, const Recording &b)
{
    return sameBits(a.timeS, b.timeS) && sameBits(a.temperatureC, b.temperatureC) &&
           sameBits(a.rateDps, b.rateDps);
}

inline bool sameOverview(const RunOverview &a, const RunOverview &b)
{
    return sameBits(a.startS, b.startS) && sameBits(a.endS, b.endS) && sameBits(a.lowest, b.lowest) &&
           sameBits(a.highest, b.highest) && sameBits(a.mean, b.mean);
}

inline Recording rowsOf(const Recording &recording, Eigen::Index first, Eigen::Index count)
{
    return {recording.timeS.segment(first, count), recording.temperatureC.segment(first, count),
            recording.rateDps.middleRows(first, count), recording.info};
}

inline SampleBlock blockOf(const Recording &recording, Eigen::Index first, Eigen::Index count)
{
    return {first, recording.timeS.segment(first, count), recording.temperatureC.segment(first, count),
            recording.rateDps.middleRows(first, count)};
}

inline SourceInfo sourceOf(const Recording &recording, double rateHz)
{
    return {"a test", recording.info.sensor, rateHz, 245.0, true, false};
}

} // namespace driftbench::test
