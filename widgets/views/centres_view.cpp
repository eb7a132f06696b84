#include "widgets/views/centres_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

static constexpr int kCellsAMean = 50;      // of 0.02 degrees: 1 degree
static constexpr double kWidthsShare = 0.3; // of the panel's height, below the curve

static QString nameOf(CentresView::Part part)
{
    switch (part) {
    case CentresView::Part::Losses:
        return CentresView::tr("Excess over the noise floor against the number of centres");
    case CentresView::Part::Curves:
        return CentresView::tr("The curve, its centres and their widths");
    case CentresView::Part::Both:
        break;
    }
    return CentresView::tr("Centres of the RBF network");
}

CentresView::CentresView(const Palette &look, QWidget *parent, Part part)
    : PlotView([part] { return nameOf(part); }, look, parent), m_part(part)
{
    rebuild();
}

void CentresView::setData(CentresData shown)
{
    m_data = std::move(shown);
    rebuild();
}

namespace {

// Means over 1 degree of all runs together, for one axis.
struct CellMeans
{
    std::vector<double> deltaT, tdeDps, count;
};

struct StraightLine
{
    double offset = 0.0;
    double slope = 0.0;
    double at(double deltaT) const { return offset + slope * deltaT; }
};

} // namespace

static CellMeans cellMeans(const std::vector<std::shared_ptr<const RunFeatures>> &runs, int axis)
{
    ThermalCurve all;
    for (const auto &run : runs)
        all.merge(run->curve);
    CellMeans means;
    const ThermalCurve coarse = all.coarsened(kCellsAMean);
    for (const ThermalCell &cell : coarse.cells()) {
        if (cell.count <= 0.0)
            continue;
        means.deltaT.push_back(cell.meanDeltaT());
        means.tdeDps.push_back(cell.meanTdeDps()[axis]);
        means.count.push_back(cell.count);
    }
    return means;
}

// Least squares through the drawn curve.
static StraightLine lineThrough(const ModelCurve &curve, int axis)
{
    const Eigen::ArrayXd d = curve.deltaT.array() - curve.deltaT.mean();
    const Eigen::ArrayXd tde = curve.tdeDps.col(axis).array();
    const double squares = d.square().sum();
    StraightLine line;
    line.slope = squares > 0.0 ? (d * tde).sum() / squares : 0.0;
    line.offset = tde.mean() - line.slope * curve.deltaT.mean();
    return line;
}

// One span for all axes, so that their curves can be weighed against each other.
QCPRange CentresView::curveRange() const
{
    Extent extent;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const StraightLine line = lineThrough(m_data.curve, axis);
        for (Eigen::Index i = 0; i < m_data.curve.deltaT.size(); ++i)
            extent.include(m_data.curve.tdeDps(i, axis) - line.at(m_data.curve.deltaT[i]));
        const CellMeans means = cellMeans(m_data.runs, axis);
        for (std::size_t i = 0; i < means.deltaT.size(); ++i)
            extent.include(means.tdeDps[i] - line.at(means.deltaT[i]));
    }
    return extent.padded();
}

void CentresView::drawCurve(QCPAxisRect &rect, int axis)
{
    const StraightLine line = lineThrough(m_data.curve, axis);
    const double reference = m_data.referenceTemperatureC;
    Extent temperature;
    QVector<double> curveT, curveTde, meansT, meansTde, centresT, centresTde;
    for (Eigen::Index i = 0; i < m_data.curve.deltaT.size(); ++i) {
        curveT.append(m_data.curve.deltaT[i] + reference);
        curveTde.append(m_data.curve.tdeDps(i, axis) - line.at(m_data.curve.deltaT[i]));
        temperature.include(curveT.last());
    }
    const CellMeans means = cellMeans(m_data.runs, axis);
    for (std::size_t i = 0; i < means.deltaT.size(); ++i) {
        meansT.append(means.deltaT[i] + reference);
        meansTde.append(means.tdeDps[i] - line.at(means.deltaT[i]));
        temperature.include(meansT.last());
    }
    const QCPRange shown = curveRange();
    const double top = shown.upper;
    const double below = shown.size() * kWidthsShare;
    const auto used =
        std::min(m_data.centres.size(),
                 static_cast<std::size_t>(std::max(0, m_data.centreCount[static_cast<std::size_t>(axis)])));
    rect.axis(QCPAxis::atLeft)->setRange(used > 0 ? shown.lower - below : shown.lower, top);
    rect.axis(QCPAxis::atBottom)->setRange(temperature.padded(0.03));
    addDots(rect, meansT, meansTde, look().raw, 3.0);
    addLine(rect, curveT, curveTde, rolePen(Role::Compensated, look()));
    for (std::size_t k = 0; k < used; ++k) {
        const RbfCentre &centre = m_data.centres[k];
        centresT.append(centre.deltaT + reference);
        centresTde.append(interpolated(m_data.curve, axis, centre.deltaT) - line.at(centre.deltaT));
        const double level =
            shown.lower - below * (0.1 + 0.8 * static_cast<double>(k) / static_cast<double>(used));
        addLine(
            rect,
            {centre.deltaT - centre.widthDeltaT + reference, centre.deltaT + centre.widthDeltaT + reference},
            {level, level}, QPen(look().axisLine, 1.0));
    }
    auto *diamonds = new QCPGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    diamonds->setLineStyle(QCPGraph::lsNone);
    diamonds->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(look().text, 1.0), QBrush(look().base), 7.0));
    diamonds->setData(centresT, centresTde);
}

void CentresView::buildCurves()
{
    using Kind = LegendEntry::Kind;
    addLegend({{Kind::Heading, tr("The curve, less its straight line"), QPen(Qt::NoPen), {}},
               {Kind::Line, tr("RBF network"), rolePen(Role::Compensated, look()), {}},
               {Kind::Dot, tr("Means of 1 °C"), QPen(Qt::NoPen), look().raw},
               {Kind::Diamond, tr("Centre"), QPen(look().text, 1.0), {}},
               {Kind::Line, tr("Width, ±1 σ"), QPen(look().axisLine, 1.0), {}}});
    QCPLayoutGrid &grid = addPanels(true);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        drawCurve(rect, axis);
        rect.axis(QCPAxis::atBottom)->setLabel(tr("T (°C)"));
        rect.axis(QCPAxis::atLeft)->setLabel(tr("TDE less line (dps)"));
        if (axis > 0) {
            hideAxisText(*rect.axis(QCPAxis::atLeft));
            rect.axis(QCPAxis::atLeft)
                ->setTicker(plot().axisRects().front()->axis(QCPAxis::atLeft)->ticker());
        }
        (new PanelNotes(&rect, look()))->setName(QString::fromUtf8(kAxisNames[a].data()));
    }
}

void CentresView::build()
{
    if (m_data.curve.deltaT.size() == 0) {
        showEmpty(tr("No RBF network yet"), tr("Train one to see how many centres it needs."));
        return;
    }
    if (m_part == Part::Losses && !m_data.selection) {
        showEmpty(tr("No choice was made"), tr("The number of centres was given, so none was tried."));
        return;
    }
    if (m_data.selection && m_part != Part::Curves)
        buildLosses();
    if (m_part != Part::Losses)
        buildCurves();
}

} // namespace driftbench
