// The five columns of a plain log (time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps; one header line) as
// a run's features, read by a few lines of the tests' own: tests of judging do not depend on the readers.
#pragma once

#include "engine/base/text.h"
#include "engine/features/run_features.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace driftbench::test {

// skip: data rows left out at the start. Reference rate zero.
inline std::shared_ptr<const RunFeatures> readPlainCsv(const std::filesystem::path &file,
                                                       const std::string &name, std::size_t skip,
                                                       double referenceTemperatureC)
{
    std::ifstream in(file);
    std::string line;
    std::vector<std::array<double, 5>> rows;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::array<double, 5> row{};
        std::size_t start = 0;
        for (double &value : row) {
            const std::size_t comma = std::min(line.find(',', start), line.size());
            value = parseNumber(std::string_view(line).substr(start, comma - start)).value();
            start = comma + 1;
        }
        rows.push_back(row);
    }
    auto run = std::make_shared<RunFeatures>();
    run->name = name;
    const auto count = static_cast<Eigen::Index>(rows.size() - skip);
    run->timeS.resize(count);
    run->deltaT.resize(count);
    run->tdeDps.resize(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto &row = rows[static_cast<std::size_t>(i) + skip];
        run->timeS[i] = row[0];
        run->deltaT[i] = row[1] - referenceTemperatureC;
        run->tdeDps.row(i) << row[2], row[3], row[4];
    }
    run->usableForTraining.assign(static_cast<std::size_t>(count), 1);
    run->curve.add(run->deltaT, run->tdeDps);
    return run;
}

} // namespace driftbench::test
