// The overview of a chunk's samples: lowest, highest and mean of each kOverviewSamples of them.
#pragma once

#include "app/session/chunk_store.h"
#include "app/session/session_records.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace driftbench {

// Of columns as SampleColumns has them, all of one length.
RunOverview overviewOf(const std::array<std::span<const double>, kSampleColumns> &columns);

// Of a chunk that is read; the error is what is wrong with it, without a full stop.
std::string overviewOf(const ChunkView &chunk, RunOverview &overview);

RunOverview overviewWithRows(Eigen::Index rows); // not filled
RunOverview joinedOverviews(const std::vector<RunOverview> &parts);

} // namespace driftbench
