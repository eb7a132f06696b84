#include "app/cli/text_table.h"

#include "app/cli/text_layout.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace driftbench::cli {

namespace {

std::string inColumn(const std::string &text, std::size_t width, Align align)
{
    return "  " + (align == Align::Left ? left(text, width) : right(text, width));
}

std::string endTrimmed(std::string line)
{
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

} // namespace

void TextTable::addRow(const std::vector<std::string> &cells)
{
    assert(cells.size() == m_columns.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        m_columns[i].cells.push_back(cells[i]);
    ++m_rows;
}

std::string TextTable::text() const
{
    std::vector<std::string> lines(m_rows + 1);
    for (const Column &column : m_columns) {
        std::size_t width = widthOf(column.title);
        for (const std::string &cell : column.cells)
            width = std::max(width, widthOf(cell));
        lines[0] += inColumn(column.title, width, column.align);
        for (std::size_t row = 0; row < m_rows; ++row)
            lines[row + 1] += inColumn(column.cells[row], width, column.align);
    }
    std::string text;
    for (std::string &line : lines)
        text += endTrimmed(std::move(line));
    return text;
}

int decimalsFor(double largest, int figures)
{
    if (!(std::abs(largest) > 0.0) || !std::isfinite(largest))
        return 0;
    return std::clamp(figures - 1 - static_cast<int>(std::floor(std::log10(std::abs(largest)))), 0, 12);
}

} // namespace driftbench::cli
