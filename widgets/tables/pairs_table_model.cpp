#include "widgets/tables/pairs_table_model.h"

namespace driftbench {

void PairsTableModel::setHeads(const QString &here, const QString &there)
{
    m_here = here;
    m_there = there;
    emit headerDataChanged(Qt::Horizontal, 1, 2);
}

void PairsTableModel::setPairs(std::vector<FactPair> pairs)
{
    beginResetModel();
    m_pairs = std::move(pairs);
    endResetModel();
}

int PairsTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_pairs.size());
}

int PairsTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : 3;
}

QVariant PairsTableModel::data(const QModelIndex &index, int role) const
{
    const FactPair &pair = m_pairs[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return column == 0 ? pair.name : column == 1 ? pair.here : pair.there;
    case Qt::TextAlignmentRole:
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    case kMutedRole:
        return column == 0;
    case kStrongRole:
        return column == 2 && pair.here != pair.there;
    default:
        return {};
    }
}

QVariant PairsTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role == Qt::DisplayRole)
        return section == 1 ? m_here : section == 2 ? m_there : QString();
    return {};
}

} // namespace driftbench
