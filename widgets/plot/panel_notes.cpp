#include "widgets/plot/panel_notes.h"

#include "widgets/plot/label_places.h"
#include "widgets/plot/plot_style.h"
#include "widgets/style/fonts.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr int kLeadLength = 20;
static constexpr int kLeadGap = 4;
static constexpr int kNameHeight = 22;
static constexpr double kLabelDistance = 14.0;

PanelNotes::PanelNotes(QCPAxisRect *rect, const Palette &palette)
    : QCPAbstractItem(rect->parentPlot())
    , m_rect(rect)
    , m_textColor(palette.text)
    , m_mutedColor(palette.mutedText)
{
    setClipToAxisRect(false);
}

void PanelNotes::setName(const QString &name)
{
    m_name = name;
    makeRoom();
}

void PanelNotes::setNote(const QString &note)
{
    m_note = note;
    makeRoom();
}

void PanelNotes::setMarginLabels(std::vector<MarginLabel> labels)
{
    std::erase_if(labels, [](const MarginLabel &label) { return !std::isfinite(label.value); });
    m_labels = std::move(labels);
    makeRoom();
}

void PanelNotes::setMarginRoom(const QString &widestLabel)
{
    m_widestLabel = widestLabel;
    makeRoom();
}

void PanelNotes::makeRoom()
{
    int right = kPanelGap;
    if (!m_widestLabel.isEmpty())
        right = kLeadLength + kLeadGap + QFontMetrics(strongNoteFont()).horizontalAdvance(m_widestLabel);
    for (const MarginLabel &label : m_labels) {
        const QFontMetrics metrics(label.main ? strongNoteFont() : noteFont());
        right = std::max(right, kLeadLength + kLeadGap + metrics.horizontalAdvance(label.text) + kPanelGap);
    }
    const int top = m_name.isEmpty() && m_note.isEmpty() ? kPanelGap : kNameHeight;
    m_rect->setMinimumMargins(QMargins(0, top, right, 0));
}

void PanelNotes::drawMarginLabels(QCPPainter &painter) const
{
    const QCPAxis *axis = m_rect->axis(QCPAxis::atLeft);
    const QRect panel = m_rect->rect();
    std::vector<double> wanted;
    for (const MarginLabel &label : m_labels)
        wanted.push_back(
            std::clamp(axis->coordToPixel(label.value), double(panel.top()), double(panel.bottom())));
    const auto places = pushedApart(wanted, kLabelDistance, panel.top(), panel.bottom());
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        const MarginLabel &label = m_labels[i];
        const double left = panel.right() + 1.0;
        const double half = kLeadLength / 2.0;
        painter.setPen(label.pen);
        painter.drawLine(QLineF(left, wanted[i], left + half, places[i]));
        painter.drawLine(QLineF(left + half, places[i], left + kLeadLength, places[i]));
        painter.setFont(label.main ? strongNoteFont() : noteFont());
        painter.setPen(label.main ? label.pen.color() : m_mutedColor);
        painter.drawText(QRectF(left + kLeadLength + kLeadGap, places[i] - 10.0, 10.0, 20.0),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, label.text);
    }
}

void PanelNotes::draw(QCPPainter *painter)
{
    const QRect panel = m_rect->rect();
    const QRect above(panel.left(), panel.top() - kNameHeight, panel.width(), kNameHeight - 4);
    painter->setFont(sectionFont());
    painter->setPen(m_textColor);
    painter->drawText(above, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, m_name);
    painter->setFont(noteFont());
    painter->setPen(m_mutedColor);
    painter->drawText(above, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, m_note);
    drawMarginLabels(*painter);
}

} // namespace driftbench
