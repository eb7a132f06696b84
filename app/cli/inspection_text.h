// What `inspect` found, as text and as JSON.
#pragma once

#include "engine/formats/log_reader.h"
#include "engine/recording/quality.h"
#include "engine/recording/run_report.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace driftbench::cli {

struct Inspection
{
    std::string file;
    RecordingInfo info;
    RunReport report;
    std::vector<Finding> findings;
    std::optional<Error> refusal;
};

std::string instancesAsText(const std::string &file, const std::vector<LogInstance> &instances);
nlohmann::ordered_json instancesToJson(const std::vector<LogInstance> &instances);

std::string inspectionAsText(const Inspection &inspection);
nlohmann::ordered_json inspectionToJson(const Inspection &inspection);

} // namespace driftbench::cli
