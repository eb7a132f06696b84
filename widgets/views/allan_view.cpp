#include "widgets/views/allan_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/legend_element.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

// Over more than this the averaging times end where the data end, not at whole decades.
static constexpr double kFreeEndsFrom = 100.0;
static constexpr double kFreeEnd = 1.15;

AllanView::AllanView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Allan deviation before and after compensation"); }, look, parent)
{
    rebuild();
}

void AllanView::setData(AllanData shown)
{
    m_data = std::move(shown);
    rebuild();
}

// What can stand on a logarithmic axis.
static bool drawable(double tauS, double deviationDps)
{
    return std::isfinite(tauS) && tauS > 0.0 && std::isfinite(deviationDps) && deviationDps > 0.0;
}

static void include(const AllanCurve &curve, Extent &tau, Extent &deviation)
{
    for (Eigen::Index i = 0; i < curve.tauS.size(); ++i) {
        for (int axis = 0; axis < kAxisCount; ++axis) {
            if (!drawable(curve.tauS[i], curve.deviationDps(i, axis)))
                continue;
            tau.include(curve.tauS[i]);
            deviation.include(curve.deviationDps(i, axis));
        }
    }
}

// Draws the curve of one axis and gives its lowest deviation, NaN without any.
static double drawCurve(QCPAxisRect &rect, const AllanCurve &curve, int axis, const QPen &pen)
{
    QVector<double> tau, deviation;
    double lowest = NAN;
    for (Eigen::Index i = 0; i < curve.tauS.size(); ++i) {
        const double value = curve.deviationDps(i, axis);
        if (!drawable(curve.tauS[i], value))
            continue;
        tau.append(curve.tauS[i]);
        deviation.append(value);
        lowest = std::fmin(lowest, value);
    }
    addLine(rect, tau, deviation, pen);
    return lowest;
}

void AllanView::build()
{
    Extent tau, deviation;
    include(m_data.before, tau, deviation);
    include(m_data.after, tau, deviation);
    if (tau.empty()) {
        showEmpty(tr("No Allan deviation"), tr("It needs a stretch of nine samples or more without a gap."));
        return;
    }
    const QPen before = rolePen(Role::Raw, look());
    const QPen after = rolePen(Role::Compensated, look());
    addLegend({{LegendEntry::Kind::Line, tr("Before"), before, {}},
               {LegendEntry::Kind::Line, tr("After, %1").arg(m_data.afterText), after, {}}});
    QCPLayoutGrid &grid = addPanels(true);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        QCPAxisRect &rect = addPanel(grid, 0, axis);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        QCPAxis &left = *rect.axis(QCPAxis::atLeft);
        applyLogScale(bottom, tau.low(), tau.high());
        if (tau.high() > kFreeEndsFrom * tau.low())
            bottom.setRange(tau.low() / kFreeEnd, tau.high() * kFreeEnd);
        applyLogScale(left, deviation.low(), deviation.high());
        bottom.setLabel(tr("Averaging time τ (s)"));
        left.setLabel(tr("σ(τ) (dps)"));
        if (axis > 0)
            hideAxisText(left);
        const double lowestBefore = drawCurve(rect, m_data.before, axis, before);
        const double lowestAfter = drawCurve(rect, m_data.after, axis, after);
        auto *notes = new PanelNotes(&rect, look());
        notes->setName(QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()));
        notes->setNote(tr("lowest %1 before, %2 dps after")
                           .arg(deviationText(lowestBefore), deviationText(lowestAfter)));
    }
}

} // namespace driftbench
