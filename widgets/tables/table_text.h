// A table as text for other programs: what is copied from the tables of the window, and what stands in
// reports.
//
//   Text      tab between cells, one line a row: pastes into spreadsheets; numbers as they are shown
//   Csv       numbers with all their digits, independent of the locale
//   Markdown  a pipe table, numbers as they are shown
//   Latex     a tabular with booktabs rules, numbers as they are shown
#pragma once

#include <QAbstractItemModel>
#include <QList>
#include <QString>
#include <QStringList>

#include <vector>

namespace driftbench {

enum class TableFormat
{
    Text,
    Csv,
    Markdown,
    Latex
};

// What cells say beside their text.
enum TableRole
{
    kExactRole = Qt::UserRole + 1, // double: the number behind the text; CSV and sorting use it
    kStrongRole,                   // bool: semibold
    kToneRole,                     // int: Tone
    kMutedRole,                    // bool: muted text
    kIconRole,                     // QString: icon before the text
    kLineRole,                     // QPen: a piece of line before the text
    kProgressRole,                 // double 0..1: a bar in place of the text
    kSpanRole,                     // int: columns that the text of this cell runs over
};

struct TableGrid
{
    struct Cell
    {
        QString shown;
        QString exact; // for CSV
    };

    QString title;
    QStringList heads;         // one line each
    std::vector<bool> numeric; // by column: to the right
    std::vector<std::vector<Cell>> rows;
};

// All of the model, or the smallest rectangle that holds the selected cells.
TableGrid gridOf(const QAbstractItemModel &model, const QModelIndexList &selected = {});

QString tableAs(const TableGrid &grid, TableFormat format);

} // namespace driftbench
