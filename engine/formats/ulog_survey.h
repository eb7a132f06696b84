// A first pass through a ULog: which gyros it holds, and where the temperature of each comes from.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/log_reader.h"
#include "engine/formats/ulog_parser.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// The fields of a topic that matter here, found once for every subscription.
struct ULogGyroFields
{
    const ULogField *timestamp = nullptr;
    const ULogField *rate[3] = {nullptr, nullptr, nullptr}; // x, y, z; or all the same array
    bool rateIsArray = false;
    const ULogField *temperature = nullptr;
    const ULogField *deviceId = nullptr;

    explicit ULogGyroFields(const ULogFormat &format);
    bool hasRate() const { return rate[0] != nullptr && rate[1] != nullptr && rate[2] != nullptr; }

    double timeS(std::string_view data) const;
    double temperatureC(std::string_view data) const; // NaN without
    Eigen::Vector3d rateDps(std::string_view data) const;
};

struct ULogStream
{
    std::string topic;
    int multiId = 0;

    bool operator==(const ULogStream &) const = default;
    bool carries(const ULogMessage &message) const
    {
        return message.subscription != nullptr && message.subscription->multiId == multiId &&
               message.subscription->topic == topic;
    }
};

struct ULogGyro
{
    LogInstance listed;
    ULogStream rates;
    ULogStream temperature; // the same as rates where the topic has both
};

struct ULogSurvey
{
    std::vector<ULogGyro> gyros;
    std::vector<int> preferred; // instances to choose from where none is named
    std::vector<std::string> warnings;
    bool compensatedOnBoard = false; // the autopilot's own thermal compensation was switched on
};

Result<ULogSurvey> surveyULog(const std::filesystem::path &path, const ProgressHook &hook);

} // namespace driftbench
