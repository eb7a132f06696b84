#include "app/report/report_pdf.h"

#include "app/report/report_pages.h"
#include "app/report/report_text.h"

#include <QBuffer>

namespace driftbench {

QByteArray reportAsPdf(const ReportDocument &document)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        ReportPages pages(buffer, document);
        pages.title(document.title, document.origin);
        pages.facts(document.facts);
        pages.heading(ReportText::tr("May this drift be compensated?"), 160.0);
        pages.cards(document.cards);
        for (const QString &note : document.notes)
            pages.paragraph(note, true);
        for (const ReportTable &table : document.tables)
            pages.table(table);
        pages.heading(ReportText::tr("Method"));
        for (const QString &paragraph : document.method)
            pages.paragraph(paragraph);
        for (const ReportFigure &figure : document.figures)
            pages.figure(figure);
    }
    return bytes;
}

} // namespace driftbench
