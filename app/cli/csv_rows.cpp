#include "app/cli/csv_rows.h"

#include <charconv>

namespace driftbench::cli {

namespace {

// The longest double in shortest form is "-2.2250738585072014e-308".
constexpr std::size_t kLongestNumber = 24;
constexpr std::size_t kLongestRow = 5 * (kLongestNumber + 1);

char *formatNumber(double value, char end, char *to)
{
    to = std::to_chars(to, to + kLongestNumber, value).ptr;
    *to++ = end;
    return to;
}

} // namespace

void formatCsvRows(const SampleBlock &block, Eigen::Index count, std::string &text)
{
    text.resize(static_cast<std::size_t>(count) * kLongestRow);
    char *to = text.data();
    for (Eigen::Index row = 0; row < count; ++row) {
        to = formatNumber(block.timeS[row], ',', to);
        to = formatNumber(block.temperatureC[row], ',', to);
        to = formatNumber(block.rateDps(row, 0), ',', to);
        to = formatNumber(block.rateDps(row, 1), ',', to);
        to = formatNumber(block.rateDps(row, 2), '\n', to);
    }
    text.resize(static_cast<std::size_t>(to - text.data()));
}

} // namespace driftbench::cli
