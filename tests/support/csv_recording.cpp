#include "support/csv_recording.h"

#include "engine/base/text.h"

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace driftbench::test {

Recording readPlainCsv(const std::filesystem::path &path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line); // header
    std::vector<std::array<double, 5>> rows;
    while (std::getline(file, line)) {
        std::array<double, 5> row{};
        std::istringstream fields(line);
        std::string field;
        for (double &value : row) {
            std::getline(fields, field, ',');
            value = parseNumber(field).value_or(0.0);
        }
        rows.push_back(row);
    }
    const auto size = static_cast<Eigen::Index>(rows.size());
    Recording recording;
    recording.timeS.resize(size);
    recording.temperatureC.resize(size);
    recording.rateDps.resize(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto &row = rows[static_cast<std::size_t>(i)];
        recording.timeS[i] = row[0];
        recording.temperatureC[i] = row[1];
        recording.rateDps.row(i) << row[2], row[3], row[4];
    }
    recording.info.source = path.filename().string();
    recording.info.format = "csv";
    return recording;
}

} // namespace driftbench::test
