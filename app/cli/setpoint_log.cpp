#include "app/cli/setpoint_log.h"

#include "engine/formats/log_reader.h"
#include "engine/physics/lag_estimate.h"

#include <cmath>

namespace driftbench::cli {

namespace {

// The reader wants rates; where a column is named that stands in for them, they are that one.
ReadOptions readingOnly(const SetpointColumns &columns, const std::string &temperature)
{
    ReadOptions read;
    read.csv.column(CsvQuantity::Time) = columns.time;
    read.csv.column(CsvQuantity::Temperature) = temperature;
    const std::string &standIn = columns.setpoint.empty() ? temperature : columns.setpoint;
    for (const CsvQuantity rate : {CsvQuantity::RateX, CsvQuantity::RateY, CsvQuantity::RateZ})
        read.csv.column(rate) = standIn;
    read.csv.rateUnit = RateUnit::DegreesPerSecond;
    return read;
}

} // namespace

Result<SetpointLog> readSetpointLog(const std::filesystem::path &file, const SetpointColumns &columns,
                                    const TestPlan &plan, const ProgressHook &hook)
{
    const auto measured = readLog(file, readingOnly(columns, columns.temperature), hook);
    if (!measured)
        return measured.error();
    Eigen::VectorXd setpointC = Eigen::VectorXd::Zero(measured->size());
    if (!columns.setpoint.empty()) {
        auto wanted = readLog(file, readingOnly(columns, columns.setpoint), hook);
        if (!wanted)
            return wanted.error();
        setpointC = std::move(wanted->temperatureC);
    }
    SetpointLog log{{}, Eigen::VectorXd(measured->size()), Eigen::VectorXd(measured->size())};
    Eigen::Index kept = 0;
    for (Eigen::Index i = 0; i < std::min(measured->size(), setpointC.size()); ++i) {
        if (!std::isfinite(measured->temperatureC[i]) || !std::isfinite(setpointC[i]))
            continue;
        log.timeS[kept] = measured->timeS[i];
        log.temperatureC[kept] = measured->temperatureC[i];
        setpointC[kept++] = setpointC[i];
    }
    if (kept == 0)
        return Error{Errc::TooFewSamples, file.string() + " has no sample with temperature and set-point."};
    log.timeS.conservativeResize(kept);
    log.temperatureC.conservativeResize(kept);
    if (!columns.setpoint.empty()) {
        log.setpoint = setpointSteps(log.timeS, setpointC.head(kept));
        return log;
    }
    const auto profile = plan.profile();
    if (!profile)
        return profile.error();
    for (const ProfileStep &step : profile->steps())
        log.setpoint.push_back({log.timeS[0] + step.startS, step.setpointC});
    return log;
}

} // namespace driftbench::cli
