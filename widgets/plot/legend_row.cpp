#include "widgets/plot/legend_row.h"

#include <QPainter>
#include <QResizeEvent>
#include <QSizePolicy>

namespace driftbench {

LegendRow::LegendRow(QWidget *parent) : QWidget(parent), m_legend({}, lightPalette())
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setSizePolicy(policy);
}

void LegendRow::setEntries(std::vector<LegendEntry> entries, const Palette &palette)
{
    QStringList words;
    for (const LegendEntry &entry : entries)
        words.append(entry.text);
    setAccessibleName(words.join(QStringLiteral(", ")));
    m_legend = LegendPainter(std::move(entries), palette);
    updateGeometry();
    update();
}

QSize LegendRow::sizeHint() const
{
    return {m_legend.widthInOneRow(), m_legend.heightFor(m_legend.widthInOneRow())};
}

QSize LegendRow::minimumSizeHint() const
{
    return {0, m_legend.heightFor(std::max(width(), 1))};
}

// Another width may mean another number of rows.
void LegendRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != width())
        updateGeometry();
}

void LegendRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_legend.paint(painter, rect());
}

} // namespace driftbench
