// What stands around the live traces: the part of the run that is not recorded yet, "now", gaps, samples that
// were dropped, events, and names of stretches of the temperature. Drawn from the panels' places at the
// moment of drawing.
#pragma once

#include "widgets/style/palette.h"

#include <QString>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class QCPLayerable;
class QCustomPlot;
class QPointF;

namespace driftbench {

struct LiveGap
{
    double startS = 0.0;
    double endS = 0.0;
    std::int64_t lostSamples = 0; // -1: not known
    QString cause;                // "lost between the device and here"
};

struct LiveEvent
{
    double timeS = 0.0;
    QString sentence;
};

struct LiveHold // a stretch over which the temperature was held
{
    double startS = 0.0;
    double endS = 0.0;
    double temperatureC = 0.0;
};

class LiveMarks
{
public:
    LiveMarks(QCustomPlot *plot, const Palette &look);

    Palette look;
    double nowS = 0.0;
    bool showPending = true;          // what is right of now is still to come
    std::optional<double> planLabelS; // where "plan" is written, and at which temperature
    double planLabelC = 0.0;
    std::vector<LiveGap> gaps;     // ascending
    std::vector<LiveEvent> events; // ascending
    std::vector<LiveHold> holds;   // ascending

    // A long recording over a bad link has many: neighbours become one.
    static constexpr std::size_t kMostMarks = 4000;
    void addGap(const LiveGap &gap);
    void addEvent(const LiveEvent &event);

    // The mark at a place of the plot, in words; empty if there is none.
    QString textAt(const QPointF &place) const;

private:
    class Below;
    class Above;

    QCustomPlot *m_plot;
};

} // namespace driftbench
