// As many ticks as an axis has room for: where labels would touch, the steps become larger. Axes with decades
// or with texts of their own are left as they are.
#pragma once

#include <map>

class QCPAxis;
class QCPAxisRect;
class QCustomPlot;

namespace driftbench {

class TickRoom
{
public:
    // Call when the axes are new.
    void forget() { m_wanted.clear(); }

    // Call when the layout is known (QCustomPlot::afterLayout); lays out anew if a step changed.
    void fit(QCustomPlot &plot);

private:
    bool fitAxis(QCPAxisRect &rect, QCPAxis &axis);

    std::map<const QCPAxis *, int> m_wanted; // ticks, as the axis was made
};

} // namespace driftbench
