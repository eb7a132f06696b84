// A log of one gyro as columns: N samples of time, temperature and three rates. Of a long one, N means of
// samples.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace driftbench {

// Which sensor measured. Empty strings: the log does not say.
struct SensorIdentity
{
    std::string model;  // "I3G4250D"
    std::string serial; // serial number, or the device id of the autopilot

    bool known() const { return !model.empty() || !serial.empty(); }
    // Two identities contradict each other where both state a field and the fields differ.
    bool contradicts(const SensorIdentity &other) const;
    std::string text() const; // "I3G4250D SIM-0001", or "unknown sensor"
};

struct RecordingInfo
{
    std::string source; // file name as the user gave it
    std::string format; // "csv", "ulog", "dataflash", "simulator"
    int instance = 0;   // of the sensors in the log
    SensorIdentity sensor;
    bool simulated = false;
    std::vector<std::string> warnings; // of the reader, each a sentence
};

// What stands behind the rows of a recording whose rows are means over samples (block_means.h). No rows: each
// row is one sample.
struct PointSamples
{
    Eigen::VectorXi samples;       // N, of each point
    Eigen::MatrixX3f varianceDps2; // N x 3, of the rates among them: (1/n) sum (rate - mean)^2

    bool empty() const { return samples.size() == 0; }
    double countAt(Eigen::Index row) const { return empty() ? 1.0 : samples[row]; }
    Eigen::Vector3d varianceAt(Eigen::Index row) const; // 0 for a sample
    PointSamples rows(const std::vector<Eigen::Index> &kept) const;
};

struct Recording
{
    Eigen::VectorXd timeS;        // N, in the log's own time base
    Eigen::VectorXd temperatureC; // N
    Eigen::MatrixX3d rateDps;     // N x 3
    RecordingInfo info;
    PointSamples points{};

    Eigen::Index size() const { return timeS.size(); }
    std::int64_t samples() const; // of all rows
    bool empty() const { return size() == 0; }
};

} // namespace driftbench
