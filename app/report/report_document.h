// A report as a document: what it says, before it is laid out as PDF (report_pdf.h) or HTML (report_html.h).
//
//   head      title, origin, facts: sensor, date, method, judging, limit
//   verdicts  one card an axis, in words, with the engine's reason
//   runs      where each comes from, how much of it was used, what was left out and why
//   tables    all models, then the comparison in the paper's order
//   figures   as vectors, drawn one at a time in the thread of the application
//
// A report of simulated data says so in its title, its facts, every figure and on every page.
#pragma once

#include "app/report/figure_list.h"
#include "app/report/report_data.h"
#include "widgets/style/palette.h"
#include "widgets/tables/table_text.h"
#include "widgets/views/verdict_card.h"

#include <QByteArray>
#include <QDateTime>
#include <QPicture>
#include <QString>

#include <memory>
#include <utility>
#include <vector>

namespace driftbench {

struct ReportCard
{
    QString axis;
    Verdict verdict = Verdict::NotRepeatable;
    QString word;    // "Yes"
    QString passes;  // "passes on 2 of 3 runs"; may be empty
    QString text;    // what to do, the figures, the reason
    QString details; // the engine's sentence
};

struct ReportTable
{
    QString title;
    QString note;
    TableGrid grid;
};

struct ReportFigure
{
    QString title;
    QString caption;
    QSize size;       // px at 96 dpi
    QByteArray svg;   // for HTML
    QPicture picture; // for PDF
};

struct ReportDocument
{
    bool simulated = false;
    QString title;
    QString origin; // "Simulated data", "Real log"
    std::vector<std::pair<QString, QString>> facts;
    std::vector<ReportCard> cards;
    QStringList method; // paragraphs
    std::vector<ReportTable> tables;
    std::vector<ReportFigure> figures;
    QStringList notes; // warnings
};

// All but the figures. In the thread of the application.
ReportDocument reportDocument(const ReportData &data, const QDateTime &made);

// One figure, drawn in the thread of the application in parts, so that a window can answer between them.
//
//   FigureDrawing drawing(task, document.simulated ? document.origin : QString());
//   while (drawing.goOn()) {}
class FigureDrawing
{
public:
    FigureDrawing(FigureTask task, QString origin);

    bool goOn(); // the next part; false: there was none
    // When it is done; nothing where the view had nothing to show.
    std::optional<ReportFigure> take() { return std::move(m_figure); }

private:
    enum class Part
    {
        View,
        Svg,
        Picture,
        Done
    };

    FigureTask m_task;
    QString m_origin;
    Part m_next = Part::View;
    std::unique_ptr<PlotView> m_view;
    std::optional<ReportFigure> m_figure;
};

// All of it at once, for programs without a window.
Result<ReportDocument> completeReport(const std::shared_ptr<const ReportData> &data, const QDateTime &made);

} // namespace driftbench
