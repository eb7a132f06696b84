// A report of the session as PDF or HTML, by the file's ending, without holding up the window: what takes
// long is done on the thread of a job, the figures are drawn part by part between the events of the window.
#pragma once

#include "app/report/report_document.h"
#include "app/session/job.h"
#include "app/session/prepared_campaign.h"
#include "widgets/style/palette.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>

namespace driftbench {

class ReportWriter : public QObject
{
    Q_OBJECT

public:
    explicit ReportWriter(QObject *parent = nullptr);

    bool isRunning() const { return m_running; }
    // False: one is being written.
    bool start(std::shared_ptr<const PreparedCampaign> prepared,
               std::shared_ptr<const CalibrationResult> result, std::optional<double> limitDps,
               const std::filesystem::path &file);
    void cancel();

signals:
    void progress(const QString &stage, double fraction);
    void finished(const driftbench::Status &outcome);

private:
    void dataReady(const Status &outcome);
    void drawNext();
    void writeNow();
    void end(const Status &outcome);

    TaskJob m_preparing;
    TaskJob m_writing;
    QTimer m_slices;
    bool m_running = false;
    bool m_cancelled = false;
    std::filesystem::path m_file;
    std::shared_ptr<const ReportData> m_data;
    std::shared_ptr<PreparedFigures> m_figures;
    std::vector<FigureTask> m_tasks;
    std::size_t m_next = 0;
    std::optional<FigureDrawing> m_drawing;
    std::shared_ptr<ReportDocument> m_document;
};

} // namespace driftbench
