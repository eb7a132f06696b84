// What a session file holds, as plain values (docs/session-format.md has the same as tables).
#pragma once

#include "device/sample_source.h"
#include "engine/recording/quality.h"
#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

using RunId = std::int64_t;
using ModelId = std::int64_t;

enum class RunState
{
    Recording,   // being recorded, now
    Interrupted, // the program that recorded it ended; complete up to its last commit
    Complete,
    Imported, // from a log file
};

std::string_view runStateName(RunState state); // "recording", "interrupted", "complete", "imported"

// What is known of a run when it starts.
struct RunDescription
{
    std::string name;   // short; made unique in the file by a number behind it
    std::string source; // "native bridge SIM-0001", or the file as the user gave it
    std::string format; // "live", "csv", "ulog", "dataflash", "simulator"
    int instance = 0;   // of the sensors in a log
    SensorIdentity sensor;
    bool simulated = false;
    bool compensated = false;
    double sampleRateHz = 0.0; // 0: not known
    double rangeDps = 0.0;     // 0: not known
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    std::string startedUtc; // "2026-05-04T10:11:12.345Z"; empty: now
};

RunDescription describeSource(const SourceInfo &info, const std::string &runName);
RunDescription describeRecording(const RecordingInfo &info, const std::string &runName);

struct RunRecord
{
    RunId id = 0;
    RunDescription description;
    RunState state = RunState::Complete;
    std::string endedUtc; // empty while it is being recorded
    std::int64_t samples = 0;
    double firstTimeS = 0.0; // of the first and the last sample; 0 without samples
    double lastTimeS = 0.0;
};

struct RunGap
{
    SampleGap gap;
    std::int64_t beforeSample = 0; // index of the first sample behind it
};

// What was noticed while recording or later: "gap", "device", "recorder", "recovery", "reader".
struct SessionEvent
{
    std::optional<RunId> run;
    std::int64_t atSample = 0; // so many samples of the run came before it
    std::string utc;           // empty: now
    std::string kind;
    std::string text; // a sentence
};

// Taken out by the user.
struct Exclusion
{
    TimeRange range; // in the run's time
    std::string note;
};

// Figures of kOverviewSamples samples each (the last of a chunk may have fewer), for quick plots. Columns:
// temperature in degrees Celsius, rates x, y, z in dps. Values that are not finite are left out; NaN where
// nothing is left.
inline constexpr int kOverviewSamples = 256;
inline constexpr int kOverviewColumns = 4;
struct RunOverview
{
    using Table = Eigen::Matrix<float, Eigen::Dynamic, kOverviewColumns>;

    Eigen::VectorXd startS; // B: time of the first and last sample
    Eigen::VectorXd endS;
    Table lowest; // B x 4
    Table highest;
    Table mean;

    Eigen::Index size() const { return startS.size(); }
};

struct ModelRecord
{
    ModelId id = 0;
    std::string name; // "rbf", "cubic", ...
    std::string createdUtc;
    std::vector<std::string> trainedOn; // runs, by the names that they had
};

struct ComparisonRecord
{
    std::int64_t id = 0;
    std::string createdUtc;
    std::string comparisonJson; // comparisonToJson
    std::string recommendationJson;
};

struct ExportRecord
{
    std::string utc; // empty: now
    std::optional<ModelId> model;
    std::string format; // "csv", "json", "c", "px4", "ardupilot", "device"
    std::string path;
    std::int64_t bytes = 0;
    std::uint32_t crc32 = 0;
};

struct UploadRecord
{
    std::string utc; // empty: now
    std::optional<ModelId> model;
    SensorIdentity sensor; // of the device
    std::string device;    // as it called itself
    std::string kind;      // "fixed", "float"
    int bank = 0;
    std::uint32_t generation = 0;
    std::int64_t bytes = 0;
    std::uint32_t crc32 = 0;
    bool verified = false; // read back and compared
    bool activated = false;
    std::string outcome; // a sentence
};

struct NoteRecord
{
    std::int64_t id = 0;
    std::string utc; // empty: now
    std::optional<RunId> run;
    std::string text;
};

} // namespace driftbench
