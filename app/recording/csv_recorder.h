// A sink that writes a recording as it comes, so that whatever ends the program leaves what was recorded:
//
//   run1.csv              the samples, with the sensor in comments before the header; readLog reads it
//   run1.csv.events.csv   time_s,end_s,kind,lost_samples,text: each gap and event, also as it comes
//   run1.csv.meta.json    sensor, origin (sidecar.h) and, under "recording", how it was made; at the end also
//                         what it has come to, and "complete": true
//
// What was handed over is with the system at once; sync() brings it to the disk. A gap is a gap in the
// samples too: nothing is ever filled in.
//
// Errors: OutputNotWritable, OutputFull. After the first one nothing more is written, and samples() says
// Stop.
#pragma once

#include "app/recording/record.h"
#include "device/sample_source.h"
#include "engine/base/growing_file.h"
#include "engine/formats/csv_writer.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace driftbench {

struct CsvRecorderOptions
{
    std::filesystem::path out;
    std::filesystem::path events{}; // empty: beside it
    bool replace = false;           // files that are there
    CsvDecimals decimals{};         // nothing: as few digits as give the same number back
    std::optional<Eigen::Vector3d> referenceRateDps{};
    std::string source{}; // as the user named it
};

class CsvRecorder final : public SampleSink
{
public:
    static Result<CsvRecorder> create(const SourceInfo &info, CsvRecorderOptions options);

    Flow samples(const SampleBlock &block, Eigen::Index count) override;
    void gap(const SampleGap &gap) override;
    void event(const std::string &sentence) override;

    Status sync() const; // from another thread, about every second
    // What could not be written, else completes the sidecar.
    Status finish(const RecordingOutcome &outcome);

    const std::filesystem::path &path() const { return m_options.out; }
    const std::filesystem::path &eventsPath() const { return m_options.events; }

private:
    CsvRecorder(GrowingFile samples, GrowingFile events, const SourceInfo &info, CsvRecorderOptions options);
    Status writeSidecar(const RecordingOutcome *outcome) const;
    void keep(const Status &written);
    void addEventRow(const std::string &times, const std::string &kind, const std::string &rest);

    GrowingFile m_samples;
    GrowingFile m_events;
    SourceInfo m_info;
    CsvRecorderOptions m_options;
    std::string m_startedAt; // UTC
    std::string m_text;      // of a block, reused
    double m_lastS = 0.0;
    Status m_status;
};

std::string_view recordingEndName(RecordingEnd end); // "duration", "source", "stopped", ...

// samples, lost_samples, gaps, ... as the sidecar and `record --json` have them.
nlohmann::ordered_json outcomeAsJson(const RecordingOutcome &outcome);

} // namespace driftbench
