#include "app/gui/inspect/excluded_model.h"

#include "widgets/plot/plot_style.h"
#include "widgets/style/number_text.h"

#include <cmath>

namespace driftbench {

static const char *const kReasons[] = {
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "non-finite"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "bad time"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "start-up"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "saturated"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "motion"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "temperature fault"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "excluded"),
    QT_TRANSLATE_NOOP("driftbench::ExcludedModel", "outlier"),
};

static QString reasonText(const ExcludedStretch &stretch)
{
    if (stretch.own)
        return stretch.why.empty() ? ExcludedModel::tr("by hand") : QString::fromStdString(stretch.why);
    for (std::size_t i = 0; i < kMaskReasons.size(); ++i) {
        if (maskReasonName(kMaskReasons[i]) == stretch.why)
            return ExcludedModel::tr(kReasons[i]);
    }
    return QString::fromStdString(stretch.why);
}

void ExcludedModel::setData(std::shared_ptr<const InspectionData> seen)
{
    beginResetModel();
    m_seen = std::move(seen);
    endResetModel();
}

void ExcludedModel::retranslate()
{
    beginResetModel();
    endResetModel();
}

const ExcludedStretch *ExcludedModel::stretch(int row) const
{
    if (!m_seen || row < 0 || row >= rowCount())
        return nullptr;
    return &m_seen->excluded[static_cast<std::size_t>(row)];
}

int ExcludedModel::rowOf(std::size_t run, std::size_t own) const
{
    for (int row = 0; row < rowCount(); ++row) {
        const ExcludedStretch &candidate = m_seen->excluded[static_cast<std::size_t>(row)];
        if (candidate.run == run && candidate.own == own)
            return row;
    }
    return -1;
}

int ExcludedModel::rowCount(const QModelIndex &parent) const
{
    return m_seen && !parent.isValid() ? static_cast<int>(m_seen->excluded.size()) : 0;
}

int ExcludedModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QString ExcludedModel::timeText(const ExcludedStretch &stretch) const
{
    if (stretch.everywhere)
        return tr("all over");
    const InspectedRun &run = m_seen->runs[stretch.run];
    const double unitS = timeScaleFor(m_seen->stripSpanS).secondsPerUnit;
    const auto text = [&](double timeS) {
        const double shown = run.toStrip(timeS) / unitS;
        return unitS == 3600.0 ? hourMinuteText(shown) : numberText(shown, 1);
    };
    const QString from = text(stretch.startS);
    const QString to = text(stretch.endS);
    return from == to ? from : tr("%1 to %2").arg(from, to);
}

QVariant ExcludedModel::data(const QModelIndex &index, int role) const
{
    const ExcludedStretch *const row = stretch(index.row());
    if (!row)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == kSamples ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return tr("%1, %2").arg(QString::fromStdString(m_seen->runs[row->run].name), reasonText(*row));
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (index.column()) {
    case kTime:
        return timeText(*row);
    case kSamples:
        return numberText(static_cast<double>(row->samples), 0);
    default:
        return reasonText(*row);
    }
}

bool ExcludedModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const ExcludedStretch *const row = stretch(index.row());
    if (!row || !row->own || role != Qt::EditRole || index.column() != kWhy)
        return false;
    emit reasonWritten(row->run, *row->own, value.toString().trimmed());
    return true;
}

Qt::ItemFlags ExcludedModel::flags(const QModelIndex &index) const
{
    const ExcludedStretch *const row = stretch(index.row());
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (row && row->own && index.column() == kWhy)
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant ExcludedModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == kSamples ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString unit = timeScaleFor(m_seen ? m_seen->stripSpanS : 600.0).unit;
    switch (section) {
    case kTime:
        return tr("Time (%1)").arg(unit);
    case kSamples:
        return tr("Samples");
    default:
        return tr("Why");
    }
}

} // namespace driftbench
