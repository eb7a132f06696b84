#include "app/report/report_html.h"

#include "app/report/index_page.h"
#include "app/report/report_text.h"
#include "widgets/controls/text_label.h"

namespace driftbench {

// From the element on: an SVG inside a page has no head of its own.
static QString inlineSvg(const QByteArray &svg)
{
    const qsizetype start = svg.indexOf("<svg");
    return start < 0 ? QString() : QString::fromUtf8(svg.mid(start));
}

static QString headOf(const ReportDocument &document)
{
    QString html = QStringLiteral("<h1>%1<span class=\"chip\">%2</span></h1>\n<table class=\"facts\">")
                       .arg(document.title.toHtmlEscaped(), document.origin.toHtmlEscaped());
    for (const auto &[name, value] : document.facts)
        html += QStringLiteral("<tr><th>%1</th><td>%2</td></tr>")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    return html + QStringLiteral("</table>\n");
}

static QString cardsOf(const ReportDocument &document, const Palette &look)
{
    QString html = QStringLiteral("<h2>%1</h2><div class=\"cards\">")
                       .arg(ReportText::tr("May this drift be compensated?"));
    for (const ReportCard &card : document.cards) {
        html += QStringLiteral("<div class=\"card\" style=\"border-top-color:%1\"><b>%2</b> "
                               "<b style=\"color:%1\">%3</b> <span class=\"muted\">%4</span><p>%5</p>"
                               "<p class=\"muted\">%6</p></div>")
                    .arg(textColor(TextRole::Note, verdictTone(card.verdict), look).name(),
                         card.axis.toHtmlEscaped(), card.word.toHtmlEscaped(), card.passes.toHtmlEscaped(),
                         card.text.toHtmlEscaped(), card.details.toHtmlEscaped());
    }
    return html + QStringLiteral("</div>\n");
}

static QString tableOf(const ReportTable &table)
{
    QString html = QStringLiteral("<h2>%1</h2>").arg(table.title.toHtmlEscaped());
    if (!table.note.isEmpty())
        html += QStringLiteral("<p class=\"muted\">%1</p>").arg(table.note.toHtmlEscaped());
    html += QStringLiteral("<div class=\"wide\"><table><tr>");
    const auto alignment = [&table](qsizetype column) {
        return table.grid.numeric[static_cast<std::size_t>(column)] ? QStringLiteral("right")
                                                                    : QStringLiteral("left");
    };
    for (qsizetype i = 0; i < table.grid.heads.size(); ++i)
        html += QStringLiteral("<th style=\"text-align:%1\">%2</th>")
                    .arg(alignment(i), table.grid.heads[i].toHtmlEscaped());
    html += QStringLiteral("</tr>");
    for (const auto &row : table.grid.rows) {
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < row.size(); ++i)
            html += QStringLiteral("<td style=\"text-align:%1\">%2</td>")
                        .arg(alignment(static_cast<qsizetype>(i)), row[i].shown.toHtmlEscaped());
        html += QStringLiteral("</tr>\n");
    }
    return html + QStringLiteral("</table></div>\n");
}

static QString figureOf(const ReportFigure &figure)
{
    return QStringLiteral("<figure><p><b>%1</b></p>%2<figcaption>%3</figcaption></figure>\n")
        .arg(figure.title.toHtmlEscaped(), inlineSvg(figure.svg), figure.caption.toHtmlEscaped());
}

QByteArray reportAsHtml(const ReportDocument &document, const Palette &look)
{
    QString html = pageStart(document.title.toHtmlEscaped(), look);
    html.replace(QStringLiteral("</style>"),
                 QStringLiteral("figure svg{width:100%;height:auto}.wide{overflow-x:auto}"
                                ".facts{width:auto}.facts th,.facts td{text-align:left;padding-right:24px}"
                                ".wide td,.wide th{white-space:nowrap}"
                                "@media print{figure,table,.card{break-inside:avoid}}</style>"));
    html += headOf(document) + cardsOf(document, look);
    for (const QString &note : document.notes)
        html += QStringLiteral("<p class=\"muted\">%1</p>\n").arg(note.toHtmlEscaped());
    html += tableOf(document.tables.front());
    html += QStringLiteral("<h2>%1</h2>\n").arg(ReportText::tr("Figures"));
    for (const ReportFigure &figure : document.figures)
        html += figureOf(figure);
    for (std::size_t i = 1; i < document.tables.size(); ++i)
        html += tableOf(document.tables[i]);
    html += QStringLiteral("<h2>%1</h2>\n").arg(ReportText::tr("Method"));
    for (const QString &paragraph : document.method)
        html += QStringLiteral("<p>%1</p>\n").arg(paragraph.toHtmlEscaped());
    return (html + QStringLiteral("</body></html>\n")).toUtf8();
}

} // namespace driftbench
