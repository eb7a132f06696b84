#include "widgets/tables/comparison_table_model.h"

#include "engine/base/axes.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/number_text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kPercent = 100.0;

// NaN where the model was not compared.
static double msdOf(const std::vector<ComparisonRow> &rows, const PaperRow &of, std::string_view model)
{
    for (const ComparisonRow &row : rows) {
        if (row.run == of.run && row.axis == of.axis && row.model == model)
            return row.msdAfter;
    }
    return NAN;
}

static double floorOf(const std::vector<ComparisonRow> &rows, const PaperRow &of)
{
    for (const ComparisonRow &row : rows) {
        if (row.run == of.run && row.axis == of.axis)
            return row.noiseFloor;
    }
    return NAN;
}

void ComparisonTableModel::setData(ComparisonTableData shown)
{
    beginResetModel();
    m_data = std::move(shown);
    m_rows.clear();
    PaperModels roles;
    roles.novel = m_data.novel;
    for (PaperRow &paper : paperImprovements(m_data.rows, roles)) {
        if (m_data.run && paper.run != *m_data.run)
            continue;
        Row row{paper,
                msdOf(m_data.rows, paper, "cubic"),
                msdOf(m_data.rows, paper, "constant"),
                floorOf(m_data.rows, paper),
                std::sqrt(paper.msd6),
                std::nullopt};
        if (m_data.limitDps && std::isfinite(row.left))
            row.passes = row.left <= *m_data.limitDps;
        m_rows.push_back(std::move(row));
    }
    endResetModel();
}

int ComparisonTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ComparisonTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : leadingColumns() + kFigures;
}

double ComparisonTableModel::valueOf(const Row &row, int figure) const
{
    const PaperRow &paper = row.paper;
    switch (figure) {
    case Msd1:
        return paper.msd1;
    case Msd4:
        return paper.msd4;
    case Msd5:
        return paper.msd5;
    case Msd6:
        return paper.msd6;
    case Q3:
        return paper.q3;
    case Q4:
        return paper.q4;
    case Q5:
        return paper.q5;
    // The engine counts improvements positive; differences of Q have the other sign.
    case Q4AgainstQ3:
        return -kPercent * paper.q4AgainstQ3;
    case Q5AgainstQ3:
        return -kPercent * paper.q5AgainstQ3;
    case Q5AgainstQ4:
        return -kPercent * paper.q5AgainstQ4;
    case Cubic:
        return row.cubic;
    case Constant:
        return row.constant;
    case Floor:
        return row.floor;
    case Left:
        return row.left;
    default:
        return row.passes ? (*row.passes ? 1.0 : 0.0) : NAN;
    }
}

// Of the column: four, more for a floor that four would not show with two figures.
int ComparisonTableModel::decimalsOf(int figure) const
{
    if (figure == Left)
        return 3;
    if (figure >= Q4AgainstQ3 && figure <= Q5AgainstQ4)
        return 0;
    if (figure != Floor)
        return 4;
    double smallest = 1.0;
    for (const Row &row : m_rows) {
        if (std::isfinite(row.floor) && row.floor > 0.0)
            smallest = std::min(smallest, row.floor);
    }
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(smallest))), 4, 8);
}

QString ComparisonTableModel::textOf(const Row &row, int figure) const
{
    if (figure == Limit)
        return row.passes ? (*row.passes ? tr("Pass") : tr("Fail")) : QString();
    const double value = valueOf(row, figure);
    const QString text = numberText(value, decimalsOf(figure));
    const bool difference = figure >= Q4AgainstQ3 && figure <= Q5AgainstQ4;
    return difference && std::isfinite(value) && std::lround(value) > 0 ? QLatin1Char('+') + text : text;
}

QVariant ComparisonTableModel::lead(const Row &row, int column, int role) const
{
    const bool isAxis = column + 1 == leadingColumns();
    if (role == Qt::DisplayRole)
        return isAxis ? QString::fromUtf8(kAxisNames[static_cast<std::size_t>(row.paper.axis)].data())
                      : QString::fromStdString(row.paper.run);
    if (role == kStrongRole)
        return isAxis;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    return {};
}

QVariant ComparisonTableModel::data(const QModelIndex &index, int role) const
{
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const int figure = index.column() - leadingColumns();
    if (figure < 0)
        return lead(row, index.column(), role);
    const bool difference = figure >= Q4AgainstQ3 && figure <= Q5AgainstQ4;
    switch (role) {
    case Qt::DisplayRole:
        return textOf(row, figure);
    case Qt::TextAlignmentRole:
        return int((figure == Limit ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case kExactRole:
        return figure == Limit ? QVariant() : QVariant(valueOf(row, figure));
    case kStrongRole:
        return figure == Msd6 || figure == Q5 || figure == Left || figure == Limit;
    case kIconRole:
        return figure == Limit && row.passes
                   ? (*row.passes ? QStringLiteral("check") : QStringLiteral("cross"))
                   : QString();
    case kToneRole:
        if (figure == Limit && row.passes)
            return int(*row.passes ? Tone::Good : Tone::Bad);
        return int(difference && valueOf(row, figure) > 0.5 ? Tone::Caution : Tone::Plain);
    default:
        return {};
    }
}

QVariant ComparisonTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const int figure = section - leadingColumns();
    if (role == Qt::TextAlignmentRole)
        return int((figure < 0 || figure == Limit ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (figure) {
    case -2:
        return tr("Run");
    case -1:
        return m_data.run ? m_data.runTitle : tr("Axis");
    case Msd1:
        return tr("MSD1\nbefore");
    case Msd4:
        return tr("MSD4\nConv. 1");
    case Msd5:
        return tr("MSD5\nConv. 2");
    case Msd6:
        return tr("MSD6\nNovel");
    case Q3:
        return tr("Q3\nConv. 1");
    case Q4:
        return tr("Q4\nConv. 2");
    case Q5:
        return tr("Q5\nNovel");
    case Q4AgainstQ3:
        return tr("Q4 − Q3\n% of Q3");
    case Q5AgainstQ3:
        return tr("Q5 − Q3\n% of Q3");
    case Q5AgainstQ4:
        return tr("Q5 − Q4\n% of Q4");
    case Cubic:
        return tr("MSD\ncubic");
    case Constant:
        return tr("MSD\nconstant");
    case Floor:
        return tr("MSD\nfloor");
    case Left:
        return tr("Left\ndps rms");
    default:
        return m_data.limitDps ? tr("Limit\n%1").arg(numberText(*m_data.limitDps, 3)) : tr("Limit\nnone");
    }
}

} // namespace driftbench
