// What is in a file that may become a source, as the list of recent files shows it: found by reading it
// whole, so not on a thread that draws.
#pragma once

#include "engine/base/progress.h"
#include "engine/recording/recording.h"
#include "widgets/controls/origin_chip.h"
#include "widgets/controls/text_label.h"

#include <QString>

#include <filesystem>
#include <optional>

namespace driftbench {

enum class FileKind
{
    Unknown, // not looked at yet, or not readable
    Session,
    Log
};

// What is to be expected of it, in the words of the table.
struct FileSurvey
{
    std::filesystem::path path;
    FileKind kind = FileKind::Unknown;
    Origin origin = Origin::None;
    QString format; // "CSV", "DataFlash", "ULog", "Session"
    std::int64_t samples = -1;
    double durationS = -1.0;
    int runs = 0; // of a session
    int plannedRuns = 0;
    double lowestC = 0.0, highestC = 0.0;
    bool hasTemperature = false;
    SensorIdentity sensor;
    std::optional<int> instance; // the gyro that was looked at, of several in the log
    bool isTrainable =
        false; // on its own merits; whether there is another run to judge it by is not its affair
    QString expect;
    Tone tone = Tone::Plain;
};

// A file that can't be read gives a survey that says so. Cancelled by the hook: nothing but the path.
FileSurvey surveyFile(const std::filesystem::path &path, const ProgressHook &hook = {});

} // namespace driftbench
