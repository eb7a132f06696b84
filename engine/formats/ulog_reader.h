// PX4 ULog -> samples.
//
// The gyros of a log are the instances of sensor_gyro (their numbers are the topic's multi ids), each with
// the temperature of its own die. Logs also hold sensor_combined, the selected gyro at the full rate without
// a temperature: it is listed behind the others, and its temperature is interpolated in time from, in this
// order: sensor_gyro (of the selected device, else of the first instance), sensor_accel, the barometer. It is
// chosen by itself only where no sensor_gyro can be read. The device id is the serial number.
//
// Errors: those of ULogParser::open; MissingColumn (no gyro topic, no temperature), NoSuchInstance,
// DamagedLog, Cancelled. Source: ULog file format, PX4 developer guide; the uORB definitions of the topics.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/log_reader.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace driftbench {

bool looksLikeULog(std::string_view beginning);

Result<std::vector<LogInstance>> listULog(const std::filesystem::path &path, const ProgressHook &hook = {});

Result<RecordingInfo> readULogBlocks(const std::filesystem::path &path, std::optional<int> instance,
                                     const BlockSink &sink, const ProgressHook &hook = {});

} // namespace driftbench
