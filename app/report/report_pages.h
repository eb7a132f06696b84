// Pages of a PDF that fill from top to bottom: what does not fit goes to the next page. px at 96 dpi.
#pragma once

#include "app/report/report_document.h"

#include <QPainter>
#include <QPdfWriter>

namespace driftbench {

class ReportPages
{
public:
    ReportPages(QIODevice &device, const ReportDocument &document);
    ~ReportPages();

    void title(const QString &text, const QString &chip);
    void heading(const QString &text, double roomBelow = 60.0); // with so much room for what follows it
    void paragraph(const QString &text, bool muted = false);
    void facts(const std::vector<std::pair<QString, QString>> &facts);
    void cards(const std::vector<ReportCard> &cards);
    void table(const ReportTable &table);
    void figure(const ReportFigure &figure);

private:
    void need(double height);
    void newPage();
    void foot();
    double textHeight(const QFont &font, double width, const QString &text) const;
    void text(const QRectF &place, const QFont &font, const QColor &color, const QString &words,
              int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap);
    std::vector<double> columnWidths(const TableGrid &grid) const;
    void tableHead(const TableGrid &grid, const std::vector<double> &widths);
    void tableRow(const TableGrid &grid, const std::vector<double> &widths, std::size_t row);
    double rowHeight(const TableGrid &grid, const std::vector<double> &widths, std::size_t row) const;

    QPdfWriter m_writer;
    QPainter m_painter;
    const Palette &m_look;
    QString m_footText;
    double m_width = 0.0;
    double m_height = 0.0; // above the foot
    double m_y = 0.0;
    int m_page = 1;
};

} // namespace driftbench
