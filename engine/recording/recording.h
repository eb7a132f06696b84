// A log of one gyro as columns: N samples of time, temperature and three rates.
#pragma once

#include <Eigen/Core>
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

struct Recording
{
    Eigen::VectorXd timeS;        // N, in the log's own time base
    Eigen::VectorXd temperatureC; // N
    Eigen::MatrixX3d rateDps;     // N x 3
    RecordingInfo info;

    Eigen::Index size() const { return timeS.size(); }
    bool empty() const { return size() == 0; }
};

} // namespace driftbench
