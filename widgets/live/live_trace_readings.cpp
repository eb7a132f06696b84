// The part of LiveTraceView that says what is shown: cursors, legend, table, the text at the mouse.
#include "engine/base/axes.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/plot/axis_moves.h"
#include "widgets/plot/plot_style.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <qcustomplot.h>

#include <algorithm>

namespace driftbench {

std::optional<CursorReading> LiveTraceView::reading(Cursor cursor) const
{
    const auto key = cursors().key(cursor);
    if (!key || m_traces->empty())
        return std::nullopt;
    const double half = kCursorMeanS / 2.0;
    const auto means = m_traces->means(*key - half, std::min(*key + half, m_traces->lastS()));
    if (!means)
        return std::nullopt;
    return CursorReading{*key, *means};
}

std::vector<LegendEntry> LiveTraceView::legend() const
{
    using Kind = LegendEntry::Kind;
    std::vector<LegendEntry> entries{
        {Kind::Range, tr("Raw, mean and range"), rolePen(Role::Raw, m_look), m_look.rawRange}};
    if (m_compensated)
        entries.push_back(
            {Kind::Range, tr("Compensated"), rolePen(Role::Compensated, m_look), m_look.compensatedRange});
    if (m_referenceDps)
        entries.push_back({Kind::Line, tr("Reference"), referencePen(m_look), {}});
    if (!m_marks->gaps.empty())
        entries.push_back({Kind::Triangle, tr("Dropped"), QPen(Qt::NoPen), m_look.caution});
    return entries;
}

PlotTable LiveTraceView::table() const
{
    const auto shownData = visible();
    PlotTable table;
    table.columns.push_back({tr("Time (s)"), {}, shownData.timeS, 3});
    const auto add = [&](const QString &name, std::size_t trace) {
        table.columns.push_back({tr("%1, lowest").arg(name), {}, shownData.low[trace]});
        table.columns.push_back({tr("%1, mean").arg(name), {}, shownData.mean[trace]});
        table.columns.push_back({tr("%1, highest").arg(name), {}, shownData.high[trace]});
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString name = QString::fromUtf8(kAxisNames[axis].data());
        add(tr("%1 raw (dps)").arg(name), TracePyramid::kRaw + axis);
        if (m_compensated)
            add(tr("%1 compensated (dps)").arg(name), TracePyramid::kCompensated + axis);
    }
    add(tr("T (°C)"), TracePyramid::kTemperature);
    return table;
}

QString LiveTraceView::hoverText(const QPointF &place) const
{
    const QString mark = m_marks->textAt(place);
    if (!mark.isEmpty())
        return mark;
    const QCPAxisRect *panel = panelAt(*m_plot, place);
    if (!panel || panelPartAt(*panel, place) != PanelPart::Inside)
        return {};
    const double timeS = m_strips->keys().pixelToCoord(place.x());
    const double halfS =
        0.5 * std::max(m_strips->keys().range().size() / m_strips->columns(), m_traces->intervalS());
    QStringList lines{clockText(timeS)};
    const auto means = timeS <= nowS() ? m_traces->means(timeS - halfS, timeS + halfS) : std::nullopt;
    if (panel != &m_strips->panel(LiveStrips::kStrips - 1)) {
        const auto axis =
            static_cast<std::size_t>(m_plot->axisRects().indexOf(const_cast<QCPAxisRect *>(panel)));
        const double shift = shiftDps()[static_cast<Eigen::Index>(axis)];
        if (means)
            lines.append(tr("raw %1 dps").arg(numberText((*means)[TracePyramid::kRaw + axis] + shift, 3)));
        if (means && m_compensated)
            lines.append(tr("compensated %1 dps")
                             .arg(numberText((*means)[TracePyramid::kCompensated + axis] + shift, 3)));
    } else {
        if (means)
            lines.append(tr("T %1 °C").arg(numberText((*means)[TracePyramid::kTemperature], 2)));
        if (m_plan && timeS >= 0.0 && timeS <= m_plan->durationS())
            lines.append(tr("plan %1 °C").arg(numberText(m_plan->setpointC(timeS), 2)));
    }
    return lines.size() > 1 ? lines.join(QLatin1Char('\n')) : QString();
}

} // namespace driftbench
