// When samples are overdue, by the clock on the wall: after 1.5 s, for a slow source after four times the
// longest pause that it has made so far.
#pragma once

#include <QElapsedTimer>

#include <optional>

namespace driftbench {

class SampleSilence
{
public:
    void start(); // of a source; nothing is overdue before its first samples
    void
    came(bool afterAbsence); // samples; a pause in which the device was away says nothing of the next ones
    double sinceS() const;   // since the last ones
    std::optional<double> overdueForS() const; // sinceS() once it is too long

private:
    QElapsedTimer m_since;
    qint64 m_usualPauseMs = 0; // between samples, at most
    bool m_any = false;
};

} // namespace driftbench
