// The run that is being recorded, as the Record page shows it: it listens to the acquisition, applies the
// session's model, keeps the score, and hands the samples on to the live view. Its time is the run's: 0 at
// the first recorded sample.
#pragma once

#include "app/gui/record/run_progress.h"
#include "app/gui/sample_silence.h"
#include "app/session/session_records.h"
#include "device/sample_source.h"
#include "engine/evaluation/running_score.h"
#include "engine/models/trained_model.h"
#include "engine/recording/hold_detector.h"
#include "engine/recording/sample_block.h"

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QObject>

#include <memory>
#include <optional>

namespace driftbench {

class LiveTraceView;
class Workbench;

struct LinkFigures
{
    std::int64_t samples = 0;
    std::int64_t lost = 0; // counted ones
    std::int64_t overruns = 0;
    std::int64_t saturated = 0; // samples at the end of the range
    double rateHz = 0.0;        // measured; 0: not known yet
    std::optional<double> lastGapS;
};

class LiveRun : public QObject
{
    Q_OBJECT

public:
    LiveRun(Workbench &workbench, LiveTraceView &view, QObject *parent = nullptr);

    bool isRecording() const { return m_recording; }
    bool hasSamples() const { return m_samples > 0; } // also of a run that is over
    std::optional<RunId> run() const { return m_run; }
    // The model that is applied; null: none.
    const std::shared_ptr<const TrainedModel> &model() const { return m_model; }
    const Eigen::Vector3d &referenceRateDps() const { return m_referenceDps; }

    double elapsedS() const { return m_elapsedS; }
    std::optional<RunProgress> progress() const { return m_plan.at(m_elapsedS); }
    std::optional<double> temperatureC() const; // mean of the last second
    const RunningScores &scores() const { return m_scores; }
    const LinkFigures &link() const { return m_link; }
    bool isHolding() const { return m_holds.isHolding(); }
    // Since when the device is away; nothing while samples come.
    std::optional<double> unpluggedAtS() const { return m_unpluggedAtS; }
    std::optional<double> silentForS() const; // samples are overdue for so long, by the clock on the wall

    void followSession(); // plan, reference and model as they are in the session now

signals:
    void recordingChanged();
    void planEnded(); // once: the run is as long as the plan
    void deviceAway();
    void deviceBack();
    void scored(); // about every quarter second of the clock on the wall

private:
    void connectAcquisition();
    void begin(RunId run);
    void end();
    void take(const SampleBlock &block);
    void takeGap(const SampleGap &gap);
    void takeEvent(const QString &sentence);
    void apply(const SampleBlock &block);
    void countSaturated(const SampleBlock &block);
    std::shared_ptr<const TrainedModel> modelOfSession() const;
    Eigen::Vector3d referenceOfSource() const;
    void noteReference();

    Workbench &m_workbench;
    LiveTraceView &m_view;
    bool m_recording = false;
    std::optional<RunId> m_run;
    std::shared_ptr<const TrainedModel> m_model;
    // The session's latest: a run that is begun is a change of the session's runs, and drops its result.
    std::shared_ptr<const TrainedModel> m_latestModel;
    Eigen::Vector3d m_referenceDps = Eigen::Vector3d::Zero();
    PlanProgress m_plan;
    std::optional<double> m_firstS; // in the source's time
    double m_elapsedS = 0.0;
    std::int64_t m_samples = 0;
    RunningScores m_scores;
    HoldDetector m_holds;
    LinkFigures m_link;
    double m_rangeDps = 0.0;
    bool m_planEnded = false;
    std::optional<double> m_unpluggedAtS;
    SampleSilence m_silence;
    QElapsedTimer m_sinceScored;
};

} // namespace driftbench
