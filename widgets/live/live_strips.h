// The four strips of the live view in one plot: rates of x, y, z and the temperature, over one time. Raw and
// compensated as fills from lowest to highest under a line of the mean; the reference and the plan dashed.
// Keys of the axes are seconds. It draws what it is given; live_trace_view.h decides what and when.
#pragma once

#include "widgets/live/trace_pyramid.h"
#include "widgets/live/value_ranges.h"
#include "widgets/style/palette.h"

#include <Eigen/Core>
#include <QStringList>

#include <array>
#include <optional>

class QCPAxis;
class QCPAxisRect;
class QCPGraph;
class QCPItemStraightLine;
class QCPMarginGroup;
class QCustomPlot;

namespace driftbench {

class PanelNotes;
class RangeGraph;

struct PlanLine
{
    QVector<double> timeS;
    QVector<double> setpointC;
};

class LiveStrips
{
public:
    static constexpr int kStrips = 4;

    LiveStrips(QCustomPlot &plot, const Palette &look);

    void build(const Palette &look, const QStringList &valueTitles); // again after a change of look
    void setValueTitles(const QStringList &titles);                  // of x, y, z, T
    void setKeyTitle(const QString &hours, const QString &seconds); // "Time since start (h:min)", "(h:min:s)"

    QCPAxis &keys() const;
    QCPAxisRect &panel(int strip) const { return *m_strips[static_cast<std::size_t>(strip)].panel; }
    int columns() const; // px of a strip's width

    void showData(const TracePyramid::Envelopes &data, const Eigen::Vector3d &shiftDps, bool compensated);
    void showReference(const std::optional<Eigen::Vector3d> &rateDps); // as shown
    void showPlan(const PlanLine &plan);
    void showValueRanges(const std::array<ValueRange, 3> &rates, const ValueRange &temperature);
    // The latest means at the right end; nothing: no tags. compensatedMain: of two, that one is the main
    // series.
    void showTags(const std::optional<std::array<double, TracePyramid::kTraces>> &values, bool compensated);
    void updateTickers(); // to the strips' heights and the span

private:
    struct Strip
    {
        QCPAxisRect *panel = nullptr;
        RangeGraph *rawBand = nullptr;
        RangeGraph *compensatedBand = nullptr;
        QCPItemStraightLine *reference = nullptr;
        QCPGraph *plan = nullptr;
        QCPGraph *raw = nullptr;
        QCPGraph *compensated = nullptr;
        PanelNotes *notes = nullptr;
    };

    void buildStrip(int strip, QCPMarginGroup *margins);
    void addSeries(Strip &strip, bool temperature);

    QCustomPlot &m_plot;
    Palette m_look;
    std::array<Strip, kStrips> m_strips;
    QString m_hoursTitle, m_secondsTitle;
    QCPMarginGroup *m_margins = nullptr;
};

} // namespace driftbench
