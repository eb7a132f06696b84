#include "widgets/live/msd_trend_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

static constexpr qsizetype kMostPoints = 1200;
static constexpr double kSmallest = 1e-9; // dps^2; a constant signal has none

MsdTrendView::MsdTrendView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("MSD so far"); }, look, parent)
{
    rebuild();
}

void MsdTrendView::clear()
{
    m_timeS.clear();
    for (auto *values : {&m_before, &m_after}) {
        for (QVector<double> &axis : *values)
            axis.clear();
    }
    m_every = 1;
    m_come = 0;
    rebuild();
}

static void halve(QVector<double> &values)
{
    qsizetype kept = 0;
    for (qsizetype i = 0; i < values.size(); i += 2)
        values[kept++] = values[i];
    values.resize(kept);
}

void MsdTrendView::append(double timeS, const Eigen::Vector3d &beforeDps2, const Eigen::Vector3d &afterDps2)
{
    if (m_come++ % m_every != 0)
        return;
    m_timeS.append(timeS);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_before[axis].append(beforeDps2[static_cast<Eigen::Index>(axis)]);
        m_after[axis].append(afterDps2[static_cast<Eigen::Index>(axis)]);
    }
    if (m_timeS.size() < kMostPoints)
        return;
    m_every *= 2;
    halve(m_timeS);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        halve(m_before[axis]);
        halve(m_after[axis]);
    }
}

void MsdTrendView::showTrend()
{
    rebuild();
}

// Lines that end at the same place share a label.
static std::vector<MarginLabel> labelsOf(const std::array<QVector<double>, 3> &values, const QPen &pen,
                                         bool main)
{
    std::vector<MarginLabel> labels;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (values[axis].isEmpty() || !(values[axis].last() > 0.0))
            continue;
        const double value = values[axis].last();
        const QString name = QString::fromUtf8(kAxisNames[axis].data());
        if (!labels.empty() && std::abs(std::log10(value / labels.back().value)) < 0.05)
            labels.back().text += name;
        else
            labels.push_back({value, pen, name, main});
    }
    return labels;
}

void MsdTrendView::build()
{
    double lowest = INFINITY, highest = 0.0;
    for (const auto *values : {&m_before, &m_after}) {
        for (const QVector<double> &axis : *values) {
            for (const double value : axis) {
                if (value > kSmallest) {
                    lowest = std::min(lowest, value);
                    highest = std::max(highest, value);
                }
            }
        }
    }
    if (m_timeS.size() < 2 || highest == 0.0) {
        showEmpty(tr("Nothing yet"), tr("It begins with the recording."));
        return;
    }
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    QCPAxis &keys = *rect.axis(QCPAxis::atBottom);
    keys.setTicker(QSharedPointer<QCPAxisTicker>(new ClockTicker(3)));
    keys.setRange(0.0, std::max(m_timeS.last(), 1.0));
    const bool seconds = ClockTicker::needsSeconds(ClockTicker::stepFor(keys.range().size(), 3));
    keys.setLabel(seconds ? tr("Time since start (h:min:s)") : tr("Time since start (h:min)"));
    applyLogScale(*rect.axis(QCPAxis::atLeft), lowest, highest);
    const QPen before = rolePen(Role::Raw, look());
    const QPen after = rolePen(Role::Compensated, look());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString name = QString::fromUtf8(kAxisNames[axis].data());
        addLine(rect, m_timeS, m_before[axis], before, tr("%1 before").arg(name));
        addLine(rect, m_timeS, m_after[axis], after, tr("%1 after").arg(name));
    }
    auto labels = labelsOf(m_before, before, false);
    const auto main = labelsOf(m_after, after, true);
    labels.insert(labels.end(), main.begin(), main.end());
    (new PanelNotes(&rect, look()))->setMarginLabels(std::move(labels));
}

} // namespace driftbench
