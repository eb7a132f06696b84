// How every plot of the workbench looks: 1 px pens, axes left and bottom only, ticks 4 px outward, no
// sub-ticks, solid grid, 9 pt text. Lines are drawn smooth; grid, axes and fills are not.
#pragma once

#include "widgets/style/palette.h"

#include <QPen>
#include <QString>

class QCPAxis;
class QCPAxisRect;
class QCPRange;
class QCustomPlot;

namespace driftbench {

inline constexpr int kPanelGap = 8; // px, right of and above a panel that nothing is written beside

void applyPlotStyle(QCustomPlot &plot, const Palette &palette);
void followLocale(QCustomPlot &plot); // numbers as the user writes them, after the language has changed too
void applyPlotStyle(QCPAxisRect &rect, const Palette &palette); // linear axes with plain numbers

QPen referencePen(const Palette &palette); // dashed: reference, limit, plan
QPen zeroPen(const Palette &palette);      // the zero line of residual plots

// The label of an axis of a column that is not the first: ticks stay, numbers and name go.
void hideAxisText(QCPAxis &axis);

// The unit in which a span of time is best read, and how its axis is named and ticked.
struct TimeScale
{
    double secondsPerUnit = 1.0;
    QString unit; // "s", "min", "h:min"
};
TimeScale timeScaleFor(double spanS);
void applyTimeScale(QCPAxis &axis, const TimeScale &scale, const QString &name);

// Logarithmic with decades only, over whole decades that hold lowest..highest (both > 0).
void applyLogScale(QCPAxis &axis, double lowest, double highest);

// Smallest range that holds the finite ones of what it was shown, with a margin on both sides. Values that
// are all equal, or none, still give a range of some width.
class Extent
{
public:
    void include(double value);
    bool empty() const { return m_low > m_high; }
    double low() const { return m_low; }
    double high() const { return m_high; }
    QCPRange padded(double share = 0.06) const;

private:
    double m_low = 1.0;
    double m_high = -1.0;
};

} // namespace driftbench
