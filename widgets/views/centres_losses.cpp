#include "engine/base/axes.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/role_pens.h"
#include "widgets/views/centres_view.h"

#include "widgets/plot/legend_element.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kMostDecadesOfLoss = 6.0;
static constexpr double kPercent = 100.0;

struct CentresView::LossRange
{
    double lowest = 0.1; // percent
    double highest = 100.0;
    std::size_t most = 1; // losses an axis
};

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

// A range that reaches below the axis (a run that beat its floor) is filled from the axis on.
static QVector<double> atLeast(QVector<double> values, double lowest)
{
    for (double &value : values)
        value = std::isfinite(value) ? std::max(value, lowest) : lowest;
    return values;
}

int CentresView::countAt(double key) const
{
    if (!m_data.selection)
        return 0;
    const auto tried = static_cast<int>(m_data.selection->heldOutLoss[0].size());
    return std::clamp(static_cast<int>(std::lround(key)), 0, std::max(0, tried - 1));
}

void CentresView::enablePicking()
{
    connect(&enableInteraction(), &PlotInteraction::clicked, this,
            [this](const QCPAxisRect *panel, const QPointF &place) {
                const QCPAxis *keys = panel != nullptr ? panel->axis(QCPAxis::atBottom) : nullptr;
                if (keys != nullptr && keys->label() == tr("Number of centres"))
                    emit countPicked(countAt(keys->pixelToCoord(place.x())));
            });
}

CentresView::LossRange CentresView::lossRange() const
{
    const RbfSelection &selection = *m_data.selection;
    Extent losses;
    LossRange range;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        range.most =
            std::max({range.most, selection.heldOutLoss[axis].size(), selection.trainingLoss[axis].size()});
        for (const auto *ofAxis : {&selection.heldOutLoss[axis], &selection.trainingLoss[axis]}) {
            for (const double value : inPercent(*ofAxis))
                losses.include(value);
        }
        for (const ExcessLevel &level : m_data.levels) {
            if (level.excessPercent[axis] > 0.0)
                losses.include(level.excessPercent[axis]);
        }
    }
    if (losses.empty())
        losses.include(1.0);
    range.highest = losses.high();
    range.lowest = std::max(losses.low(), losses.high() * std::pow(10.0, -kMostDecadesOfLoss));
    return range;
}

void CentresView::drawLosses(QCPAxisRect &rect, std::size_t axis)
{
    const RbfSelection &selection = *m_data.selection;
    const auto training = inPercent(selection.trainingLoss[axis]);
    const auto heldOut = inPercent(selection.heldOutLoss[axis]);
    const double bottom = rect.axis(QCPAxis::atLeft)->range().lower;
    if (!selection.heldOutHighest[axis].empty()) {
        addRange(rect, countsUpTo(heldOut.size()), atLeast(inPercent(selection.heldOutLowest[axis]), bottom),
                 atLeast(inPercent(selection.heldOutHighest[axis]), bottom), look().compensatedRange);
    }
    addVertical(rect, selection.chosen[axis], QPen(look().axisLine, 1.0));
    std::vector<MarginLabel> labels;
    for (const ExcessLevel &level : m_data.levels) {
        const double value = level.excessPercent[axis];
        if (!(value > 0.0))
            continue;
        const QPen pen = rolePen(roleOfModel(level.model), look());
        addHorizontal(rect, value, pen);
        labels.push_back({value, pen, shortModelLabel(level.model), false});
    }
    addLine(rect, countsUpTo(training.size()), training, trainingPen(look()), tr("RBF training"));
    addLine(rect, countsUpTo(heldOut.size()), heldOut, rolePen(Role::Compensated, look()),
            tr("RBF held out"));
    addDots(rect, countsUpTo(heldOut.size()), heldOut, look().compensated, 4.0);
    auto *notes = new PanelNotes(&rect, look());
    notes->setName(QString::fromUtf8(kAxisNames[axis].data()));
    notes->setNote(tr("%1 chosen").arg(selection.chosen[axis]));
    notes->setMarginLabels(std::move(labels));
}

void CentresView::buildLosses()
{
    using Kind = LegendEntry::Kind;
    const RbfSelection &selection = *m_data.selection;
    const bool byRuns = selection.leftOutRuns;
    const std::size_t runs = m_data.runs.size();
    const QString heldOut = !byRuns    ? tr("RBF, temperature blocks left out")
                            : runs > 0 ? tr("RBF held out, mean of %1").arg(runs)
                                       : tr("RBF held out, mean");
    std::vector<LegendEntry> entries{{Kind::Heading, tr("Excess over the noise floor"), QPen(Qt::NoPen), {}},
                                     {Kind::Line, heldOut, rolePen(Role::Compensated, look()), {}}};
    if (!selection.heldOutHighest[0].empty())
        entries.push_back({Kind::Range, byRuns ? tr("lowest to highest run") : tr("lowest to highest block"),
                           QPen(Qt::NoPen), look().compensatedRange});
    entries.push_back({Kind::Line, tr("RBF training"), trainingPen(look()), {}});
    entries.push_back({Kind::Line, tr("Chosen number"), QPen(look().axisLine, 1.0), {}});
    addLegend(std::move(entries));

    const LossRange range = lossRange();
    QCPLayoutGrid &grid = addPanels(true);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        QCPAxis &left = *rect.axis(QCPAxis::atLeft);
        bottom.setTicker(QSharedPointer<QCPAxisTicker>(new CountTicker));
        bottom.setRange(0.0, std::max(1.0, static_cast<double>(range.most) - 1.0));
        bottom.setLabel(tr("Number of centres"));
        applyLogScale(left, range.lowest, range.highest);
        left.setLabel(tr("Excess MSD (%)"));
        if (axis > 0)
            hideAxisText(left);
        drawLosses(rect, static_cast<std::size_t>(axis));
    }
}

} // namespace driftbench
