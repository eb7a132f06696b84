// Samples as five columns that grow at their end: time in seconds, temperature in degrees Celsius, rates
// x, y, z in dps.
#pragma once

#include "engine/recording/recording.h"
#include "engine/recording/sample_block.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace driftbench {

inline constexpr std::size_t kSampleColumns = 5;
inline constexpr std::size_t kSampleBytes = kSampleColumns * sizeof(double);

class SampleColumns
{
public:
    std::size_t size() const { return m_columns[0].size(); }
    bool empty() const { return size() == 0; }

    std::span<const double> column(std::size_t index) const { return m_columns[index]; }
    std::span<const double> column(std::size_t index, std::size_t first, std::size_t count) const
    {
        return column(index).subspan(first, count);
    }

    void append(const SampleBlock &block, Eigen::Index count, double laterS);
    void append(const Recording &recording, Eigen::Index first, Eigen::Index count);
    void append(const SampleColumns &other, std::size_t first, std::size_t count);
    void keepFirst(std::size_t count);
    void dropFirst(std::size_t count);
    void reserve(std::size_t size);

private:
    template <class Rows>
    void appendRows(const Rows &rows, Eigen::Index first, Eigen::Index count, double laterS);

    std::array<std::vector<double>, kSampleColumns> m_columns;
};

} // namespace driftbench
