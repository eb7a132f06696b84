#include "widgets/tables/models_table_model.h"

#include "engine/base/axes.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

namespace driftbench {

static constexpr double kNoDecimalsFrom = 1000.0; // percent

QString trainingTimeText(double seconds)
{
    if (!std::isfinite(seconds))
        return {};
    if (seconds < 0.001)
        return ModelsTableModel::tr("< 1 ms");
    if (seconds < 1.0)
        return ModelsTableModel::tr("%1 ms").arg(numberText(1000.0 * seconds, 0));
    return ModelsTableModel::tr("%1 s").arg(numberText(seconds, seconds < 100.0 ? 1 : 0));
}

void ModelsTableModel::setData(ModelsTableData shown)
{
    const bool sameShape =
        shown.models.size() == m_data.models.size() && std::isfinite(shown.floor[0]) == hasFloor();
    if (!sameShape) {
        beginResetModel();
        m_data = std::move(shown);
        endResetModel();
        return;
    }
    m_data = std::move(shown);
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void ModelsTableModel::setLook(const Palette &look)
{
    m_look = look;
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ModelsTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_data.models.size()) + (hasFloor() ? 1 : 0);
}

int ModelsTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

double ModelsTableModel::valueOf(const ModelLine &line, int column) const
{
    if (column == Parameters)
        return line.parameters;
    if (column == Time)
        return line.timeS;
    if (column >= Excess)
        return line.excessPercent[static_cast<std::size_t>(column - Excess)];
    if (column >= Msd)
        return line.msd[static_cast<std::size_t>(column - Msd)];
    return NAN;
}

// Has a note where the others have figures.
bool ModelsTableModel::isWordy(const ModelLine &line) const
{
    return line.state != ModelLine::State::Finished && !line.note.isEmpty();
}

QString ModelsTableModel::textOf(const ModelLine &line, int column) const
{
    switch (column) {
    case Name:
        return line.label.isEmpty() ? modelLabel(line.name) : line.label;
    case Inputs:
        return line.inputs;
    case Parameters:
        return line.parameters > 0 ? numberText(line.parameters, 0) : QString();
    case Time:
        return trainingTimeText(line.timeS);
    default:
        break;
    }
    if (isWordy(line))
        return column == Msd ? line.note : QString();
    const double value = valueOf(line, column);
    if (!std::isfinite(value))
        return {};
    if (column >= Excess)
        return numberText(value, std::abs(value) < kNoDecimalsFrom ? 1 : 0);
    return numberText(value, 4);
}

QVariant ModelsTableModel::floorData(int column, int role) const
{
    const bool msd = column >= Msd && column < Excess;
    if (role == Qt::DisplayRole) {
        if (column == Name)
            return tr("Noise floor");
        if (msd)
            return numberText(m_data.floor[static_cast<std::size_t>(column - Msd)], 4);
        return column >= Excess ? QStringLiteral("0") : QString();
    }
    if (role == kExactRole && msd)
        return m_data.floor[static_cast<std::size_t>(column - Msd)];
    if (role == kExactRole && column >= Excess)
        return 0.0;
    if (role == kLineRole && column == Name)
        return rolePen(Role::Constant, m_look);
    if (role == kMutedRole)
        return true;
    return {};
}

QVariant ModelsTableModel::data(const QModelIndex &index, int role) const
{
    const int column = index.column();
    if (role == Qt::TextAlignmentRole)
        return headerData(column, Qt::Horizontal, role);
    if (static_cast<std::size_t>(index.row()) >= m_data.models.size())
        return floorData(column, role);
    const ModelLine &line = m_data.models[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return textOf(line, column);
    case Qt::ToolTipRole:
        return line.note.isEmpty() ? QVariant() : QVariant(line.note);
    case kExactRole: {
        const double value = valueOf(line, column);
        return column >= Parameters && std::isfinite(value) ? QVariant(value) : QVariant();
    }
    case kStrongRole:
        return line.recommended && (column == Name || column >= Excess);
    case kMutedRole:
        return column == Inputs || (isWordy(line) && column >= Msd) ||
               line.state == ModelLine::State::Waiting;
    case kLineRole:
        return column == Name ? QVariant(rolePen(roleOfModel(line.name), m_look)) : QVariant();
    case kProgressRole:
        return column == Time && line.state == ModelLine::State::Running ? QVariant(line.progress)
                                                                         : QVariant();
    case kSpanRole:
        return column == Msd && isWordy(line) ? 6 : 1;
    default:
        return {};
    }
}

QVariant ModelsTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section <= Inputs ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (section >= Msd) {
        const int axis = (section - Msd) % kAxisCount;
        const QString name = QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
        return section >= Excess ? tr("Excess %1\n%").arg(name) : tr("MSD %1\ndps²").arg(name);
    }
    switch (section) {
    case Name:
        return tr("Model");
    case Inputs:
        return tr("Inputs");
    case Parameters:
        return tr("Parameters");
    default:
        return tr("Time");
    }
}

} // namespace driftbench
