#include "widgets/tables/knots_table_model.h"

#include "engine/base/axes.h"
#include "widgets/style/number_text.h"

#include <cmath>

namespace driftbench {

void KnotsTableModel::setData(std::shared_ptr<const KnotsTableData> shown)
{
    beginResetModel();
    m_data = std::move(shown);
    endResetModel();
}

std::vector<int> KnotsTableModel::codeColumns()
{
    std::vector<int> columns;
    for (int axis = 0; axis < kAxisCount; ++axis)
        columns.push_back(Code + axis);
    return columns;
}

int KnotsTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_data ? 0 : static_cast<int>(m_data->table.size());
}

int KnotsTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

double KnotsTableModel::valueOf(int row, int column) const
{
    if (column == Temperature)
        return m_data->table.temperatureC(row);
    if (column >= Worst)
        return row < m_data->errors.fixedPointDps.rows() ? kMdpsPerDps * m_data->errors.worstDps(row) : NAN;
    if (column >= Code)
        return m_data->fixed.values[static_cast<std::size_t>(row)][static_cast<std::size_t>(column - Code)];
    return m_data->table.tdeDps(row, column - Value);
}

// Knots closer than a tenth of a degree need more than one decimal.
int KnotsTableModel::decimalsOf(int column) const
{
    if (column == Temperature) {
        const double step = m_data->table.stepC();
        return std::abs(step * 10.0 - std::round(step * 10.0)) < 1e-6 ? 1 : step * 100.0 >= 1.0 ? 2 : 3;
    }
    if (column >= Worst)
        return 2;
    return column >= Code ? 0 : 4;
}

QVariant KnotsTableModel::data(const QModelIndex &index, int role) const
{
    const int column = index.column();
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == kMutedRole)
        return column >= Code && column < Worst;
    if (role == kStrongRole)
        return column == Worst;
    if (role != Qt::DisplayRole && role != kExactRole)
        return {};
    const double value = valueOf(index.row(), column);
    if (role == kExactRole)
        return value;
    return std::isfinite(value) ? numberText(value, decimalsOf(column)) : QString();
}

QVariant KnotsTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (section == Temperature)
        return tr("T\n°C");
    if (section >= Worst)
        return tr("Worst\nmdps");
    const bool code = section >= Code;
    const auto axis = static_cast<std::size_t>((section - (code ? Code : Value)) % kAxisCount);
    const QString name = QString::fromUtf8(kAxisNames[axis].data());
    return code ? tr("%1\ncode").arg(name) : tr("%1\ndps").arg(name);
}

} // namespace driftbench
