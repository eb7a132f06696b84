// What the status bar says of the source that runs: its name, the rate that is measured or for how long
// nothing has come, what was dropped; and how much room there is for the session.
#pragma once

#include "app/gui/page.h"
#include "app/gui/sample_silence.h"

#include <QElapsedTimer>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <vector>

namespace driftbench {

class Workbench;

class SourceStatus : public QObject
{
    Q_OBJECT

public:
    explicit SourceStatus(Workbench &bench, QObject *parent = nullptr);

    std::vector<StatusPart> parts() const; // of the source; none if none runs
    StatusPart room() const;               // on the disk of the session
    std::int64_t dropped() const { return m_dropped; }

signals:
    void changed(); // at most four times a second

private:
    void measure();
    std::optional<double> silentForS() const;

    Workbench &m_bench;
    QTimer m_timer;
    QElapsedTimer m_sinceRoom;
    SampleSilence m_silence;
    bool m_away = false; // the source has said that its device is
    std::int64_t m_samples = 0;
    std::int64_t m_dropped = 0;
    double m_rateHz = 0.0;
    double m_lastS = 0.0;     // of the source's own time
    double m_measuredS = 0.0; // where the rate was measured last
    std::int64_t m_measuredSamples = 0;
    qint64 m_freeBytes = -1;
};

} // namespace driftbench
