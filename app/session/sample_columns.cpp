#include "app/session/sample_columns.h"

namespace driftbench {

template <class Rows>
void SampleColumns::appendRows(const Rows &rows, Eigen::Index first, Eigen::Index count, double laterS)
{
    const auto add = [&](std::size_t column, const double *values) {
        m_columns[column].insert(m_columns[column].end(), values + first, values + first + count);
    };
    const std::size_t before = size();
    add(0, rows.timeS.data());
    if (laterS != 0.0) {
        for (std::size_t i = before; i < size(); ++i)
            m_columns[0][i] += laterS;
    }
    add(1, rows.temperatureC.data());
    for (int axis = 0; axis < 3; ++axis)
        add(static_cast<std::size_t>(2 + axis), rows.rateDps.col(axis).data());
}

void SampleColumns::append(const SampleBlock &block, Eigen::Index count, double laterS)
{
    appendRows(block, 0, count, laterS);
}

void SampleColumns::append(const Recording &recording, Eigen::Index first, Eigen::Index count)
{
    appendRows(recording, first, count, 0.0);
}

void SampleColumns::append(const SampleColumns &other, std::size_t first, std::size_t count)
{
    for (std::size_t i = 0; i < kSampleColumns; ++i) {
        const auto rows = other.column(i, first, count);
        m_columns[i].insert(m_columns[i].end(), rows.begin(), rows.end());
    }
}

void SampleColumns::reserve(std::size_t size)
{
    for (auto &column : m_columns)
        column.reserve(size);
}

void SampleColumns::keepFirst(std::size_t count)
{
    for (auto &column : m_columns)
        column.resize(count);
}

void SampleColumns::dropFirst(std::size_t count)
{
    for (auto &column : m_columns)
        column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count));
}

} // namespace driftbench
