#include "widgets/views/residual_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"

#include <cmath>

namespace driftbench {

static constexpr double kCellC = 1.0;
static constexpr double kSameSpanUpTo = 4.0; // axes whose spans differ by more get each their own

ResidualView::ResidualView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Residual against temperature"); }, look, parent)
{
    rebuild();
}

void ResidualView::setTraces(ResidualTraces traces)
{
    m_shown = std::move(traces);
    rebuild();
}

static QVector<double> shifted(QVector<double> values, double by)
{
    for (double &value : values)
        value += by;
    return values;
}

// Of one run, heating and cooling apart, as far as there are both.
static void addMeans(const RunFeatures &run, const Eigen::MatrixX3d &residualDps, ResidualTraces &traces)
{
    const auto heating = heatingFlags(run.timeS, run.deltaT);
    for (const std::uint8_t direction : {1, 0}) {
        Extent extent;
        for (Eigen::Index i = 0; i < run.deltaT.size(); ++i) {
            if (heating[static_cast<std::size_t>(i)] == direction)
                extent.include(run.deltaT[i]);
        }
        if (extent.empty())
            continue;
        const int cells = std::max(1, static_cast<int>((extent.high() - extent.low()) / kCellC));
        for (int axis = 0; axis < kAxisCount; ++axis) {
            Eigen::VectorXd values = residualDps.col(axis);
            for (Eigen::Index i = 0; i < values.size(); ++i) {
                if (heating[static_cast<std::size_t>(i)] != direction)
                    values[i] = NAN;
            }
            traces.means[static_cast<std::size_t>(axis)].push_back(
                envelope(run.deltaT, values, extent.low(), extent.high(), cells));
        }
    }
}

ResidualTraces residualTraces(const ResidualData &data)
{
    ResidualTraces traces;
    traces.referenceTemperatureC = data.referenceTemperatureC;
    traces.band = data.band;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<Eigen::VectorXd> values;
        for (const Eigen::MatrixX3d &residual : data.residualDps)
            values.emplace_back(residual.col(static_cast<Eigen::Index>(axis)));
        traces.dots[axis] = scatterDots(data.runs, values);
    }
    for (std::size_t r = 0; r < data.runs.size(); ++r)
        addMeans(*data.runs[r], data.residualDps[r], traces);
    return traces;
}

void ResidualView::drawMeans(QCPAxisRect &rect, int axis) const
{
    for (const Envelope &means : m_shown.means[static_cast<std::size_t>(axis)])
        addLine(rect, shifted(means.key, m_shown.referenceTemperatureC), means.mean, QPen(look().text, 1.0));
}

void ResidualView::drawBand(QCPAxisRect &rect, int axis, bool filled) const
{
    QVector<double> temperature, low, high;
    for (Eigen::Index b = 0; b < m_shown.band->temperatureC.size(); ++b) {
        const double half = m_shown.band->curveHalfWidthDps(b, axis);
        if (!std::isfinite(half))
            continue;
        temperature.append(m_shown.band->temperatureC[b]);
        low.append(-half);
        high.append(half);
    }
    if (filled) {
        addRange(rect, temperature, low, high, look().border);
    } else {
        addLine(rect, temperature, low, referencePen(look()));
        addLine(rect, temperature, high, referencePen(look()));
    }
}

void ResidualView::build()
{
    const std::array<ScatterDots, 3> &dots = m_shown.dots;
    std::array<Extent, 3> extents;
    Extent temperature, widest;
    double narrowest = INFINITY;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const auto *group : {&dots[axis].heating, &dots[axis].cooling, &dots[axis].excluded}) {
            for (qsizetype i = 0; i < group->deltaT.size(); ++i) {
                temperature.include(group->deltaT[i] + m_shown.referenceTemperatureC);
                if (group != &dots[axis].excluded) // a start-up spike must not press the rest flat
                    extents[axis].include(group->valueDps[i]);
            }
        }
        extents[axis].include(0.0);
        widest.include(extents[axis].low());
        widest.include(extents[axis].high());
        narrowest = std::min(narrowest, extents[axis].high() - extents[axis].low());
    }
    if (temperature.empty()) {
        showEmpty(tr("No residuals yet"), tr("Train a model and choose runs that it has not seen."));
        return;
    }
    const bool same = widest.high() - widest.low() <= kSameSpanUpTo * narrowest;

    using Kind = LegendEntry::Kind;
    std::vector<LegendEntry> entries = dotLegend(dots.front(), look());
    entries.push_back({Kind::Line, tr("Mean over 1 °C, each run"), QPen(look().text, 1.0), {}});
    if (m_shown.band)
        entries.push_back(
            {Kind::Range, tr("95 % band of a new run's curve"), referencePen(look()), look().border});
    addLegend(std::move(entries));
    QCPLayoutGrid &grid = addPanels(same);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        QCPAxis &value = *rect.axis(QCPAxis::atLeft);
        rect.axis(QCPAxis::atBottom)->setRange(temperature.padded(0.03));
        rect.axis(QCPAxis::atBottom)->setLabel(tr("T (°C)"));
        value.setRange((same ? widest : extents[a]).padded());
        value.setLabel(axis == 0 ? tr("Residual (dps)") : QString());
        if (axis > 0 && same)
            hideAxisText(value);
        const double reference = m_shown.referenceTemperatureC;
        if (m_shown.band)
            drawBand(rect, axis, true);
        addDots(rect, shifted(dots[a].excluded.deltaT, reference), dots[a].excluded.valueDps,
                look().excluded);
        addDots(rect, shifted(dots[a].heating.deltaT, reference), dots[a].heating.valueDps, look().heating);
        addDots(rect, shifted(dots[a].cooling.deltaT, reference), dots[a].cooling.valueDps, look().cooling);
        addHorizontal(rect, 0.0, QPen(look().axisLine, 1.0));
        if (m_shown.band)
            drawBand(rect, axis, false);
        drawMeans(rect, axis);
        (new PanelNotes(&rect, look()))->setName(QString::fromUtf8(kAxisNames[a].data()));
    }
}

} // namespace driftbench
