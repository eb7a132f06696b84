// A log with its compensated rates: comp = measured - TDE(T), three more columns comp_x_dps, comp_y_dps and
// comp_z_dps. Streams: memory does not depend on the length of the log.
//
// A CSV keeps everything it has, byte for byte: comments, header, columns, text, separator and line ends;
// rows that hold no sample get no new columns. Other formats are written as the default columns plus the
// three.
//
// Errors: those of reading and of writing; InvalidOption if the columns are there already.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/formats/read_options.h"
#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>

namespace driftbench {

// N temperatures in degrees Celsius -> TDE, N x 3, dps. A temperature may be NaN.
using TdeOfTemperature = std::function<Eigen::MatrixX3d(const Eigen::VectorXd &)>;

struct CompensatedCsv
{
    RecordingInfo info; // of the log that was read
    std::int64_t samples = 0;
};

Result<CompensatedCsv> writeCompensatedCsv(const std::filesystem::path &in, const std::filesystem::path &out,
                                           const ReadOptions &options, const TdeOfTemperature &tde,
                                           const ProgressHook &hook = {});

} // namespace driftbench
