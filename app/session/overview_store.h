// The overview of each chunk as a row of the table overview, so that the overview of a run is read without
// its samples. Written in the transaction that writes the chunk, gone with it. docs/session-format.md has the
// bytes.
#pragma once

#include "app/session/database.h"
#include "app/session/session_records.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace driftbench {

inline constexpr int kOverviewsSinceVersion = 2; // of the file

std::string packedOverview(const RunOverview &overview);
// Nothing if the bytes are not the overview of so many samples, or too many for a chunk.
std::optional<RunOverview> unpackedOverview(std::string_view bytes, std::int64_t samples);

// In a transaction of the caller's. chunk: its id.
Status insertOverview(const Database &database, std::int64_t chunk, std::int64_t samples,
                      const RunOverview &overview);

// For all chunks of a file that has none, in a transaction of the caller's. A chunk that can't be read goes
// without.
Status insertAllOverviews(const Database &database);

// The stored bytes, empty if they are damaged; nothing: the chunk has no overview.
Result<std::optional<std::string>> storedOverview(const Database &database, RunId run,
                                                  std::int64_t firstSample);

// Of a whole run. What is not stored, or damaged there, is made from the samples; SessionDamaged if those
// can't be read either. stored: whether the file has the table.
Result<RunOverview> overviewOfRun(const Database &database, const RunRecord &run, bool stored);

} // namespace driftbench
