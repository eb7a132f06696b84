#include "widgets/views/table_error_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr double kLowestShownMdps = 1e-4;
static constexpr int kDifferencePoints = 241;

TableErrorView::TableErrorView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Worst error of the table in each cell"); }, look, parent)
{
    rebuild();
}

void TableErrorView::setData(std::shared_ptr<const KnotsTableData> shown, double limitMdps)
{
    m_data = std::move(shown);
    m_limitMdps = limitMdps;
    rebuild();
}

static QPen boundPen(const Palette &look)
{
    return rolePen(Role::Constant, look);
}

static double boundMdps(const KnotsTableData &data)
{
    return kMdpsPerDps * (data.table.interpolationErrorBoundDps + data.fixed.errorBoundDps);
}

void TableErrorView::drawAxis(QCPAxisRect &rect, int axis) const
{
    const TableErrors &errors = m_data->errors;
    QVector<double> temperature, error;
    double worst = 0.0;
    for (Eigen::Index cell = 0; cell < errors.fixedPointDps.rows(); ++cell) {
        const double mdps = kMdpsPerDps * errors.fixedPointDps(cell, axis);
        worst = std::max(worst, mdps);
        temperature.append(errors.middleC[cell]);
        error.append(std::max(mdps, kLowestShownMdps));
    }
    addHorizontal(rect, boundMdps(*m_data), boundPen(look()));
    if (std::isfinite(m_limitMdps))
        addHorizontal(rect, m_limitMdps, referencePen(look()));
    const bool compensated = m_data->table.compensated[static_cast<std::size_t>(axis)];
    if (compensated)
        addDots(rect, temperature, error, look().compensated, 2.0, tr("Worst in each cell"));
    auto *notes = new PanelNotes(&rect, look());
    notes->setName(QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()));
    notes->setNote(compensated ? tr("worst %1 mdps").arg(numberText(worst, 2)) : tr("no table"));
}

void TableErrorView::build()
{
    using Kind = LegendEntry::Kind;
    if (!m_data || m_data->errors.fixedPointDps.rows() == 0) {
        showEmpty(tr("No table yet"), tr("Train a model to see what a table of it costs."));
        return;
    }
    std::vector<LegendEntry> entries{
        {Kind::Heading, tr("Table against model"), QPen(Qt::NoPen), {}},
        {Kind::Dot, tr("Worst in each cell"), QPen(Qt::NoPen), look().compensated},
        {Kind::Line, tr("Bound"), boundPen(look()), {}}};
    if (std::isfinite(m_limitMdps))
        entries.push_back({Kind::Line, tr("Limit"), referencePen(look()), {}});
    addLegend(std::move(entries));
    Extent values;
    values.include(boundMdps(*m_data));
    if (std::isfinite(m_limitMdps) && m_limitMdps > 0.0)
        values.include(m_limitMdps);
    for (Eigen::Index cell = 0; cell < m_data->errors.fixedPointDps.rows(); ++cell) {
        const double mdps = kMdpsPerDps * m_data->errors.worstDps(cell);
        if (mdps > kLowestShownMdps)
            values.include(mdps);
    }
    QCPLayoutGrid &grid = addPanels(true);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        QCPAxis &left = *rect.axis(QCPAxis::atLeft);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        applyLogScale(left, std::max(values.low() / 3.0, kLowestShownMdps), values.high() * 1.5);
        left.setLabel(tr("Error (mdps)"));
        if (axis > 0)
            hideAxisText(left);
        Extent temperature;
        temperature.include(m_data->table.firstTemperatureC());
        temperature.include(m_data->table.lastTemperatureC());
        bottom.setRange(temperature.padded(0.03));
        bottom.setLabel(tr("T (°C)"));
        drawAxis(rect, axis);
    }
}

TableDifferenceView::TableDifferenceView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("New table less the one on the device"); }, look, parent)
{
    rebuild();
}

void TableDifferenceView::setData(std::shared_ptr<const CompensationTable> current,
                                  std::shared_ptr<const CompensationTable> fresh)
{
    m_current = std::move(current);
    m_fresh = std::move(fresh);
    rebuild();
}

static QPen axisPen(int axis, const Palette &look)
{
    QPen pen(look.text, 1.0);
    pen.setCapStyle(Qt::FlatCap);
    if (axis == 1)
        pen.setDashPattern({6, 3});
    if (axis == 2)
        pen.setDashPattern({2, 3});
    return pen;
}

void TableDifferenceView::build()
{
    if (!m_current || !m_fresh) {
        showEmpty(tr("Nothing to compare"), tr("No table is on the device."));
        return;
    }
    const double low = std::min(m_current->firstTemperatureC(), m_fresh->firstTemperatureC());
    const double high = std::max(m_current->lastTemperatureC(), m_fresh->lastTemperatureC());
    const Eigen::VectorXd temperatureC = Eigen::VectorXd::LinSpaced(kDifferencePoints, low, high);
    const Eigen::MatrixX3d difference =
        kMdpsPerDps * (tableTde(*m_fresh, temperatureC) - tableTde(*m_current, temperatureC));
    std::vector<LegendEntry> entries;
    Extent values;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        entries.push_back({LegendEntry::Kind::Line,
                           QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()),
                           axisPen(axis, look()),
                           {}});
        for (Eigen::Index i = 0; i < temperatureC.size(); ++i)
            values.include(difference(i, axis));
    }
    addLegend(std::move(entries));
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    rect.axis(QCPAxis::atLeft)->setRange(values.padded());
    rect.axis(QCPAxis::atLeft)->setLabel(tr("New − now (mdps)"));
    rect.axis(QCPAxis::atBottom)->setRange(low, high);
    rect.axis(QCPAxis::atBottom)->setLabel(tr("T (°C)"));
    const QVector<double> keys(temperatureC.data(), temperatureC.data() + temperatureC.size());
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const Eigen::VectorXd column = difference.col(axis);
        addLine(rect, keys, QVector<double>(column.data(), column.data() + column.size()),
                axisPen(axis, look()), QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()));
    }
}

} // namespace driftbench
