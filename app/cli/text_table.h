// A table in plain text: columns as wide as their widest cell, numbers to the right, words to the left.
#pragma once

#include <string>
#include <vector>

namespace driftbench::cli {

enum class Align
{
    Left,
    Right
};

class TextTable
{
public:
    void addColumn(std::string title, Align align) { m_columns.push_back({std::move(title), align, {}}); }
    void addRow(const std::vector<std::string> &cells); // one for each column

    std::string text() const; // two spaces before each line and between columns

private:
    struct Column
    {
        std::string title;
        Align align;
        std::vector<std::string> cells;
    };
    std::vector<Column> m_columns;
    std::size_t m_rows = 0;
};

// Decimals that give a column whose largest value this is so many figures, at most 12.
int decimalsFor(double largest, int figures);

} // namespace driftbench::cli
