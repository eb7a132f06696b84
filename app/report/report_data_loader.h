// Reads what `driftbench-cli fit` left in a folder or in a session, and the runs that it was made from.
#pragma once

#include "app/report/report_data.h"
#include "engine/base/result.h"

#include <filesystem>

namespace driftbench {

struct CalibrationResult;
struct PreparedCampaign;

// What a session holds: the runs as they were prepared, and what was found by them.
ReportData reportDataOf(const PreparedCampaign &prepared, const CalibrationResult &result);

// folder: a session (by its ending), or comparison.json, request.json (which runs, read how),
// models/<name>.json, held-out/<run>/<model>.json. A held-out model that is missing only costs its figures
// and leaves a warning; all else that is missing or damaged is an error.
Result<ReportData> loadReportData(const std::filesystem::path &folder);

} // namespace driftbench
