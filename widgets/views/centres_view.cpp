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

static constexpr double kMostDecadesOfLoss = 6.0;
static constexpr double kPercent = 100.0;
static constexpr int kCellsAMean = 50;      // of 0.02 degrees: 1 degree
static constexpr double kWidthsShare = 0.3; // of the panel's height, below the curve

CentresView::CentresView(const Palette &look, QWidget *parent)
    : PlotView(tr("Centres of the RBF network"), look, parent)
{
    rebuild();
}

void CentresView::setData(CentresData shown)
{
    m_data = std::move(shown);
    rebuild();
}

static QPen trainingPen(const Palette &look)
{
    QPen pen = rolePen(Role::Compensated, look);
    pen.setDashPattern({3, 2});
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

// Losses in percent; what cannot stand on a logarithmic axis breaks the line.
static QVector<double> inPercent(const std::vector<double> &losses)
{
    QVector<double> values;
    for (const double loss : losses)
        values.append(loss > 0.0 && std::isfinite(loss) ? kPercent * loss : NAN);
    return values;
}

static QVector<double> countsUpTo(qsizetype size)
{
    QVector<double> counts;
    for (qsizetype i = 0; i < size; ++i)
        counts.append(static_cast<double>(i));
    return counts;
}

void CentresView::buildLosses()
{
    using Kind = LegendEntry::Kind;
    const RbfSelection &selection = *m_data.selection;
    const QString leftOut = selection.leftOutRuns ? tr("runs left out") : tr("temperature blocks left out");
    const QPen chosen(look().axisLine, 1.0);
    addLegend({{Kind::Heading, tr("Excess over the noise floor"), QPen(Qt::NoPen), {}},
               {Kind::Line, tr("On %1, mean").arg(leftOut), rolePen(Role::Compensated, look()), {}},
               {Kind::Line, tr("On the training runs"), trainingPen(look()), {}},
               {Kind::Line, tr("Chosen number"), chosen, {}}});
    Extent losses;
    std::size_t most = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        most = std::max({most, selection.heldOutLoss[axis].size(), selection.trainingLoss[axis].size()});
        for (const auto *ofAxis : {&selection.heldOutLoss[axis], &selection.trainingLoss[axis]}) {
            for (const double value : inPercent(*ofAxis))
                losses.include(value);
        }
    }
    if (losses.empty())
        losses.include(1.0);
    const double lowest = std::max(losses.low(), losses.high() * std::pow(10.0, -kMostDecadesOfLoss));
    QCPLayoutGrid &grid = addPanels(true);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        QCPAxis &left = *rect.axis(QCPAxis::atLeft);
        bottom.setTicker(QSharedPointer<QCPAxisTicker>(new CountTicker));
        bottom.setRange(0.0, std::max(1.0, static_cast<double>(most) - 1.0));
        bottom.setLabel(tr("Number of centres"));
        applyLogScale(left, lowest, losses.high());
        left.setLabel(tr("Excess MSD (%)"));
        if (axis > 0)
            hideAxisText(left);
        addVertical(rect, selection.chosen[a], chosen);
        const auto training = inPercent(selection.trainingLoss[a]);
        const auto heldOut = inPercent(selection.heldOutLoss[a]);
        addLine(rect, countsUpTo(training.size()), training, trainingPen(look()));
        addLine(rect, countsUpTo(heldOut.size()), heldOut, rolePen(Role::Compensated, look()));
        addDots(rect, countsUpTo(heldOut.size()), heldOut, look().compensated, 4.0);
        auto *notes = new PanelNotes(&rect, look());
        notes->setName(QString::fromUtf8(kAxisNames[a].data()));
        notes->setNote(tr("%1 chosen").arg(selection.chosen[a]));
    }
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

void CentresView::drawCurve(QCPAxisRect &rect, int axis)
{
    const StraightLine line = lineThrough(m_data.curve, axis);
    const double reference = m_data.referenceTemperatureC;
    Extent extent, temperature;
    QVector<double> curveT, curveTde, meansT, meansTde, centresT, centresTde;
    for (Eigen::Index i = 0; i < m_data.curve.deltaT.size(); ++i) {
        curveT.append(m_data.curve.deltaT[i] + reference);
        curveTde.append(m_data.curve.tdeDps(i, axis) - line.at(m_data.curve.deltaT[i]));
        extent.include(curveTde.last());
        temperature.include(curveT.last());
    }
    const CellMeans means = cellMeans(m_data.runs, axis);
    for (std::size_t i = 0; i < means.deltaT.size(); ++i) {
        meansT.append(means.deltaT[i] + reference);
        meansTde.append(means.tdeDps[i] - line.at(means.deltaT[i]));
        extent.include(meansTde.last());
        temperature.include(meansT.last());
    }
    const QCPRange shown = extent.padded();
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
    QCPLayoutGrid &grid = addPanels();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        drawCurve(rect, axis);
        rect.axis(QCPAxis::atBottom)->setLabel(tr("T (°C)"));
        rect.axis(QCPAxis::atLeft)->setLabel(axis == 0 ? tr("TDE less line (dps)") : QString());
        (new PanelNotes(&rect, look()))->setName(QString::fromUtf8(kAxisNames[a].data()));
    }
}

void CentresView::build()
{
    if (m_data.curve.deltaT.size() == 0) {
        showEmpty(tr("No RBF network yet"), tr("Train one to see how many centres it needs."));
        return;
    }
    if (m_data.selection)
        buildLosses();
    buildCurves();
}

} // namespace driftbench
