#include "app/session/chunk_store.h"
#include "app/session/overview_store.h"
#include "app/session/session_file_state.h"
#include "engine/recording/block_means.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

void makeRows(Recording &recording, Eigen::Index rows)
{
    recording.timeS.resize(rows);
    recording.temperatureC.resize(rows);
    recording.rateDps.resize(rows, 3);
}

// Puts chunks one behind the other into a recording that was made long enough.
class RecordingFiller
{
public:
    // means: what the samples go into, instead of the recording; may be null.
    RecordingFiller(Recording &recording, BlockMeans *means, const SampleRange &range,
                    const ReadRunOptions &options)
        : m_recording(recording), m_means(means), m_range(range), m_options(options), m_next(range.first)
    {
    }

    Flow take(const ChunkView &chunk)
    {
        const std::int64_t end = m_range.first + m_range.count;
        if (chunk.samples == 0 || chunk.samples > kChunkSamples)
            return damaged(chunk, "it says that it has " + std::to_string(chunk.samples) + " samples");
        const auto chunkEnd = chunk.firstSample + static_cast<std::int64_t>(chunk.samples);
        if (chunk.firstSample > m_next &&
            damaged(m_next, chunk.firstSample, "they are missing") == Flow::Stop)
            return Flow::Stop;
        if (chunk.firstSample < m_next && chunk.firstSample >= m_range.first)
            return damaged(chunk, "it overlaps the one before it");
        m_next = std::min(chunkEnd, end);
        const auto from =
            static_cast<Eigen::Index>(std::max<std::int64_t>(m_range.first - chunk.firstSample, 0));
        const auto count = static_cast<Eigen::Index>(m_next - chunk.firstSample) - from;
        const bool whole =
            m_means == nullptr && from == 0 && count == static_cast<Eigen::Index>(chunk.samples);
        const std::string fault =
            whole ? chunk.decode(targets(m_recording, m_filled)) : decodePart(chunk, from, count);
        if (!fault.empty())
            return damaged(chunk, fault);
        m_filled += count;
        return Flow::Continue;
    }

    // After the last chunk.
    void end()
    {
        const std::int64_t end = m_range.first + m_range.count;
        if (m_fault.empty() && m_next < end)
            damaged(m_next, end, "they are missing");
        if (m_means != nullptr)
            return;
        m_recording.timeS.conservativeResize(m_filled);
        m_recording.temperatureC.conservativeResize(m_filled);
        m_recording.rateDps.conservativeResize(m_filled, Eigen::NoChange);
    }

    const std::string &fault() const { return m_fault; }
    double fraction() const
    {
        return static_cast<double>(m_next - m_range.first) /
               static_cast<double>(std::max<std::int64_t>(m_range.count, 1));
    }

private:
    static std::array<double *, kSampleColumns> targets(Recording &recording, Eigen::Index row)
    {
        return {recording.timeS.data() + row, recording.temperatureC.data() + row,
                recording.rateDps.col(0).data() + row, recording.rateDps.col(1).data() + row,
                recording.rateDps.col(2).data() + row};
    }

    std::string decodePart(const ChunkView &chunk, Eigen::Index from, Eigen::Index count)
    {
        Recording &part = m_part;
        makeRows(part, static_cast<Eigen::Index>(chunk.samples));
        const std::string fault = chunk.decode(targets(part, 0));
        if (!fault.empty())
            return fault;
        if (m_means != nullptr) {
            m_means->add(part.timeS.data() + from, part.temperatureC.data() + from,
                         {part.rateDps.col(0).data() + from, part.rateDps.col(1).data() + from,
                          part.rateDps.col(2).data() + from},
                         count);
            return {};
        }
        m_recording.timeS.segment(m_filled, count) = part.timeS.segment(from, count);
        m_recording.temperatureC.segment(m_filled, count) = part.temperatureC.segment(from, count);
        m_recording.rateDps.middleRows(m_filled, count) = part.rateDps.middleRows(from, count);
        return {};
    }

    Flow damaged(const ChunkView &chunk, const std::string &why)
    {
        return damaged(chunk.firstSample, chunk.firstSample + static_cast<std::int64_t>(chunk.samples), why);
    }
    Flow damaged(std::int64_t first, std::int64_t end, const std::string &why)
    {
        const std::string what =
            "Samples " + std::to_string(first) + " to " + std::to_string(end - 1) + " can't be read: " + why;
        if (!m_options.skipDamaged) {
            m_fault = what;
            return Flow::Stop;
        }
        m_recording.info.warnings.push_back(what + "; they are left out.");
        return Flow::Continue;
    }

    Recording &m_recording;
    BlockMeans *m_means;
    Recording m_part; // the last chunk that was not put in place at once
    SampleRange m_range;
    ReadRunOptions m_options;
    std::int64_t m_next;       // index that the next chunk must begin with
    Eigen::Index m_filled = 0; // rows of the recording
    std::string m_fault;
};

// As many samples as the chunks of a range can give, whatever a damaged file says of them.
Result<std::int64_t> roomFor(const Database &database, RunId id, const SampleRange &range)
{
    const auto room = database.integer("SELECT sum(min(max(samples, 0), 16384)) FROM chunk WHERE run_id = ?1 "
                                       "AND first_sample > ?2 AND first_sample < ?3",
                                       id, range.first - static_cast<std::int64_t>(kChunkSamples),
                                       range.first + range.count);
    return room ? Result<std::int64_t>(*room) : room;
}

Result<std::vector<std::string>> readerWarnings(const Database &database, RunId id)
{
    Statement rows =
        database.prepare("SELECT text FROM event WHERE run_id = ?1 AND kind = 'reader' ORDER BY id");
    rows.with(id);
    std::vector<std::string> warnings;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return warnings;
        warnings.push_back(rows.text(0));
    }
}

Result<Recording> readSamples(const SessionFile &file, const RunRecord &run, const SampleRange &range,
                              const ReadRunOptions &options, const ProgressHook &hook)
{
    const Database &database = file.database();
    auto warnings = readerWarnings(database, run.id);
    if (!warnings)
        return warnings.error();
    const RunDescription &what = run.description;
    Recording recording;
    recording.info = {what.source, what.format,    what.instance,
                      what.sensor, what.simulated, std::move(*warnings)};
    const auto room = roomFor(database, run.id, range);
    if (!room)
        return room.error();
    std::optional<BlockMeans> means;
    const std::int64_t each = options.mostPoints > 0 ? samplesAPoint(*room, options.mostPoints) : 1;
    if (each > 1)
        means.emplace(each, *room);
    else
        makeRows(recording, *room);
    RecordingFiller filler(recording, means ? &*means : nullptr, range, options);
    bool cancelled = false;
    const Status read = forEachChunk(database, run.id, range.first, range.count, [&](const ChunkView &chunk) {
        cancelled = report(hook, "read", filler.fraction()) == Flow::Stop;
        return cancelled ? Flow::Stop : filler.take(chunk);
    });
    if (!read)
        return read.error();
    if (cancelled)
        return Error{Errc::Cancelled, "Reading run \"" + what.name + "\" was cancelled."};
    filler.end();
    if (!filler.fault().empty())
        return Error{Errc::SessionDamaged, database.path().string() + ", run \"" + what.name +
                                               "\": " + filler.fault() +
                                               ". \"session check\" tells what else is damaged."};
    if (means)
        return means->finish(std::move(recording.info));
    return recording;
}

} // namespace

Result<Recording> SessionFile::readRun(RunId id, const ReadRunOptions &options,
                                       const ProgressHook &hook) const
{
    const auto transaction = Transaction::beginReading(database());
    if (!transaction)
        return transaction.error();
    const auto known = run(id);
    if (!known)
        return known.error();
    return readSamples(*this, *known, {0, known->samples}, options, hook);
}

Result<Recording> SessionFile::readRange(RunId id, const SampleRange &range,
                                         const ReadRunOptions &options) const
{
    const auto transaction = Transaction::beginReading(database());
    if (!transaction)
        return transaction.error();
    const auto known = run(id);
    if (!known)
        return known.error();
    if (range.first < 0 || range.count < 0)
        return Error{Errc::InvalidOption,
                     "A range of samples begins at 0 or later and has 0 samples or more."};
    const std::int64_t first = std::min(range.first, known->samples);
    return readSamples(*this, *known, {first, std::min(range.count, known->samples - first)}, options, {});
}

Result<RunOverview> SessionFile::overview(RunId id) const
{
    const auto transaction = Transaction::beginReading(database());
    if (!transaction)
        return transaction.error();
    const auto known = run(id);
    if (!known)
        return known.error();
    return overviewOfRun(database(), *known, formatVersion() >= kOverviewsSinceVersion);
}

} // namespace driftbench
