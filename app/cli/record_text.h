// What `record` says while it records and when it is done.
#pragma once

#include "app/recording/csv_recorder.h"
#include "engine/physics/temperature_profile.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace driftbench::cli {

struct RecordingGoal
{
    double durationS = 0.0;                    // 0: none
    std::optional<TemperatureProfile> profile; // that the chamber follows
};

// "  12 %  T 23.41 °C (plan 23.5)  x 0.13  y -0.02  z 1.10 dps  1000.0 Hz  12345 samples  0 lost  9 min left"
std::string recordingLine(const RecordingState &state, const RecordingGoal &goal);

std::string recordingAsText(const RecordingOutcome &outcome, const CsvRecorder &recorder);
nlohmann::ordered_json recordingAsJson(const RecordingOutcome &outcome, const CsvRecorder &recorder);

} // namespace driftbench::cli
