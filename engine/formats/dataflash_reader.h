// ArduPilot DataFlash -> samples.
//
// The gyros of a log are its messages IMU, IMU2, IMU3, ... (numbers 0, 1, 2, ...) or, in newer logs, IMU
// alone with the number in its field I. Fields: TimeUS or TimeMS, GyrX, GyrY, GyrZ in rad/s, T or Temp in
// degrees Celsius. The parameters INS_GYR_ID, INS_GYR2_ID, ... (INS4_GYR_ID, ...) give the device id, which
// is the serial number; INS_TCALn_ENABLE says that the autopilot compensated by itself, which is warned of.
//
// Errors: those of FileWindow::open; MissingColumn (no IMU message, no temperature), NoSuchInstance,
// DamagedLog, Cancelled. Source: ArduPilot log message documentation (IMU) and parameter list.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/log_reader.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace driftbench {

bool looksLikeDataFlash(std::string_view beginning);

Result<std::vector<LogInstance>> listDataFlash(const std::filesystem::path &path,
                                               const ProgressHook &hook = {});

Result<RecordingInfo> readDataFlashBlocks(const std::filesystem::path &path, std::optional<int> instance,
                                          const BlockSink &sink, const ProgressHook &hook = {});

} // namespace driftbench
