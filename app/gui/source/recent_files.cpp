#include "app/gui/source/recent_files.h"

#include "widgets/controls/duration_field.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"

#include <QGuiApplication>

#include <algorithm>

namespace driftbench {

static const QString kDash = QStringLiteral("—");

bool SurveyJob::start(const std::filesystem::path &path)
{
    return run([this, path](const ProgressHook &hook) -> Deliver {
        FileSurvey survey = surveyFile(path, hook);
        return [this, survey = std::move(survey)] { emit finished(survey); };
    });
}

RecentFilesModel::RecentFilesModel(QObject *parent) : QAbstractTableModel(parent)
{
    connect(&m_job, &SurveyJob::finished, this, &RecentFilesModel::take);
    // Not from the signal of the outcome: the job still counts as running there.
    connect(&m_job, &Job::runningChanged, this, [this](bool running) {
        if (!running)
            QMetaObject::invokeMethod(
                this, [this] { lookAtNext(); }, Qt::QueuedConnection);
    });
}

static std::filesystem::file_time_type timeOf(const std::filesystem::path &path)
{
    std::error_code code;
    const auto time = std::filesystem::last_write_time(path, code);
    return code ? std::filesystem::file_time_type::min() : time;
}

void RecentFilesModel::setFiles(const QStringList &files)
{
    beginResetModel();
    m_rows.clear();
    for (const QString &file : files) {
        FileSurvey survey;
        survey.path = file.toStdString();
        const auto known = m_known.find(survey.path);
        if (known != m_known.end() && known->second.first == timeOf(survey.path))
            survey = known->second.second;
        m_rows.push_back(survey);
    }
    endResetModel();
    lookAtNext();
}

int RecentFilesModel::rowOf(const std::filesystem::path &path) const
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
                                    [&](const FileSurvey &survey) { return survey.path == path; });
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

void RecentFilesModel::lookAgain()
{
    m_known.clear();
    QStringList files;
    for (const FileSurvey &survey : m_rows)
        files << QString::fromStdString(survey.path.string());
    setFiles(files);
}

void RecentFilesModel::lookAtNext()
{
    if (m_job.isRunning())
        return;
    const auto next = std::find_if(m_rows.begin(), m_rows.end(), [this](const FileSurvey &survey) {
        const auto known = m_known.find(survey.path);
        return known == m_known.end() || known->second.first != timeOf(survey.path);
    });
    if (next != m_rows.end())
        m_job.start(next->path);
}

void RecentFilesModel::take(const FileSurvey &survey)
{
    m_known[survey.path] = {timeOf(survey.path), survey};
    const int row = rowOf(survey.path);
    if (row < 0)
        return;
    m_rows[static_cast<std::size_t>(row)] = survey;
    // What is to be expected of a file depends on the others.
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    emit surveyed(row);
}

int RecentFilesModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RecentFilesModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

// A run is judged by runs that it was not trained on, so one alone can be trained but not judged.
QString RecentFilesModel::expectOf(const FileSurvey &survey) const
{
    if (!survey.expect.isEmpty() || !survey.isTrainable)
        return survey.expect;
    const bool hasOther =
        survey.sensor.known() && std::any_of(m_rows.begin(), m_rows.end(), [&](const FileSurvey &other) {
            return other.path != survey.path && other.isTrainable && other.sensor.known() &&
                   !other.sensor.contradicts(survey.sensor);
        });
    return hasOther ? tr("Ready to train") : tr("Single run");
}

QString RecentFilesModel::cell(const FileSurvey &survey, int column) const
{
    switch (column) {
    case FileColumn:
        return QString::fromStdString(survey.path.filename().string());
    case OriginColumn:
        return survey.origin == Origin::Simulated ? tr("Simulated")
               : survey.origin == Origin::Real    ? tr("Real")
                                                  : QString();
    case FormatColumn:
        return survey.format;
    case SamplesColumn:
        return survey.samples < 0 ? kDash : numberText(static_cast<double>(survey.samples), 0);
    case LengthColumn:
        if (survey.kind == FileKind::Session)
            return survey.plannedRuns > 0 ? tr("%1 of %n runs", nullptr, survey.plannedRuns).arg(survey.runs)
                                          : tr("%n runs", nullptr, survey.runs);
        return survey.durationS < 0.0 ? kDash : durationText(survey.durationS);
    case TemperatureColumn:
        return survey.hasTemperature
                   ? tr("%1 to %2").arg(numberText(survey.lowestC, 1), numberText(survey.highestC, 1))
                   : kDash;
    case ExpectColumn:
        return expectOf(survey);
    default:
        return {};
    }
}

QVariant RecentFilesModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const FileSurvey &row = survey(index.row());
    const Palette &look = lookOf(QGuiApplication::palette());
    switch (role) {
    case Qt::DisplayRole:
        if (index.column() != FileColumn && m_known.find(row.path) == m_known.end())
            return index.column() == ExpectColumn ? tr("Looking…") : QString();
        return cell(row, index.column());
    case Qt::ToolTipRole:
        return QString::fromStdString(row.path.string());
    case Qt::TextAlignmentRole:
        return index.column() >= SamplesColumn && index.column() <= TemperatureColumn
                   ? int(Qt::AlignRight | Qt::AlignVCenter)
                   : int(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::FontRole:
        return index.column() == ExpectColumn ? QVariant(noteFont()) : QVariant();
    case Qt::ForegroundRole:
        if (index.column() == ExpectColumn)
            return row.tone == Tone::Plain ? look.mutedText : textColor(TextRole::Note, row.tone, look);
        return index.column() == OriginColumn || index.column() == FormatColumn ? QVariant(look.mutedText)
                                                                                : QVariant();
    default:
        return {};
    }
}

QVariant RecentFilesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return section >= SamplesColumn && section <= TemperatureColumn
                   ? int(Qt::AlignRight | Qt::AlignVCenter)
                   : int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case FileColumn:
        return tr("File");
    case OriginColumn:
        return tr("Origin");
    case FormatColumn:
        return tr("Format");
    case SamplesColumn:
        return tr("Samples");
    case LengthColumn:
        return tr("Length");
    case TemperatureColumn:
        return tr("T (°C)");
    default:
        return tr("Expect");
    }
}

} // namespace driftbench
