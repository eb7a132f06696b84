// What a CSV can't say of itself stands in a small JSON file beside it, <file>.meta.json:
//   {"sensor": {"model": "I3G4250D", "serial": "SIM-0001"}, "simulated": true}
// Simulated runs also say "reference_rate_dps": [x, y, z]. Every field may be missing; fields that are not
// known here are left alone.
#pragma once

#include "engine/base/result.h"
#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

namespace driftbench {

std::filesystem::path sidecarPath(const std::filesystem::path &log);

// Takes sensor and origin from the log's sidecar, if there is one, into info; adds a warning if it is
// damaged.
void readSidecar(const std::filesystem::path &log, RecordingInfo &info);

std::string sidecarText(const RecordingInfo &info,
                        const std::optional<Eigen::Vector3d> &referenceRateDps = std::nullopt);

Status writeSidecar(const std::filesystem::path &log, const RecordingInfo &info);

} // namespace driftbench
