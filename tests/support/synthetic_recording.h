// A gyro at rest in a slow temperature ramp, for tests that then do something to it.
#pragma once

#include "engine/base/random.h"
#include "engine/recording/recording.h"

#include <cstdint>

namespace driftbench::test {

struct RestingGyro
{
    double durationS = 1200.0;
    double intervalS = 0.1;
    double noiseDps = 0.14;
    double startC = 0.0;
    double rampCPerS = 0.05;
    double driftDpsPerC = 0.02;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::uint64_t seed = 1;
};

inline Recording restingRecording(const RestingGyro &gyro = {})
{
    const auto size = static_cast<Eigen::Index>(gyro.durationS / gyro.intervalS);
    Random random(gyro.seed);
    Recording recording;
    recording.timeS.resize(size);
    recording.temperatureC.resize(size);
    recording.rateDps.resize(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
        recording.timeS[i] = static_cast<double>(i) * gyro.intervalS;
        recording.temperatureC[i] = gyro.startC + gyro.rampCPerS * recording.timeS[i];
        for (int axis = 0; axis < 3; ++axis) {
            recording.rateDps(i, axis) = gyro.referenceRateDps[axis] +
                                         gyro.driftDpsPerC * recording.temperatureC[i] +
                                         gyro.noiseDps * random.normal();
        }
    }
    recording.info.source = "resting.csv";
    return recording;
}

// Adds rateDps to one axis from startS to endS.
inline void turn(Recording &recording, double startS, double endS, double rateDps, int axis = 0)
{
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        if (recording.timeS[i] >= startS && recording.timeS[i] < endS)
            recording.rateDps(i, axis) += rateDps;
    }
}

} // namespace driftbench::test
