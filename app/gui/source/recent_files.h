// The files that were opened lately, sessions and logs, as a table that fills itself in: each file is looked
// at on another thread, one after the other, and the result is remembered until the file changes.
#pragma once

#include "app/gui/source/file_survey.h"
#include "app/session/job.h"

#include <QAbstractTableModel>

#include <map>
#include <vector>

namespace driftbench {

// Looks at one file.
class SurveyJob final : public Job
{
    Q_OBJECT

public:
    explicit SurveyJob(QObject *parent = nullptr) : Job(parent) {}
    ~SurveyJob() override { cancelAndWait(); }

    bool start(const std::filesystem::path &path);

signals:
    void finished(const driftbench::FileSurvey &survey);
};

class RecentFilesModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        FileColumn,
        OriginColumn,
        FormatColumn,
        SamplesColumn,
        LengthColumn,
        TemperatureColumn,
        ExpectColumn,
        ColumnCount
    };

    explicit RecentFilesModel(QObject *parent = nullptr);

    void setFiles(const QStringList &files); // the newest first
    const FileSurvey &survey(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    int rowOf(const std::filesystem::path &path) const; // -1: not there
    void lookAgain();                                   // at all of them
    bool isLooking() const { return m_job.isRunning(); }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void surveyed(int row);

private:
    void lookAtNext();
    void take(const FileSurvey &survey);
    QString cell(const FileSurvey &survey, int column) const;
    QString expectOf(const FileSurvey &survey) const;

    std::vector<FileSurvey> m_rows;
    std::map<std::filesystem::path, std::pair<std::filesystem::file_time_type, FileSurvey>> m_known;
    SurveyJob m_job;
};

} // namespace driftbench
