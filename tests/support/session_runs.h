// Runs and results for the tests of the session: short, made by the simulator, with everything that a
// calibration needs.
#pragma once

#include "app/session/prepared_campaign.h"
#include "app/session/session.h"
#include "support/simulated_runs.h"

#include <QString>

#include <string>

namespace driftbench::test {

// A sweep of 40 degrees in 20 min at 2 Hz; run: which of the campaign.
inline Recording shortRun(int run)
{
    auto profile = TemperatureProfile::build(
        "short", -10.0, {HoldSegment{120.0}, RampSegment{30.0, 1.0, 24.0}, HoldSegment{120.0}});
    if (!profile)
        qFatal("%s", profile.error().message.c_str());
    SimulationOptions options = optionsFor("quick", "curved");
    options.profile = *profile;
    options.gyro.sampleRateHz = 2.0;
    options.gyro.spread = 0.01;
    Recording recording = driftbench::test::run(options, run);
    recording.info.sensor = {"L3GD20H", "T-1"};
    return recording;
}

// Imports as many into the session's file.
inline void addRuns(Session &session, int count)
{
    auto file = session.anotherFile();
    if (!file)
        qFatal("%s", file.error().message.c_str());
    for (int i = 0; i < count; ++i) {
        const Recording recording = shortRun(i);
        RunDescription description = describeRecording(recording.info, "run " + std::to_string(i + 1));
        const auto run = (*file)->importRun(recording, description);
        if (!run)
            qFatal("%s", run.error().message.c_str());
    }
    if (const Status read = session.refreshRuns(); !read)
        qFatal("%s", read.error().message.c_str());
}

} // namespace driftbench::test
