// The samples of a run as rows of the table chunk.
//
// A chunk holds up to kChunkSamples samples. What is committed every fraction of a second is a small piece at
// the end of the run; kMostPieces of them, or as many as fill a chunk, are replaced by one in the same
// transaction that brings the next. So a slow sensor's run is not thousands of crumbs, and a reader never
// sees a sample twice or half a chunk.
#pragma once

#include "app/session/database.h"
#include "app/session/sample_columns.h"
#include "app/session/session_records.h"

#include <cstdint>
#include <functional>

namespace driftbench {

inline constexpr std::size_t kChunkSamples = 16384;
inline constexpr int kMostPieces = 32;

class ChunkWriter
{
public:
    // Behind the samples that the run has.
    ChunkWriter(const Database &database, RunId run, std::int64_t firstSample)
        : m_database(&database), m_run(run), m_firstOfTail(firstSample)
    {
    }

    // In a transaction of the caller's, who then says how it ended.
    Status append(const SampleColumns &rows, std::size_t first, std::size_t count);
    Status joinPieces(); // at the end of a run
    void committed();
    void rolledBack();

    std::int64_t samples() const
    {
        return m_firstOfTail + static_cast<std::int64_t>(m_tailWritten);
    } // committed

private:
    Status insert(std::size_t first, std::size_t count);
    Status removePieces(std::size_t from);

    const Database *m_database;
    RunId m_run;
    SampleColumns m_tail;       // the samples behind the last full chunk, written or not
    std::int64_t m_firstOfTail; // index of the first of them in the run
    std::size_t m_tailWritten = 0;
    int m_pieces = 0;
    // What becomes of it when the transaction is committed.
    std::size_t m_nextFull = 0; // samples at the front of m_tail that are then in full chunks
    int m_nextPieces = 0;
};

// One chunk as it is read.
struct ChunkView
{
    std::int64_t firstSample = 0;
    std::size_t samples = 0;
    std::uint32_t crc = 0;
    std::array<std::string_view, kSampleColumns> columns;

    // "" or what is wrong with it, without a full stop. Each target has `samples` values.
    std::string decode(const std::array<double *, kSampleColumns> &targets) const;
};

// The chunks of a run that touch the range, in their order; a Stop ends it. Errors as of Database.
Status forEachChunk(const Database &database, RunId run, std::int64_t firstSample, std::int64_t count,
                    const std::function<Flow(const ChunkView &)> &use);

// Index behind the last sample of the run.
Result<std::int64_t> samplesOfRun(const Database &database, RunId run);

} // namespace driftbench
