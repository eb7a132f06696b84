#include "widgets/views/curve_panels_view.h"

#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"

#include <algorithm>

namespace driftbench {

static constexpr int kWidth = 1040;
static constexpr int kRowHeight = 300;

CurvePanelsView::CurvePanelsView(const QString &accessibleName, const Palette &look, QWidget *parent)
    : PlotView([accessibleName] { return accessibleName; }, look, parent)
{
    rebuild();
}

void CurvePanelsView::setPanels(std::vector<CurvePanel> panels, int columns)
{
    m_panels = std::move(panels);
    m_columns = std::max(columns, 1);
    rebuild();
}

QSize CurvePanelsView::figureSize() const
{
    const int rows = (static_cast<int>(m_panels.size()) + m_columns - 1) / m_columns;
    return {kWidth, kRowHeight * std::max(rows, 1)};
}

void CurvePanelsView::buildPanel(QCPAxisRect &rect, const CurvePanel &panel) const
{
    Extent keys, values;
    for (const CurveSeries &curve : panel.curves) {
        std::for_each(curve.keys.begin(), curve.keys.end(), [&](double key) { keys.include(key); });
        std::for_each(curve.values.begin(), curve.values.end(), [&](double v) { values.include(v); });
    }
    if (panel.zeroLine)
        values.include(0.0);
    rect.axis(QCPAxis::atBottom)->setRange(keys.padded(0.0));
    rect.axis(QCPAxis::atBottom)->setLabel(panel.keyLabel);
    rect.axis(QCPAxis::atLeft)->setRange(values.padded());
    rect.axis(QCPAxis::atLeft)->setLabel(panel.valueLabel);
    if (panel.zeroLine)
        addHorizontal(rect, 0.0, zeroPen(look()));
    std::vector<MarginLabel> labels;
    for (const CurveSeries &curve : panel.curves) {
        const QPen pen = rolePen(curve.role, look());
        addLine(rect, curve.keys, curve.values, pen);
        if (!curve.label.isEmpty() && !curve.values.isEmpty())
            labels.push_back({curve.values.back(), pen, curve.label, curve.role == Role::Compensated});
    }
    auto *notes = new PanelNotes(&rect, look());
    notes->setName(panel.name);
    if (!panel.note.isEmpty())
        notes->setNote(panel.note);
    if (!labels.empty())
        notes->setMarginLabels(std::move(labels));
}

void CurvePanelsView::build()
{
    const bool any = std::any_of(m_panels.begin(), m_panels.end(), [](const CurvePanel &panel) {
        return std::any_of(panel.curves.begin(), panel.curves.end(),
                           [](const CurveSeries &curve) { return !curve.values.isEmpty(); });
    });
    if (!any) {
        showEmpty(tr("No curves"), tr("There is nothing to draw over this range."));
        return;
    }
    QCPLayoutGrid &grid = addPanels();
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const int place = static_cast<int>(i);
        buildPanel(addPanel(grid, place / m_columns, place % m_columns), m_panels[i]);
    }
}

} // namespace driftbench
