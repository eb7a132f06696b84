#include "app/recording/csv_recorder.h"

#include "engine/base/atomic_file.h"
#include "engine/formats/sidecar.h"

#include <cassert>
#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kEventsHeader = "time_s,end_s,kind,lost_samples,text\n";
constexpr int kTimeDecimals = 6;

std::string utcNow()
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

// What a device calls itself may hold anything, but a comment has one line.
std::string onOneLine(std::string text)
{
    for (char &c : text)
        c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return text;
}

std::string head(const SourceInfo &info)
{
    std::string text;
    if (!info.sensor.model.empty())
        text += "# sensor_model: " + onOneLine(info.sensor.model) + '\n';
    if (!info.sensor.serial.empty())
        text += "# sensor_serial: " + onOneLine(info.sensor.serial) + '\n';
    if (info.simulated)
        text += "# simulated: true\n";
    return text + std::string(kCsvHeader) + '\n';
}

std::string quoted(const std::string &text)
{
    std::string field = "\"";
    for (const char c : onOneLine(text))
        field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + '"';
}

std::string timeText(double timeS)
{
    std::string text;
    appendNumber(text, timeS, kTimeDecimals);
    return text;
}

// JSON has no NaN.
Json numberOrNull(bool known, double value)
{
    return known && std::isfinite(value) ? Json(value) : Json(nullptr);
}

} // namespace

Result<CsvRecorder> CsvRecorder::create(const SourceInfo &info, CsvRecorderOptions options)
{
    if (options.events.empty())
        options.events = options.out.string() + ".events.csv";
    auto samples = GrowingFile::create(options.out, options.replace);
    if (!samples)
        return samples.error();
    // Those of an earlier recording of that name would be taken for this one's.
    auto events = GrowingFile::create(options.events, true);
    if (!events)
        return events.error();
    if (const Status written = samples->append(head(info)); !written)
        return written.error();
    if (const Status written = events->append(kEventsHeader); !written)
        return written.error();
    CsvRecorder recorder(*std::move(samples), *std::move(events), info, std::move(options));
    if (const Status written = recorder.writeSidecar(nullptr); !written)
        return written.error();
    return recorder;
}

CsvRecorder::CsvRecorder(GrowingFile samples, GrowingFile events, const SourceInfo &info,
                         CsvRecorderOptions options)
    : m_samples(std::move(samples))
    , m_events(std::move(events))
    , m_info(info)
    , m_options(std::move(options))
    , m_startedAt(utcNow())
{
}

Flow CsvRecorder::samples(const SampleBlock &block, Eigen::Index count)
{
    if (!m_status)
        return Flow::Stop;
    m_text.clear();
    appendCsvRows(m_text, block, count, m_options.decimals);
    keep(m_samples.append(m_text));
    m_lastS = block.timeS[count - 1];
    return m_status ? Flow::Continue : Flow::Stop;
}

void CsvRecorder::gap(const SampleGap &gap)
{
    addEventRow(timeText(gap.startS) + ',' + timeText(gap.endS), "gap",
                (gap.lostSamples < 0 ? "" : std::to_string(gap.lostSamples)) + ',' +
                    quoted(std::string(gapCauseText(gap.cause))));
}

void CsvRecorder::event(const std::string &sentence)
{
    addEventRow(timeText(m_lastS) + ',', "event", ',' + quoted(sentence));
}

void CsvRecorder::addEventRow(const std::string &times, const std::string &kind, const std::string &rest)
{
    if (m_status)
        keep(m_events.append(times + ',' + kind + ',' + rest + '\n'));
}

void CsvRecorder::keep(const Status &written)
{
    if (m_status && !written)
        m_status = written;
}

Status CsvRecorder::sync() const
{
    if (const Status ok = m_samples.sync(); !ok)
        return ok;
    return m_events.sync();
}

Status CsvRecorder::finish(const RecordingOutcome &outcome)
{
    if (!m_status)
        return m_status;
    if (const Status ok = sync(); !ok)
        return ok;
    return writeSidecar(&outcome);
}

Status CsvRecorder::writeSidecar(const RecordingOutcome *outcome) const
{
    RecordingInfo info;
    info.sensor = m_info.sensor;
    info.simulated = m_info.simulated;
    Json meta = Json::parse(sidecarText(info, m_options.referenceRateDps));
    Json &recording = meta["recording"];
    recording = {{"source", m_options.source},
                 {"device", m_info.name},
                 {"started_at", m_startedAt},
                 {"nominal_rate_hz", numberOrNull(m_info.sampleRateHz > 0.0, m_info.sampleRateHz)},
                 {"range_dps", numberOrNull(m_info.rangeDps > 0.0, m_info.rangeDps)},
                 {"compensated", m_info.compensated},
                 {"events", m_options.events.filename().string()},
                 {"complete", outcome != nullptr}};
    if (outcome)
        recording.update(outcomeAsJson(*outcome));
    constexpr auto kReplace = Json::error_handler_t::replace;
    return writeFileAtomically(sidecarPath(m_options.out), meta.dump(2, ' ', false, kReplace) + '\n');
}

std::string_view recordingEndName(RecordingEnd end)
{
    switch (end) {
    case RecordingEnd::Duration:
        return "duration";
    case RecordingEnd::Source:
        return "source";
    case RecordingEnd::Asked:
        return "stopped";
    case RecordingEnd::Sink:
        return "output";
    case RecordingEnd::Error:
        return "error";
    }
    assert(false);
    return {};
}

Json outcomeAsJson(const RecordingOutcome &outcome)
{
    const RecordingState &state = outcome.state;
    const SourceStats stats = outcome.stats.value_or(SourceStats{});
    const bool known = outcome.stats.has_value();
    Json json{{"ended_by", recordingEndName(outcome.end)},
              {"samples", state.samples},
              {"duration_s", state.durationS()},
              {"measured_rate_hz", numberOrNull(state.measuredRateHz() > 0.0, state.measuredRateHz())},
              {"lost_samples", state.lostSamples},
              {"gaps", state.gaps},
              {"saturated_samples", known ? Json(stats.saturatedSamples) : Json(nullptr)},
              {"clock_drift_ppm", numberOrNull(known, stats.clockDriftPpm)},
              {"lowest_temperature_C", numberOrNull(state.hasTemperature(), state.lowestC)},
              {"highest_temperature_C", numberOrNull(state.hasTemperature(), state.highestC)}};
    if (!outcome.status)
        json["error"] = outcome.status.error().message;
    return json;
}

} // namespace driftbench
