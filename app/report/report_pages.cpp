#include "app/report/report_pages.h"

#include "app/report/report_text.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/fonts.h"

#include <algorithm>
#include <numeric>

namespace driftbench {

static constexpr int kDpi = 96;
static constexpr double kMarginMm = 10.0;
static constexpr double kFootHeight = 24.0;
static constexpr double kGap = 8.0;
static constexpr double kCellPadding = 6.0;
static constexpr double kLongestWord = 260.0; // width that a column of words may ask for

ReportPages::ReportPages(QIODevice &device, const ReportDocument &document)
    : m_writer(&device), m_look(lightPalette())
{
    m_writer.setResolution(kDpi);
    m_writer.setPageSize(QPageSize(QPageSize::A4));
    m_writer.setPageOrientation(QPageLayout::Landscape);
    m_writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
    m_writer.setTitle(document.title);
    m_writer.setCreator(QStringLiteral("Driftbench"));
    m_footText = QStringLiteral("%1 · %2").arg(document.title, document.origin);
    m_painter.begin(&m_writer);
    m_width = m_writer.width();
    m_height = m_writer.height() - kFootHeight;
}

ReportPages::~ReportPages()
{
    foot();
    m_painter.end();
}

void ReportPages::foot()
{
    const QRectF place(0.0, m_height + 4.0, m_width, kFootHeight - 4.0);
    text(place, noteFont(), m_look.mutedText, m_footText, Qt::AlignLeft | Qt::AlignBottom);
    text(place, noteFont(), m_look.mutedText, ReportText::tr("Page %1").arg(m_page),
         Qt::AlignRight | Qt::AlignBottom);
}

void ReportPages::newPage()
{
    foot();
    m_writer.newPage();
    ++m_page;
    m_y = 0.0;
}

void ReportPages::need(double height)
{
    if (m_y > 0.0 && m_y + height > m_height)
        newPage();
}

double ReportPages::textHeight(const QFont &font, double width, const QString &words) const
{
    const QFontMetricsF metrics(font, m_painter.device());
    return metrics.boundingRect(QRectF(0, 0, width, 1e6), Qt::AlignLeft | Qt::TextWordWrap, words).height();
}

void ReportPages::text(const QRectF &place, const QFont &font, const QColor &color, const QString &words,
                       int flags)
{
    m_painter.setFont(font);
    m_painter.setPen(color);
    m_painter.drawText(place, flags, words);
}

void ReportPages::title(const QString &words, const QString &chip)
{
    const QFontMetricsF metrics(pageTitleFont(), m_painter.device());
    text(QRectF(0, m_y, m_width, 30), pageTitleFont(), m_look.text, words, Qt::AlignLeft | Qt::AlignVCenter);
    const double left = metrics.horizontalAdvance(words) + 12.0;
    const QFontMetricsF chipMetrics(noteFont(), m_painter.device());
    const QRectF box(left, m_y + 5.0, chipMetrics.horizontalAdvance(chip) + 16.0, 20.0);
    m_painter.setPen(m_look.border);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawRoundedRect(box, 4, 4);
    text(box, noteFont(), m_look.mutedText, chip, Qt::AlignCenter);
    m_y += 38.0;
}

void ReportPages::heading(const QString &words, double roomBelow)
{
    need(24.0 + roomBelow);
    if (m_y > 0.0)
        m_y += kGap;
    text(QRectF(0, m_y, m_width, 24), resultFont(), m_look.text, words, Qt::AlignLeft | Qt::AlignVCenter);
    m_y += 28.0;
}

void ReportPages::paragraph(const QString &words, bool muted)
{
    const QFont font = muted ? noteFont() : bodyFont();
    const double height = textHeight(font, m_width, words);
    need(height);
    text(QRectF(0, m_y, m_width, height + 2.0), font, muted ? m_look.mutedText : m_look.text, words);
    m_y += height + kGap / 2.0;
}

void ReportPages::facts(const std::vector<std::pair<QString, QString>> &facts)
{
    constexpr double kNames = 170.0;
    for (const auto &[name, value] : facts) {
        const double height = std::max(18.0, textHeight(bodyFont(), m_width - kNames, value));
        need(height);
        text(QRectF(0, m_y, kNames, height), bodyFont(), m_look.mutedText, name);
        text(QRectF(kNames, m_y, m_width - kNames, height + 2.0), bodyFont(), m_look.text, value);
        m_y += height + 2.0;
    }
    m_y += kGap;
}

void ReportPages::cards(const std::vector<ReportCard> &cards)
{
    const double count = std::max<double>(1.0, static_cast<double>(cards.size()));
    const double width = (m_width - (count - 1.0) * 16.0) / count;
    const double inner = width - 24.0;
    double height = 0.0;
    for (const ReportCard &card : cards)
        height = std::max(height, 44.0 + textHeight(noteFont(), inner, card.text) +
                                      textHeight(noteFont(), inner, card.details) + 16.0);
    need(height);
    double left = 0.0;
    for (const ReportCard &card : cards) {
        const QColor color = textColor(TextRole::Note, verdictTone(card.verdict), m_look);
        m_painter.setPen(m_look.border);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRoundedRect(QRectF(left, m_y, width, height), 4, 4);
        m_painter.fillRect(QRectF(left, m_y, width, 3.0), color);
        const QRectF head(left + 12.0, m_y + 8.0, inner, 24.0);
        text(head, resultFont(), m_look.text, card.axis, Qt::AlignLeft | Qt::AlignVCenter);
        text(head.adjusted(24.0, 0, 0, 0), resultFont(), color, card.word, Qt::AlignLeft | Qt::AlignVCenter);
        text(head, noteFont(), m_look.mutedText, card.passes, Qt::AlignRight | Qt::AlignVCenter);
        const double textTop = m_y + 36.0;
        const double own = textHeight(noteFont(), inner, card.text);
        text(QRectF(left + 12.0, textTop, inner, own + 2.0), noteFont(), m_look.text, card.text);
        text(QRectF(left + 12.0, textTop + own + 6.0, inner, height), noteFont(), m_look.mutedText,
             card.details);
        left += width + 16.0;
    }
    m_y += height + kGap;
}

// As wide as the numbers; columns of words share what is left.
std::vector<double> ReportPages::columnWidths(const TableGrid &grid) const
{
    const QFontMetricsF metrics(noteFont(), m_painter.device());
    std::vector<double> widths;
    for (qsizetype column = 0; column < grid.heads.size(); ++column) {
        const auto at = static_cast<std::size_t>(column);
        double width = 0.0;
        for (const QString &word : grid.heads[column].split(QLatin1Char(' ')))
            width = std::max(width, metrics.horizontalAdvance(word));
        for (const auto &row : grid.rows)
            width = std::max(width, std::min(metrics.horizontalAdvance(row[at].shown), kLongestWord));
        widths.push_back(width + 2.0 * kCellPadding);
    }
    const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
    for (double &width : widths)
        width *= m_width / sum;
    return widths;
}

double ReportPages::rowHeight(const TableGrid &grid, const std::vector<double> &widths, std::size_t row) const
{
    double height = 18.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        if (!grid.numeric[i])
            height = std::max(height, 4.0 + textHeight(noteFont(), widths[i] - 2.0 * kCellPadding,
                                                       grid.rows[row][i].shown));
    }
    return height;
}

void ReportPages::tableHead(const TableGrid &grid, const std::vector<double> &widths)
{
    constexpr double kHeight = 34.0;
    m_painter.fillRect(QRectF(0, m_y, m_width, kHeight), m_look.header);
    double left = 0.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const int side = grid.numeric[i] ? Qt::AlignRight : Qt::AlignLeft;
        text(QRectF(left + kCellPadding, m_y, widths[i] - 2.0 * kCellPadding, kHeight), noteFont(),
             m_look.mutedText, grid.heads[static_cast<qsizetype>(i)],
             side | Qt::AlignVCenter | Qt::TextWordWrap);
        left += widths[i];
    }
    m_y += kHeight;
    m_painter.setPen(m_look.border);
    m_painter.drawLine(QPointF(0, m_y), QPointF(m_width, m_y));
}

void ReportPages::tableRow(const TableGrid &grid, const std::vector<double> &widths, std::size_t row)
{
    const double height = rowHeight(grid, widths, row);
    double left = 0.0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const int side = grid.numeric[i] ? int(Qt::AlignRight) : int(Qt::AlignLeft) | int(Qt::TextWordWrap);
        text(QRectF(left + kCellPadding, m_y, widths[i] - 2.0 * kCellPadding, height), noteFont(),
             m_look.text, grid.rows[row][i].shown, side | Qt::AlignVCenter);
        left += widths[i];
    }
    m_y += height;
    m_painter.setPen(m_look.grid);
    m_painter.drawLine(QPointF(0, m_y), QPointF(m_width, m_y));
}

void ReportPages::table(const ReportTable &table)
{
    heading(table.title, 100.0);
    if (!table.note.isEmpty())
        paragraph(table.note, true);
    const std::vector<double> widths = columnWidths(table.grid);
    tableHead(table.grid, widths);
    for (std::size_t row = 0; row < table.grid.rows.size(); ++row) {
        if (m_y + rowHeight(table.grid, widths, row) > m_height) {
            newPage();
            tableHead(table.grid, widths);
        }
        tableRow(table.grid, widths, row);
    }
    m_y += kGap;
}

void ReportPages::figure(const ReportFigure &figure)
{
    const double captionHeight = textHeight(noteFont(), m_width, figure.caption);
    const double around = 24.0 + captionHeight + 12.0;
    const double scale = std::min({1.0, m_width / figure.size.width(),
                                   (m_height - around) / static_cast<double>(figure.size.height())});
    const double height = scale * figure.size.height();
    need(height + around);
    text(QRectF(0, m_y, m_width, 22), sectionFont(), m_look.text, figure.title,
         Qt::AlignLeft | Qt::AlignVCenter);
    m_y += 24.0;
    m_painter.save();
    m_painter.translate((m_width - scale * figure.size.width()) / 2.0, m_y);
    m_painter.scale(scale, scale);
    m_painter.drawPicture(QPointF(0, 0), figure.picture);
    m_painter.restore();
    m_y += height + 2.0;
    text(QRectF(0, m_y, m_width, captionHeight + 2.0), noteFont(), m_look.mutedText, figure.caption);
    m_y += captionHeight + 10.0;
}

} // namespace driftbench
