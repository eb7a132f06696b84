#include "widgets/views/before_after_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

static constexpr int kColumns = 840;
static constexpr int kRateTicks = 4; // the strips are low
static constexpr int kTemperatureTicks = 3;

BeforeAfterView::BeforeAfterView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Rates before and after compensation"); }, look, parent)
{
    rebuild();
}

void BeforeAfterView::setData(BeforeAfterData shown)
{
    m_data = std::move(shown);
    rebuild();
}

static double rmsAbout(const Eigen::Ref<const Eigen::VectorXd> &values, double reference)
{
    double sum = 0.0;
    Eigen::Index count = 0;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        sum += (value - reference) * (value - reference);
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : NAN;
}

static double lastFinite(const QVector<double> &values)
{
    for (auto value = values.rbegin(); value != values.rend(); ++value) {
        if (std::isfinite(*value))
            return *value;
    }
    return NAN;
}

static QString rmsText(double rmsDps)
{
    return numberText(rmsDps, std::max(2, decimalsForThreeFigures(rmsDps)));
}

static void includeTrace(const Envelope &trace, Extent &extent)
{
    for (qsizetype i = 0; i < trace.key.size(); ++i) {
        extent.include(trace.low[i]);
        extent.include(trace.high[i]);
    }
}

void BeforeAfterView::drawAxis(QCPAxisRect &rect, int axis) const
{
    const double end = m_data.timeS[m_data.timeS.size() - 1];
    const TimeScale scale = timeScaleFor(end - m_data.timeS[0]);
    const Eigen::VectorXd sinceStart = m_data.timeS.array() - m_data.timeS[0];
    const double span = end - m_data.timeS[0];
    const auto before =
        envelope(sinceStart, m_data.beforeDps.col(axis), 0.0, span, kColumns, scale.secondsPerUnit);
    const auto after =
        envelope(sinceStart, m_data.afterDps.col(axis), 0.0, span, kColumns, scale.secondsPerUnit);
    const double reference = m_data.referenceRateDps[axis];
    Extent extent;
    includeTrace(before, extent);
    includeTrace(after, extent);
    extent.include(reference);
    rect.axis(QCPAxis::atLeft)->setRange(extent.padded());
    const QString name = QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
    rect.axis(QCPAxis::atLeft)->setLabel(tr("%1 rate (dps)").arg(name));

    const QPen beforePen = rolePen(Role::Raw, look());
    const QPen afterPen = rolePen(Role::Compensated, look());
    addRange(rect, before.key, before.low, before.high, look().rawRange);
    addRange(rect, after.key, after.low, after.high, look().compensatedRange);
    addHorizontal(rect, reference, referencePen(look()));
    addLine(rect, before.key, before.mean, beforePen);
    addLine(rect, after.key, after.mean, afterPen);
    auto *notes = new PanelNotes(&rect, look());
    notes->setMarginLabels(
        {{lastFinite(before.mean), beforePen,
          tr("%1 dps rms raw").arg(rmsText(rmsAbout(m_data.beforeDps.col(axis), reference))), false},
         {lastFinite(after.mean), afterPen,
          tr("%1 dps rms comp.").arg(rmsText(rmsAbout(m_data.afterDps.col(axis), reference))), true}});
}

void BeforeAfterView::drawTemperature(QCPAxisRect &rect) const
{
    const Eigen::VectorXd sinceStart = m_data.timeS.array() - m_data.timeS[0];
    const double span = sinceStart[sinceStart.size() - 1];
    const auto trace =
        envelope(sinceStart, m_data.temperatureC, 0.0, span, kColumns, timeScaleFor(span).secondsPerUnit);
    Extent extent;
    includeTrace(trace, extent);
    rect.axis(QCPAxis::atLeft)->setRange(extent.padded());
    rect.axis(QCPAxis::atLeft)->setLabel(tr("T (°C)"));
    addLine(rect, trace.key, trace.mean, QPen(look().text, 1.0));
}

void BeforeAfterView::build()
{
    const Eigen::Index count = m_data.timeS.size();
    if (count == 0) {
        showEmpty(tr("Nothing to compare yet"), tr("Train a model and choose a run that it has not seen."));
        return;
    }
    using Kind = LegendEntry::Kind;
    addLegend({{Kind::Range, tr("Raw, mean and range"), rolePen(Role::Raw, look()), look().rawRange},
               {Kind::Range, tr("Compensated, %1").arg(m_data.afterText), rolePen(Role::Compensated, look()),
                look().compensatedRange},
               {Kind::Line, tr("Reference"), referencePen(look()), {}}});
    const double span = m_data.timeS[count - 1] - m_data.timeS[0];
    const TimeScale scale = timeScaleFor(span);
    Extent time;
    time.include(0.0);
    time.include(span / scale.secondsPerUnit);
    const bool hasTemperature = m_data.temperatureC.size() == count;
    const int rows = hasTemperature ? 4 : 3;
    QCPLayoutGrid &grid = addPanels();
    for (int row = 0; row < rows; ++row) {
        QCPAxisRect &rect = addPanel(grid, row, 0);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        bottom.setRange(time.padded(0.0));
        applyTimeScale(bottom, scale, tr("Time since start"));
        if (row + 1 < rows)
            hideAxisText(bottom);
        rect.axis(QCPAxis::atLeft)
            ->setTicker(
                QSharedPointer<QCPAxisTicker>(new NumberTicker(row < 3 ? kRateTicks : kTemperatureTicks)));
        if (row < 3)
            drawAxis(rect, row);
        else
            drawTemperature(rect);
    }
}

} // namespace driftbench
