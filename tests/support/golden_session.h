// What a golden session file holds, for the program that writes one and the test that reads it back.
#pragma once

#include "support/session_data.h"

namespace driftbench::test {

inline Recording goldenRecording()
{
    Recording recording = measuredRecording(1, 600, 100.0);
    // A column in each form: line, float32 and raw beside grid.
    Random random(2);
    for (Eigen::Index i = 0; i < recording.size(); ++i) {
        recording.timeS[i] = 100.0 + static_cast<double>(i) * 0.01 * (1.0 + 1e-5);
        recording.rateDps(i, 1) = static_cast<double>(static_cast<float>(random.normal()));
        recording.rateDps(i, 2) = random.normal();
    }
    recording.info.source = "golden.csv";
    recording.info.format = "csv";
    return recording;
}

// Status of the first thing that failed.
inline Status fillGoldenSession(SessionFile &file)
{
    const Recording recording = goldenRecording();
    RunDescription what = describeRecording(recording.info, "golden");
    what.referenceRateDps = {25.0, 5.0, 53.0};
    what.startedUtc = "2026-01-02T03:04:05.678Z";
    const auto run = file.importRun(recording, what);
    if (!run)
        return run.error();
    Mask mask(recording.size());
    mask.set(10, MaskReason::Motion);
    mask.set(11, MaskReason::Motion);
    if (Status set = file.setMask(*run, mask); !set)
        return set;
    if (Status set = file.setExclusions(*run, {{{101.0, 102.0}, "a knock"}}); !set)
        return set;
    if (Status set = file.setDocument("view", "{}"); !set)
        return set;
    if (const auto noted = file.addNote({0, what.startedUtc, *run, "A note."}); !noted)
        return noted.error();
    if (Status added = file.addUpload({what.startedUtc,
                                       {},
                                       recording.info.sensor,
                                       "bridge",
                                       "fixed",
                                       1,
                                       7,
                                       2048,
                                       42,
                                       true,
                                       true,
                                       "The table is in use."});
        !added)
        return added;
    return file.addEvent({*run, 5, what.startedUtc, "device", "Saturated on x."});
}

} // namespace driftbench::test
