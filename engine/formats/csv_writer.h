// Samples -> CSV: time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps, a decimal point whatever the locale,
// the file complete or not there at all (AtomicFile).
//
// Errors: OutputNotWritable, OutputFull.
#pragma once

#include "engine/base/atomic_file.h"
#include "engine/base/result.h"
#include "engine/formats/sample_block.h"
#include "engine/recording/recording.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace driftbench {

inline constexpr std::string_view kCsvHeader = "time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps";

// Places behind the point; nothing: as few digits as give the same double back.
struct CsvDecimals
{
    std::optional<int> time;
    std::optional<int> temperature;
    std::optional<int> rate;
};

void appendNumber(std::string &text, double value, std::optional<int> decimals = {});

// The block's first count rows, each with its line end.
void appendCsvRows(std::string &text, const SampleBlock &block, Eigen::Index count, CsvDecimals decimals);

class CsvWriter
{
public:
    // Writes the header; commentLines, each without its #, go before it.
    static Result<CsvWriter> create(const std::filesystem::path &path, CsvDecimals decimals = {},
                                    const std::vector<std::string> &commentLines = {});

    Status write(const SampleBlock &block, Eigen::Index count); // its first count rows
    Status write(const SampleBlock &block) { return write(block, block.size()); }
    Status write(const Recording &recording);
    Status prepare() { return m_file.prepare(); } // see AtomicFile
    Status commit() { return m_file.commit(); }

private:
    CsvWriter(AtomicFile file, CsvDecimals decimals) : m_file(std::move(file)), m_decimals(decimals) {}
    Status writeRows(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                     const Eigen::MatrixX3d &rateDps, Eigen::Index count);

    AtomicFile m_file;
    CsvDecimals m_decimals;
};

// The whole recording to one file; the sidecar (sidecar.h) is written apart.
Status writeCsv(const std::filesystem::path &path, const Recording &recording, CsvDecimals decimals = {});

} // namespace driftbench
