// Records from a source: the source runs on a thread of its own, the caller's thread is told now and then how
// it goes and may end it. Where the samples go is the sink's affair (csv_recorder.h).
#pragma once

#include "app/recording/recording_monitor.h"

#include <functional>
#include <optional>

namespace driftbench {

struct RecordOptions
{
    double durationS = 0.0;  // of the samples' time; 0: until the source ends or someone asks
    bool isRealTime = false; // the time also passes when nothing comes: end then as well
    double tickS = 0.1;
};

enum class RecordingEnd
{
    Duration, // as long as was wanted
    Source,   // the source has ended
    Asked,    // the tick said Stop
    Sink,     // the sink said Stop
    Error,    // of the source
};

struct RecordingOutcome
{
    RecordingEnd end = RecordingEnd::Source;
    RecordingState state;
    std::optional<SourceStats> stats; // unless an error ended it
    Status status;                    // that error
};

using RecordingTick = std::function<Flow(const RecordingState &)>;

RecordingOutcome record(SampleSource &source, SampleSink &sink, const RecordOptions &options,
                        const RecordingTick &tick);

} // namespace driftbench
