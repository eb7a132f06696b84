// A recorded log as a run's features, whole but for its first rows: for tests of judging, which have no use
// for the checks of a recording.
#pragma once

#include "engine/features/run_features.h"
#include "engine/formats/log_reader.h"

#include <filesystem>
#include <memory>
#include <string>

namespace driftbench::test {

// skip: samples left out at the start. Reference rate zero.
inline std::shared_ptr<const RunFeatures> recordedRun(const std::filesystem::path &file,
                                                      const std::string &name, Eigen::Index skip,
                                                      double referenceTemperatureC)
{
    const Recording recording = readLog(file, {}).value();
    const Eigen::Index count = recording.size() - skip;
    auto run = std::make_shared<RunFeatures>();
    run->name = name;
    run->timeS = recording.timeS.tail(count);
    run->deltaT = recording.temperatureC.tail(count).array() - referenceTemperatureC;
    run->tdeDps = recording.rateDps.bottomRows(count);
    run->usableForTraining.assign(static_cast<std::size_t>(count), 1);
    run->curve.add(run->deltaT, run->tdeDps);
    return run;
}

} // namespace driftbench::test
