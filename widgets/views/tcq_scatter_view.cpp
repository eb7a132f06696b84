#include "widgets/views/tcq_scatter_view.h"

#include "engine/base/axes.h"
#include "engine/features/temperature_quantities.h"
#include "widgets/plot/axis_moves.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

static constexpr double kSelectedDot = 3.0;

TcqScatterView::TcqScatterView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Drift error against the temperature quantities"); }, look, parent)
{
    rebuild();
}

void TcqScatterView::setData(TcqScatterData shown)
{
    TcqDots dots = tcqDots(shown);
    setData(std::move(shown), std::move(dots));
}

void TcqScatterView::setData(TcqScatterData shown, TcqDots dots)
{
    m_data = std::move(shown);
    m_dots = std::move(dots);
    rebuild();
}

static QVector<double> quantityOf(const QVector<double> &deltaT, int quantity)
{
    QVector<double> result;
    result.reserve(deltaT.size());
    for (const double d : deltaT)
        result.append(temperatureQuantities(d)[quantity]);
    return result;
}

static QVector<double> toQVector(const Eigen::VectorXd &values)
{
    return {values.begin(), values.end()};
}

// TDE, or what the main curve leaves of it, of all samples of the axis.
static std::vector<Eigen::VectorXd> valuesOf(const TcqScatterData &data, bool residuals)
{
    std::vector<Eigen::VectorXd> values;
    for (const auto &run : data.runs) {
        Eigen::VectorXd ofRun = run->tdeDps.col(data.axis);
        for (Eigen::Index i = 0; residuals && i < ofRun.size(); ++i)
            ofRun[i] -= interpolated(data.curves.front(), data.axis, run->deltaT[i]);
        values.push_back(std::move(ofRun));
    }
    return values;
}

static ScatterDots dotsOf(const TcqScatterData &data, bool residuals)
{
    ScatterDots dots = scatterDots(data.runs, valuesOf(data, residuals));
    for (const Eigen::Index i : thinned(data.excludedDeltaT.size(), kMostDots)) {
        const double deltaT = data.excludedDeltaT[i];
        const double line = residuals ? interpolated(data.curves.front(), data.axis, deltaT) : 0.0;
        dots.excluded.deltaT.append(deltaT);
        dots.excluded.valueDps.append(data.excludedTdeDps(i, data.axis) - line);
    }
    return dots;
}

TcqDots tcqDots(const TcqScatterData &data)
{
    return {dotsOf(data, false), data.curves.empty() ? ScatterDots{} : dotsOf(data, true)};
}

static void includeDots(const ScatterDots &dots, Extent &deltaT, Extent &values)
{
    for (const ScatterDots::Group *group : {&dots.heating, &dots.cooling, &dots.excluded}) {
        for (qsizetype i = 0; i < group->deltaT.size(); ++i) {
            deltaT.include(group->deltaT[i]);
            if (group != &dots.excluded) // a start-up spike must not press the rest flat
                values.include(group->valueDps[i]);
        }
    }
}

static void includeGrids(const DirectedDensity &density, Extent &deltaT, Extent &values)
{
    for (const DensityGrid *grid : {&density.heating, &density.cooling}) {
        if (grid->empty())
            continue;
        for (const double edge : {grid->lowestDeltaT, grid->highestDeltaT})
            deltaT.include(edge);
        for (const double edge : {grid->lowestDps, grid->highestDps})
            values.include(edge);
    }
}

static void drawDots(QCPAxisRect &rect, const ScatterDots &dots, const DirectedDensity *density, int quantity,
                     const Palette &look)
{
    addDots(rect, quantityOf(dots.excluded.deltaT, quantity), dots.excluded.valueDps, look.excluded, 1.5,
            TcqScatterView::tr("Excluded"));
    if (density) {
        addDensity(rect, density->heating, quantity, look.heating, TcqScatterView::tr("Heating"));
        addDensity(rect, density->cooling, quantity, look.cooling, TcqScatterView::tr("Cooling"));
        return;
    }
    addDots(rect, quantityOf(dots.heating.deltaT, quantity), dots.heating.valueDps, look.heating, 1.5,
            TcqScatterView::tr("Heating"));
    addDots(rect, quantityOf(dots.cooling.deltaT, quantity), dots.cooling.valueDps, look.cooling, 1.5,
            TcqScatterView::tr("Cooling"));
}

// The band around the main curve, or around zero in the residual row.
static void drawBand(QCPAxisRect &rect, const TcqScatterData &data, int quantity, bool residuals,
                     const QColor &fill)
{
    QVector<double> deltaT, low, high;
    for (Eigen::Index b = 0; b < data.band->temperatureC.size(); ++b) {
        const double d = data.band->temperatureC[b] - data.referenceTemperatureC;
        const double half = data.band->curveHalfWidthDps(b, data.axis);
        const double middle = residuals ? 0.0 : interpolated(data.curves.front(), data.axis, d);
        // Over dT^2 a negative dT would fold the band over itself.
        if (!std::isfinite(half) || (quantity == 1 && d < 0.0))
            continue;
        deltaT.append(d);
        low.append(middle - half);
        high.append(middle + half);
    }
    addRange(rect, quantityOf(deltaT, quantity), low, high, fill);
}

static QPen curvePen(const ModelCurve &curve, bool main, const Palette &look)
{
    return main ? QPen(look.text, 1.0) : rolePen(roleOfModel(curve.name), look);
}

static void drawCurve(QCPAxisRect &rect, const ModelCurve &curve, int axis, int quantity, const QPen &pen)
{
    // Over dT^2 the two branches of a curve overlap; each is a line of its own.
    const Eigen::Index split = quantity == 1 ? (curve.deltaT.array() < 0.0).count() : Eigen::Index{0};
    const Eigen::VectorXd tde = curve.tdeDps.col(axis);
    if (split > 0)
        addLine(rect, quantityOf(toQVector(curve.deltaT.head(split)), quantity), toQVector(tde.head(split)),
                pen);
    const Eigen::Index rest = curve.deltaT.size() - split;
    addLine(rect, quantityOf(toQVector(curve.deltaT.tail(rest)), quantity), toQVector(tde.tail(rest)), pen);
}

static QCPRange quantityRange(const Extent &deltaT, int quantity)
{
    Extent extent;
    for (const double d :
         {deltaT.low(), deltaT.high(), deltaT.low() < 0.0 && deltaT.high() > 0.0 ? 0.0 : deltaT.low()})
        extent.include(temperatureQuantities(d)[quantity]);
    return extent.padded(0.03);
}

void TcqScatterView::addLegendRow(const ScatterDots &dots)
{
    using Kind = LegendEntry::Kind;
    std::vector<LegendEntry> entries = dotLegend(dots, look());
    for (LegendEntry &entry : entries) {
        if (entry.fill == look().heating && !m_data.heatingText.isEmpty())
            entry.text = m_data.heatingText;
        if (entry.fill == look().cooling && !m_data.coolingText.isEmpty())
            entry.text = m_data.coolingText;
    }
    for (std::size_t i = 0; i < m_data.curves.size(); ++i) {
        const ModelCurve &curve = m_data.curves[i];
        const QString label = modelLabel(curve.name);
        if (i == 0 && m_data.band)
            entries.push_back({Kind::Range,
                               m_data.bandText.isEmpty()
                                   ? tr("Fitted curve, %1, with its 95 % band").arg(label)
                                   : m_data.bandText,
                               curvePen(curve, true, look()), look().border});
        else
            entries.push_back({Kind::Line,
                               i == 0 ? tr("Fitted curve, %1").arg(label) : label,
                               curvePen(curve, i == 0, look()),
                               {}});
    }
    addLegend(std::move(entries));
}

std::pair<int, int> TcqScatterView::placeOf(const QCPAxisRect *panel) const
{
    const auto panels = plot().axisRects();
    const auto at = static_cast<int>(std::find(panels.begin(), panels.end(), panel) - panels.begin());
    return {at % 3, at / 3};
}

void TcqScatterView::drawSelected(QCPAxisRect &rect, int quantity, bool residuals) const
{
    if (m_data.selectedDeltaT.size() == 0)
        return;
    QVector<double> values;
    for (Eigen::Index i = 0; i < m_data.selectedDeltaT.size(); ++i)
        values.append(
            m_data.selectedTdeDps(i, m_data.axis) -
            (residuals ? interpolated(m_data.curves.front(), m_data.axis, m_data.selectedDeltaT[i]) : 0.0));
    addDots(rect, quantityOf(toQVector(m_data.selectedDeltaT), quantity), values, look().accent, kSelectedDot,
            tr("Selected"));
}

// A column shares its quantity, a row its values; the axes without numbers have the ticks of the one with
// them.
void TcqScatterView::linkPanels() const
{
    const auto panels = plot().axisRects();
    for (int line = 0; line < 3; ++line) {
        QList<QCPAxis *> keys, values;
        for (qsizetype i = 0; i < panels.size(); ++i) {
            if (i % 3 == line)
                keys.append(panels[i]->axis(QCPAxis::atBottom));
            if (i / 3 == line)
                values.append(panels[i]->axis(QCPAxis::atLeft));
        }
        for (QCPAxis *key : keys)
            key->setTicker(keys.last()->ticker());
        for (QCPAxis *value : values)
            value->setTicker(values.first()->ticker());
        linkAxes(keys);
        linkAxes(values);
    }
}

void TcqScatterView::build()
{
    const ScatterDots &tde = m_dots.tde;
    const ScatterDots &left = m_dots.left;
    if (tde.empty()) {
        showEmpty(tr("No samples"), tr("All samples are excluded, or no run was given."));
        return;
    }
    const bool hasCurve = !m_data.curves.empty();
    Extent deltaT, tdeExtent, leftExtent;
    includeDots(tde, deltaT, tdeExtent);
    includeDots(left, deltaT, leftExtent);
    leftExtent.include(0.0);
    const auto axis = static_cast<std::size_t>(m_data.axis);
    const std::array<const DirectedDensity *, 2> density{
        m_data.density ? &m_data.density->tde[axis] : nullptr,
        m_data.density ? &m_data.density->residual[axis] : nullptr};
    if (m_data.density) {
        includeGrids(*density[0], deltaT, tdeExtent);
        includeGrids(*density[1], deltaT, leftExtent);
    }

    addLegendRow(tde);
    QCPLayoutGrid &grid = addPanels(true);
    const QString axisName = QString::fromUtf8(kAxisNames[static_cast<std::size_t>(m_data.axis)].data());
    const std::array<QString, 3> titles{tr("ΔT (°C)"), tr("ΔT² (°C²)"), tr("√ΔT (√°C)")};
    for (int row = 0; row < (hasCurve ? 2 : 1); ++row) {
        for (int quantity = 0; quantity < 3; ++quantity) {
            QCPAxisRect &rect = addPanel(grid, row, quantity);
            QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
            QCPAxis &value = *rect.axis(QCPAxis::atLeft);
            bottom.setRange(quantityRange(deltaT, quantity));
            value.setRange((row == 0 ? tdeExtent : leftExtent).padded());
            value.setLabel(row == 0 ? tr("TDE, %1 (dps)").arg(axisName) : tr("Residual (dps)"));
            bottom.setLabel(titles[static_cast<std::size_t>(quantity)]);
            if (quantity > 0)
                hideAxisText(value);
            if (hasCurve && row == 0)
                hideAxisText(bottom);
            if (hasCurve && m_data.band)
                drawBand(rect, m_data, quantity, row == 1, look().border);
            drawDots(rect, row == 0 ? tde : left, density[static_cast<std::size_t>(row)], quantity, look());
            drawSelected(rect, quantity, row == 1);
            if (row == 1)
                addHorizontal(rect, 0.0, zeroPen(look()));
            for (std::size_t i = m_data.curves.size(); row == 0 && i-- > 0;)
                drawCurve(rect, m_data.curves[i], m_data.axis, quantity,
                          curvePen(m_data.curves[i], i == 0, look()));
        }
    }
    if (hasCurve)
        grid.setRowStretchFactor(0, 1.8);
    linkPanels();
}

} // namespace driftbench
