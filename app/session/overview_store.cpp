#include "app/session/overview_store.h"

#include "app/session/chunk_overview.h"
#include "engine/base/checksum.h"

#include <bit>
#include <cstring>

namespace driftbench {

namespace {

static_assert(std::endian::native == std::endian::little, "overviews are written as they are in memory");

struct PackedRow
{
    double startS = 0.0;
    double endS = 0.0;
    std::array<float, kOverviewColumns> lowest{};
    std::array<float, kOverviewColumns> highest{};
    std::array<float, kOverviewColumns> mean{};
};
static_assert(sizeof(PackedRow) == 64);

struct ChunkPlace
{
    std::int64_t id = 0;
    RunId run = 0;
    std::int64_t firstSample = 0;
};

struct Computed
{
    RunOverview overview;
    std::int64_t samples = 0;
    std::string fault =
        "it is not there"; // what is wrong with the chunk, without a full stop; empty: nothing
};

Result<Computed> computedOverview(const Database &database, RunId run, std::int64_t firstSample)
{
    Computed computed;
    const Status read = forEachChunk(database, run, firstSample, 1, [&](const ChunkView &chunk) {
        if (chunk.firstSample != firstSample)
            return Flow::Continue;
        computed.samples = static_cast<std::int64_t>(chunk.samples);
        computed.fault = overviewOf(chunk, computed.overview);
        return Flow::Stop;
    });
    if (!read)
        return read.error();
    return computed;
}

std::optional<RunOverview> overviewIn(const Statement &row)
{
    const std::string_view bytes = row.bytes(3);
    if (row.isNull(3) || crc32(bytes) != static_cast<std::uint32_t>(row.integer(2)))
        return std::nullopt;
    return unpackedOverview(bytes, row.integer(1));
}

Result<std::vector<ChunkPlace>> placesOfAllChunks(const Database &database)
{
    Statement rows =
        database.prepare("SELECT id, run_id, first_sample FROM chunk ORDER BY run_id, first_sample");
    std::vector<ChunkPlace> places;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return places;
        places.push_back({rows.integer(0), rows.integer(1), rows.integer(2)});
    }
}

} // namespace

std::string packedOverview(const RunOverview &overview)
{
    std::string bytes(static_cast<std::size_t>(overview.size()) * sizeof(PackedRow), '\0');
    char *out = bytes.data();
    for (Eigen::Index row = 0; row < overview.size(); ++row, out += sizeof(PackedRow)) {
        PackedRow packed{overview.startS[row], overview.endS[row], {}, {}, {}};
        for (int column = 0; column < kOverviewColumns; ++column) {
            const auto at = static_cast<std::size_t>(column);
            packed.lowest[at] = overview.lowest(row, column);
            packed.highest[at] = overview.highest(row, column);
            packed.mean[at] = overview.mean(row, column);
        }
        std::memcpy(out, &packed, sizeof packed);
    }
    return bytes;
}

std::optional<RunOverview> unpackedOverview(std::string_view bytes, std::int64_t samples)
{
    if (samples < 1 || samples > static_cast<std::int64_t>(kChunkSamples))
        return std::nullopt;
    const Eigen::Index rows = (samples + kOverviewSamples - 1) / kOverviewSamples;
    if (bytes.size() != static_cast<std::size_t>(rows) * sizeof(PackedRow))
        return std::nullopt;
    RunOverview overview = overviewWithRows(rows);
    const char *in = bytes.data();
    for (Eigen::Index row = 0; row < rows; ++row, in += sizeof(PackedRow)) {
        PackedRow packed;
        std::memcpy(&packed, in, sizeof packed);
        overview.startS[row] = packed.startS;
        overview.endS[row] = packed.endS;
        for (int column = 0; column < kOverviewColumns; ++column) {
            const auto at = static_cast<std::size_t>(column);
            overview.lowest(row, column) = packed.lowest[at];
            overview.highest(row, column) = packed.highest[at];
            overview.mean(row, column) = packed.mean[at];
        }
    }
    return overview;
}

Status insertOverview(const Database &database, std::int64_t chunk, std::int64_t samples,
                      const RunOverview &overview)
{
    const std::string bytes = packedOverview(overview);
    return database.run("INSERT INTO overview(chunk_id, samples, crc32, figures) VALUES(?1, ?2, ?3, ?4)",
                        chunk, samples, crc32(bytes), Bytes{bytes});
}

Status insertAllOverviews(const Database &database)
{
    const auto places = placesOfAllChunks(database);
    if (!places)
        return places.error();
    for (const ChunkPlace &place : *places) {
        const auto computed = computedOverview(database, place.run, place.firstSample);
        if (!computed && computed.error().code != Errc::SessionDamaged)
            return computed.error();
        if (!computed || !computed->fault.empty())
            continue;
        if (Status inserted = insertOverview(database, place.id, computed->samples, computed->overview);
            !inserted)
            return inserted;
    }
    return {};
}

Result<std::optional<std::string>> storedOverview(const Database &database, RunId run,
                                                  std::int64_t firstSample)
{
    Statement row = database.prepare("SELECT NULL, samples, crc32, figures FROM overview WHERE chunk_id ="
                                     " (SELECT id FROM chunk WHERE run_id = ?1 AND first_sample = ?2)");
    const auto there = row.with(run, firstSample).step();
    if (!there)
        return there.error();
    if (!*there)
        return std::optional<std::string>();
    return std::optional(overviewIn(row) ? std::string(row.bytes(3)) : std::string());
}

Result<RunOverview> overviewOfRun(const Database &database, const RunRecord &run, bool stored)
{
    // The index of the chunks is all of them that this touches: their pages hold samples.
    Statement rows = database.prepare(
        stored ? "SELECT chunk.first_sample, overview.samples, overview.crc32, overview.figures FROM chunk"
                 " LEFT JOIN overview ON overview.chunk_id = chunk.id WHERE chunk.run_id = ?1"
                 " ORDER BY chunk.first_sample"
               : "SELECT first_sample, NULL, NULL, NULL FROM chunk WHERE run_id = ?1 ORDER BY first_sample");
    rows.with(run.id);
    std::vector<RunOverview> parts;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return joinedOverviews(parts);
        if (auto there = overviewIn(rows)) {
            parts.push_back(std::move(*there));
            continue;
        }
        auto computed = computedOverview(database, run.id, rows.integer(0));
        if (!computed)
            return computed.error();
        if (!computed->fault.empty())
            return Error{Errc::SessionDamaged, database.path().string() + ", run \"" + run.description.name +
                                                   "\": a chunk can't be read: " + computed->fault + "."};
        parts.push_back(std::move(computed->overview));
    }
}

} // namespace driftbench
