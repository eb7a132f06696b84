// CSV and TSV -> samples, in blocks and bounded memory. See csv_scanner.h for what a row may look like and
// for the errors; a file of which no sample can be read is TooFewSamples, or DamagedLog if damage is the
// reason.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/read_options.h"
#include "engine/formats/sample_block.h"

#include <filesystem>

namespace driftbench {

// Hands the file's samples to sink; what it says of itself comes back, with warnings. Errc::Cancelled if sink
// or hook stop.
Result<RecordingInfo> readCsvBlocks(const std::filesystem::path &path, const CsvOptions &options,
                                    const BlockSink &sink, const ProgressHook &hook = {});

} // namespace driftbench
