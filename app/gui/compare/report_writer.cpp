#include "app/gui/compare/report_writer.h"

#include "app/report/report_data_loader.h"
#include "app/report/report_html.h"
#include "app/report/report_pdf.h"
#include "engine/base/atomic_file.h"

namespace driftbench {

// Shares of the way.
static constexpr double kPrepared = 0.2;
static constexpr double kDrawn = 0.8;

ReportWriter::ReportWriter(QObject *parent) : QObject(parent)
{
    m_slices.setInterval(0);
    connect(&m_slices, &QTimer::timeout, this, &ReportWriter::drawNext);
    connect(&m_preparing, &TaskJob::finished, this, &ReportWriter::dataReady);
    connect(&m_preparing, &Job::progress, this, [this](const QString &, double fraction) {
        emit progress(tr("Preparing"), kPrepared * fraction);
    });
    connect(&m_writing, &TaskJob::finished, this, &ReportWriter::end);
}

bool ReportWriter::start(std::shared_ptr<const PreparedCampaign> prepared,
                         std::shared_ptr<const CalibrationResult> result, std::optional<double> limitDps,
                         const std::filesystem::path &file)
{
    if (m_running)
        return false;
    m_running = true;
    m_cancelled = false;
    m_file = file;
    m_figures = std::make_shared<PreparedFigures>();
    emit progress(tr("Preparing"), 0.0);
    return m_preparing.start([figures = m_figures, prepared = std::move(prepared), result = std::move(result),
                              limitDps](const ProgressHook &hook) -> Status {
        auto data = std::make_shared<ReportData>(reportDataOf(*prepared, *result));
        data->limitDps = limitDps;
        auto made = prepareFigures(data, hook);
        if (!made)
            return made.error();
        *figures = *std::move(made);
        return {};
    });
}

void ReportWriter::cancel()
{
    m_cancelled = true;
    m_preparing.cancel();
    m_writing.cancel();
}

static Error reportCancelled()
{
    return {Errc::Cancelled, "The report was cancelled; nothing was written."};
}

void ReportWriter::dataReady(const Status &outcome)
{
    if (!outcome)
        return end(outcome);
    m_data = m_figures->data;
    m_document = std::make_shared<ReportDocument>(reportDocument(*m_data, QDateTime::currentDateTime()));
    m_tasks = figureTasks(m_figures, lightPalette(), true);
    m_next = 0;
    m_slices.start();
}

void ReportWriter::drawNext()
{
    if (m_cancelled) {
        m_slices.stop();
        return end(reportCancelled());
    }
    if (m_next == m_tasks.size()) {
        m_slices.stop();
        return writeNow();
    }
    if (!m_drawing)
        m_drawing.emplace(m_tasks[m_next], m_document->simulated ? m_document->origin : QString());
    if (m_drawing->goOn())
        return;
    if (auto figure = m_drawing->take())
        m_document->figures.push_back(std::move(*figure));
    m_drawing.reset();
    ++m_next;
    const double part = static_cast<double>(m_next) / static_cast<double>(m_tasks.size());
    emit progress(tr("Drawing figure %1 of %2").arg(m_next).arg(m_tasks.size()),
                  kPrepared + (kDrawn - kPrepared) * part);
}

static Status writeDocument(const ReportDocument &document, const std::filesystem::path &file,
                            const ProgressHook &hook)
{
    const bool html = file.extension() == ".html" || file.extension() == ".htm";
    if (!html && file.extension() != ".pdf")
        return Error{Errc::InvalidOption,
                     "A report can't be written as " + file.string() + ": give it the ending .pdf or .html."};
    const QByteArray bytes = html ? reportAsHtml(document, lightPalette()) : reportAsPdf(document);
    if (report(hook, "writing", 1.0) == Flow::Stop)
        return reportCancelled();
    return writeFileAtomically(file,
                               std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

// All that the report was made of goes with the job: to give so much back takes its time.
void ReportWriter::writeNow()
{
    emit progress(tr("Writing"), kDrawn);
    m_writing.start([document = std::move(m_document), figures = std::move(m_figures),
                     data = std::move(m_data), tasks = std::move(m_tasks),
                     file = m_file](const ProgressHook &hook) mutable -> Status {
        tasks.clear();
        figures.reset();
        data.reset();
        Status written = writeDocument(*document, file, hook);
        document.reset();
        return written;
    });
}

void ReportWriter::end(const Status &outcome)
{
    m_running = false;
    m_drawing.reset();
    m_tasks.clear();
    m_document.reset();
    m_figures.reset();
    m_data.reset();
    emit finished(outcome);
}

} // namespace driftbench
