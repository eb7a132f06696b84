#include "app/session/chunk_overview.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

namespace {

struct Figures
{
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    int count = 0;
};

Figures figuresOf(std::span<const double> values)
{
    Figures figures;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        figures.lowest = std::min(figures.lowest, value);
        figures.highest = std::max(figures.highest, value);
        figures.sum += value;
        ++figures.count;
    }
    return figures;
}

} // namespace

RunOverview overviewWithRows(Eigen::Index rows)
{
    return {Eigen::VectorXd(rows), Eigen::VectorXd(rows), RunOverview::Table(rows, kOverviewColumns),
            RunOverview::Table(rows, kOverviewColumns), RunOverview::Table(rows, kOverviewColumns)};
}

RunOverview overviewOf(const std::array<std::span<const double>, kSampleColumns> &columns)
{
    const std::size_t size = columns[0].size();
    const auto rows = static_cast<Eigen::Index>((size + kOverviewSamples - 1) / kOverviewSamples);
    RunOverview overview = overviewWithRows(rows);
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    for (Eigen::Index row = 0; row < rows; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * kOverviewSamples;
        const std::size_t count = std::min<std::size_t>(kOverviewSamples, size - first);
        overview.startS[row] = columns[0][first];
        overview.endS[row] = columns[0][first + count - 1];
        for (int column = 0; column < kOverviewColumns; ++column) {
            const Figures figures =
                figuresOf(columns[static_cast<std::size_t>(column + 1)].subspan(first, count));
            const bool any = figures.count > 0;
            overview.lowest(row, column) = any ? static_cast<float>(figures.lowest) : nothing;
            overview.highest(row, column) = any ? static_cast<float>(figures.highest) : nothing;
            overview.mean(row, column) = any ? static_cast<float>(figures.sum / figures.count) : nothing;
        }
    }
    return overview;
}

std::string overviewOf(const ChunkView &chunk, RunOverview &overview)
{
    if (chunk.samples == 0 || chunk.samples > kChunkSamples)
        return "it says that it has " + std::to_string(chunk.samples) + " samples";
    std::array<std::vector<double>, kSampleColumns> values;
    std::array<double *, kSampleColumns> targets{};
    std::array<std::span<const double>, kSampleColumns> columns;
    for (std::size_t i = 0; i < kSampleColumns; ++i) {
        values[i].resize(chunk.samples);
        targets[i] = values[i].data();
        columns[i] = values[i];
    }
    std::string fault = chunk.decode(targets);
    if (fault.empty())
        overview = overviewOf(columns);
    return fault;
}

RunOverview joinedOverviews(const std::vector<RunOverview> &parts)
{
    Eigen::Index rows = 0;
    for (const RunOverview &part : parts)
        rows += part.size();
    RunOverview whole = overviewWithRows(rows);
    Eigen::Index row = 0;
    for (const RunOverview &part : parts) {
        whole.startS.segment(row, part.size()) = part.startS;
        whole.endS.segment(row, part.size()) = part.endS;
        whole.lowest.middleRows(row, part.size()) = part.lowest;
        whole.highest.middleRows(row, part.size()) = part.highest;
        whole.mean.middleRows(row, part.size()) = part.mean;
        row += part.size();
    }
    return whole;
}

} // namespace driftbench
