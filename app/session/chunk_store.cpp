#include "app/session/chunk_store.h"

#include "app/session/chunk_overview.h"
#include "app/session/column_codec.h"
#include "app/session/overview_store.h"
#include "engine/base/checksum.h"

#include <algorithm>

namespace driftbench {

Status ChunkWriter::insert(std::size_t first, std::size_t count)
{
    std::array<std::span<const double>, kSampleColumns> values;
    std::array<std::string, kSampleColumns> columns;
    std::uint32_t crc = 0;
    for (std::size_t i = 0; i < kSampleColumns; ++i) {
        values[i] = m_tail.column(i, first, count);
        columns[i] = encodeColumn(values[i]);
        crc = crc32(columns[i], crc);
    }
    const auto samples = static_cast<std::int64_t>(count);
    if (Status inserted = m_database->run(
            "INSERT INTO chunk(run_id, first_sample, samples, first_time_s, last_time_s, crc32,"
            " time, temperature, rate_x, rate_y, rate_z) VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, "
            "?11)",
            m_run, m_firstOfTail + static_cast<std::int64_t>(first), samples, values[0].front(),
            values[0].back(), crc, Bytes{columns[0]}, Bytes{columns[1]}, Bytes{columns[2]}, Bytes{columns[3]},
            Bytes{columns[4]});
        !inserted)
        return inserted;
    return insertOverview(*m_database, m_database->lastInsertId(), samples, overviewOf(values));
}

Status ChunkWriter::removePieces(std::size_t from)
{
    return m_database->run("DELETE FROM chunk WHERE run_id = ?1 AND first_sample >= ?2", m_run,
                           m_firstOfTail + static_cast<std::int64_t>(from));
}

Status ChunkWriter::append(const SampleColumns &rows, std::size_t first, std::size_t count)
{
    m_tail.append(rows, first, count);
    std::size_t written = std::max(m_tailWritten, m_nextFull);
    if (m_tail.size() - m_nextFull >= kChunkSamples && written > m_nextFull) {
        if (Status removed = removePieces(m_nextFull); !removed)
            return removed;
        written = m_nextFull;
        m_nextPieces = 0;
    }
    for (; m_tail.size() - m_nextFull >= kChunkSamples; m_nextFull += kChunkSamples, written = m_nextFull) {
        if (Status inserted = insert(m_nextFull, kChunkSamples); !inserted)
            return inserted;
    }
    if (written == m_tail.size())
        return {};
    if (m_nextPieces + 1 >= kMostPieces) {
        if (Status removed = removePieces(m_nextFull); !removed)
            return removed;
        written = m_nextFull;
        m_nextPieces = 0;
    }
    ++m_nextPieces;
    return insert(written, m_tail.size() - written);
}

Status ChunkWriter::joinPieces()
{
    if (m_pieces < 2)
        return {};
    if (Status removed = removePieces(0); !removed)
        return removed;
    m_nextPieces = 1;
    return insert(0, m_tail.size());
}

void ChunkWriter::committed()
{
    m_tail.dropFirst(m_nextFull);
    m_firstOfTail += static_cast<std::int64_t>(m_nextFull);
    m_tailWritten = m_tail.size();
    m_pieces = m_nextPieces;
    m_nextFull = 0;
}

void ChunkWriter::rolledBack()
{
    m_tail.keepFirst(m_tailWritten);
    m_nextFull = 0;
    m_nextPieces = m_pieces;
}

std::string ChunkView::decode(const std::array<double *, kSampleColumns> &targets) const
{
    std::uint32_t computed = 0;
    for (const std::string_view column : columns)
        computed = crc32(column, computed);
    if (computed != crc)
        return "its checksum does not fit";
    for (std::size_t i = 0; i < kSampleColumns; ++i) {
        if (!decodeColumn(columns[i], {targets[i], samples}))
            return "column " + std::to_string(i + 1) + " can't be decoded";
    }
    return {};
}

Status forEachChunk(const Database &database, RunId run, std::int64_t firstSample, std::int64_t count,
                    const std::function<Flow(const ChunkView &)> &use)
{
    // No chunk is longer, so one that reaches into the range begins behind this.
    const std::int64_t from = firstSample - static_cast<std::int64_t>(kChunkSamples);
    Statement statement = database.prepare(
        "SELECT first_sample, samples, crc32, time, temperature, rate_x, rate_y, rate_z FROM chunk"
        " WHERE run_id = ?1 AND first_sample > ?2 AND first_sample < ?3 AND first_sample + samples > ?4"
        " ORDER BY first_sample");
    statement.with(run, from, firstSample + count, firstSample);
    for (;;) {
        const auto row = statement.step();
        if (!row)
            return row.error();
        if (!*row)
            return {};
        ChunkView chunk{statement.integer(0),
                        static_cast<std::size_t>(statement.integer(1)),
                        static_cast<std::uint32_t>(statement.integer(2)),
                        {}};
        for (std::size_t i = 0; i < kSampleColumns; ++i)
            chunk.columns[i] = statement.bytes(static_cast<int>(3 + i));
        if (use(chunk) == Flow::Stop)
            return {};
    }
}

Result<std::int64_t> samplesOfRun(const Database &database, RunId run)
{
    return database.integer("SELECT first_sample + samples FROM chunk WHERE run_id = ?1"
                            " ORDER BY first_sample DESC LIMIT 1",
                            run);
}

} // namespace driftbench
