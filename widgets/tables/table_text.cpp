#include "widgets/tables/table_text.h"

#include "widgets/style/number_text.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static QString oneLine(QString text)
{
    return text.replace(QLatin1Char('\n'), QLatin1Char(' ')).trimmed();
}

static TableGrid::Cell cellOf(const QModelIndex &index)
{
    TableGrid::Cell cell;
    cell.shown = oneLine(index.data(Qt::DisplayRole).toString());
    const QVariant exact = index.data(kExactRole);
    if (!exact.isValid())
        cell.exact = cell.shown;
    else if (std::isfinite(exact.toDouble()))
        cell.exact = QString::fromStdString(shortest(exact.toDouble()));
    return cell;
}

TableGrid gridOf(const QAbstractItemModel &model, const QModelIndexList &selected)
{
    int firstRow = 0, lastRow = model.rowCount() - 1;
    int firstColumn = 0, lastColumn = model.columnCount() - 1;
    if (!selected.isEmpty()) {
        firstRow = lastRow = selected.front().row();
        firstColumn = lastColumn = selected.front().column();
        for (const QModelIndex &index : selected) {
            firstRow = std::min(firstRow, index.row());
            lastRow = std::max(lastRow, index.row());
            firstColumn = std::min(firstColumn, index.column());
            lastColumn = std::max(lastColumn, index.column());
        }
    }
    TableGrid grid;
    for (int column = firstColumn; column <= lastColumn; ++column) {
        grid.heads.append(oneLine(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()));
        const int alignment = model.headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt();
        grid.numeric.push_back((alignment & Qt::AlignRight) != 0);
    }
    for (int row = firstRow; row <= lastRow; ++row) {
        std::vector<TableGrid::Cell> cells;
        for (int column = firstColumn; column <= lastColumn; ++column)
            cells.push_back(cellOf(model.index(row, column)));
        grid.rows.push_back(std::move(cells));
    }
    return grid;
}

static QString asText(const TableGrid &grid)
{
    QString text = grid.heads.join(QLatin1Char('\t')) + QLatin1Char('\n');
    for (const auto &row : grid.rows) {
        QStringList cells;
        for (const TableGrid::Cell &cell : row)
            cells.append(cell.shown);
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return text;
}

static QString csvCell(QString text)
{
    if (!text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"')))
        return text;
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

static QString asCsv(const TableGrid &grid)
{
    QStringList heads;
    for (const QString &head : grid.heads)
        heads.append(csvCell(head));
    QString text = heads.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (const auto &row : grid.rows) {
        QStringList cells;
        for (const TableGrid::Cell &cell : row)
            cells.append(csvCell(cell.exact));
        text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

static QString markdownRow(const QStringList &cells)
{
    QStringList escaped;
    for (QString cell : cells)
        escaped.append(cell.replace(QLatin1Char('|'), QStringLiteral("\\|")));
    return QStringLiteral("| ") + escaped.join(QStringLiteral(" | ")) + QStringLiteral(" |\n");
}

static QString asMarkdown(const TableGrid &grid)
{
    QString text = markdownRow(grid.heads);
    QStringList rule;
    for (const bool numeric : grid.numeric)
        rule.append(numeric ? QStringLiteral("---:") : QStringLiteral(":---"));
    text += markdownRow(rule);
    for (const auto &row : grid.rows) {
        QStringList cells;
        for (const TableGrid::Cell &cell : row)
            cells.append(cell.shown);
        text += markdownRow(cells);
    }
    return text;
}

// Letters that LaTeX takes for commands, and those that its fonts may lack.
static QString latexCell(const QString &text)
{
    QString escaped;
    for (const QChar letter : text) {
        if (QStringLiteral("&%$#_{}").contains(letter))
            escaped += QLatin1Char('\\') + QString(letter);
        else if (letter == QLatin1Char('\\'))
            escaped += QStringLiteral("\\textbackslash{}");
        else if (letter == kMinus)
            escaped += QStringLiteral("$-$");
        else if (letter == kThinSpace)
            escaped += QStringLiteral("\\,");
        else if (letter == QChar(0x00B2))
            escaped += QStringLiteral("$^2$");
        else if (letter == QChar(0x00B0))
            escaped += QStringLiteral("$^\\circ$");
        else if (letter == QChar(0x00B1))
            escaped += QStringLiteral("$\\pm$");
        else if (letter == QChar(0x0394))
            escaped += QStringLiteral("$\\Delta$");
        else if (letter == QChar(0x221A))
            escaped += QStringLiteral("$\\surd$");
        else
            escaped += letter;
    }
    return escaped;
}

static QString asLatex(const TableGrid &grid)
{
    QString columns;
    for (const bool numeric : grid.numeric)
        columns += numeric ? QLatin1Char('r') : QLatin1Char('l');
    QStringList heads;
    for (const QString &head : grid.heads)
        heads.append(latexCell(head));
    const QString rowEnd = QStringLiteral(" \\\\\n");
    QString text = QStringLiteral("\\begin{tabular}{%1}\n\\toprule\n").arg(columns) +
                   heads.join(QStringLiteral(" & ")) + rowEnd + QStringLiteral("\\midrule\n");
    for (const auto &row : grid.rows) {
        QStringList cells;
        for (const TableGrid::Cell &cell : row)
            cells.append(latexCell(cell.shown));
        text += cells.join(QStringLiteral(" & ")) + rowEnd;
    }
    return text + QStringLiteral("\\bottomrule\n\\end{tabular}\n");
}

QString tableAs(const TableGrid &grid, TableFormat format)
{
    switch (format) {
    case TableFormat::Text:
        return asText(grid);
    case TableFormat::Csv:
        return asCsv(grid);
    case TableFormat::Markdown:
        return asMarkdown(grid);
    case TableFormat::Latex:
        return asLatex(grid);
    }
    return {};
}

} // namespace driftbench
