// Log files -> Recording. The format is found by content, never by the name of the file:
//   csv        text with columns: CSV, TSV, with semicolons (csv_reader.h)
//   ulog       PX4 (ulog_reader.h)
//   dataflash  ArduPilot, binary (dataflash_reader.h)
// Rates come in dps, temperatures in degrees Celsius, time in seconds of the log's own clock. Memory is
// bounded except for what readLog returns. A damaged or cut log gives what is good in it and a warning in
// info.warnings that names the byte; if nothing is good, DamagedLog.
//
// Errors: FileNotFound, FileUnreadable, FileEmpty, UnknownFormat, MissingColumn, NotANumber, TooFewSamples,
// DamagedLog, NoSuchInstance (its message lists the instances), InvalidOption, Cancelled.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/read_options.h"
#include "engine/formats/sample_block.h"
#include "engine/recording/recording.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class LogFormat
{
    Csv,
    ULog,
    DataFlash
};

std::string_view logFormatName(LogFormat format); // as in RecordingInfo::format

Result<LogFormat> detectFormat(const std::filesystem::path &path);

// One gyro of a log.
struct LogInstance
{
    int instance = 0;
    std::string name; // what the log calls it: "sensor_gyro 1", "IMU3"; empty for CSV
    SensorIdentity sensor;
    std::int64_t samples = 0;
    double startS = 0.0;
    double durationS = 0.0;
    // NaN where the log has no temperature for it.
    double lowestTemperatureC = std::numeric_limits<double>::quiet_NaN();
    double highestTemperatureC = std::numeric_limits<double>::quiet_NaN();

    bool hasTemperature() const { return lowestTemperatureC <= highestTemperatureC; }
    double meanRateHz() const // 0 with under two samples
    {
        return durationS > 0.0 ? static_cast<double>(samples - 1) / durationS : 0.0;
    }
};

// In the order of their numbers; at least one.
Result<std::vector<LogInstance>> listInstances(const std::filesystem::path &path, const ReadOptions &options,
                                               const ProgressHook &hook = {});

Result<Recording> readLog(const std::filesystem::path &path, const ReadOptions &options,
                          const ProgressHook &hook = {});

// The same log handed over in blocks; for logs that are larger than memory.
Result<RecordingInfo> readLogBlocks(const std::filesystem::path &path, const ReadOptions &options,
                                    const BlockSink &sink, const ProgressHook &hook = {});

} // namespace driftbench
