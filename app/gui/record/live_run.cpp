#include "app/gui/record/live_run.h"

#include "app/gui/workbench.h"
#include "widgets/live/live_trace_view.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr qint64 kScoreEveryMs = 250;
static constexpr double kAtTheEnd = 0.999; // of the range: such a sample is saturated

LiveRun::LiveRun(Workbench &workbench, LiveTraceView &view, QObject *parent)
    : QObject(parent), m_workbench(workbench), m_view(view)
{
    connectAcquisition();
    connect(&workbench, &Workbench::sessionReplaced, this, [this] {
        m_view.clear();
        m_latestModel.reset();
        m_run.reset();
        m_samples = 0;
        followSession();
        emit recordingChanged();
    });
    connect(&workbench, &Workbench::testPlanChanged, this, &LiveRun::followSession);
    connect(&workbench, &Workbench::resultChanged, this, &LiveRun::followSession);
    connect(&workbench, &Workbench::exportChoiceChanged, this, &LiveRun::followSession);
    connect(&workbench, &Workbench::sourceChanged, this, &LiveRun::followSession);
    followSession();
}

void LiveRun::connectAcquisition()
{
    const Acquisition &acquisition = m_workbench.acquisition();
    connect(&acquisition, &Acquisition::recordingStarted, this, &LiveRun::begin);
    connect(&acquisition, &Acquisition::recordingFinished, this, &LiveRun::end);
    connect(&acquisition, &Acquisition::batch, this,
            [this](const std::shared_ptr<const SampleBlock> &samples) { take(*samples); });
    connect(&acquisition, &Acquisition::gap, this, &LiveRun::takeGap);
    connect(&acquisition, &Acquisition::sourceSaid, this, &LiveRun::takeEvent);
}

std::shared_ptr<const TrainedModel> LiveRun::modelOfSession() const
{
    const auto &result = m_workbench.session().result();
    if (!result)
        return nullptr;
    const TrainedModel *chosen = m_workbench.session().chosenModel();
    if (!chosen)
        chosen = result->model("auto");
    return chosen ? std::make_shared<const TrainedModel>(*chosen) : nullptr;
}

// What the rate table does: the simulation knows, of a real one the run before this is the best guess.
Eigen::Vector3d LiveRun::referenceOfSource() const
{
    const auto &choice = m_workbench.sourceChoice();
    if (choice) {
        if (const auto *simulated = choice->as<SimulatedChoice>())
            return simulated->referenceRateDps;
    }
    const auto &runs = m_workbench.session().plan().runs;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
        if (run->run != m_run)
            return run->referenceRateDps;
    }
    return Eigen::Vector3d::Zero();
}

// The run is in the plan already, with no rate.
void LiveRun::noteReference()
{
    Session &session = m_workbench.session();
    CalibrationPlan plan = session.plan();
    RunInPlan *run = plan.find(*m_run);
    if (!run || run->referenceRateDps == m_referenceDps)
        return;
    run->referenceRateDps = m_referenceDps;
    const Status noted = session.editPlan(plan, tr("set the reference rate of the run that is recorded"));
    if (!noted.ok())
        m_view.addEvent(0.0, QString::fromStdString(noted.error().message));
}

void LiveRun::followSession()
{
    const auto &plan = m_workbench.session().testPlan();
    m_plan = plan ? PlanProgress(*plan) : PlanProgress();
    m_view.setPlan(m_plan.profile());
    if (m_recording)
        return; // what a run was begun with stays
    if (auto model = modelOfSession())
        m_latestModel = std::move(model);
    const auto &info = m_workbench.acquisition().info();
    m_model = info && info->compensated ? nullptr : m_latestModel; // once is enough
    m_referenceDps = referenceOfSource();
    if (m_samples == 0) {
        m_view.setCompensated(m_model != nullptr);
        m_view.setReference(m_referenceDps);
    }
}

void LiveRun::begin(RunId run)
{
    m_view.clear();
    m_samples = 0;
    m_elapsedS = 0.0;
    m_firstS.reset();
    m_scores = RunningScores();
    m_holds = HoldDetector();
    m_link = LinkFigures();
    m_planEnded = false;
    m_unpluggedAtS.reset();
    m_run = run;
    followSession();
    m_recording = true;
    noteReference();
    m_view.setCompensated(m_model != nullptr);
    m_view.setReference(m_referenceDps);
    const auto &info = m_workbench.acquisition().info();
    m_rangeDps = info ? info->rangeDps : 0.0;
    m_silence.start();
    m_sinceScored.start();
    emit recordingChanged();
}

void LiveRun::end()
{
    if (!m_recording)
        return;
    m_recording = false;
    m_unpluggedAtS.reset();
    m_view.setFinished(true);
    emit recordingChanged();
}

void LiveRun::take(const SampleBlock &block)
{
    if (!m_recording || block.size() == 0)
        return;
    // What came before the recorder was there is in the same batch.
    const auto startS = m_workbench.acquisition().recordedFromS();
    if (!startS || block.timeS[block.size() - 1] < *startS)
        return;
    m_firstS = startS;
    Eigen::Index first = 0;
    while (block.timeS[first] < *startS)
        ++first;
    const Eigen::Index rows = block.size() - first;
    SampleBlock ofRun{block.firstSample + first, block.timeS.tail(rows).array() - *startS,
                      block.temperatureC.tail(rows), block.rateDps.bottomRows(rows)};
    m_silence.came(m_unpluggedAtS.has_value());
    if (m_unpluggedAtS) {
        m_unpluggedAtS.reset();
        emit deviceBack();
    }
    apply(ofRun);
}

void LiveRun::apply(const SampleBlock &block)
{
    const Eigen::Index rows = block.size();
    m_samples += rows;
    m_link.samples = m_samples;
    m_elapsedS = block.timeS[rows - 1];
    countSaturated(block);
    const Eigen::MatrixX3d before = block.rateDps.rowwise() - m_referenceDps.transpose();
    m_scores.before.add(block.timeS, before);
    Eigen::MatrixX3d compensated(0, 3);
    if (m_model) {
        const Eigen::MatrixX3d tdeDps = predictAtTemperature(*m_model, block.temperatureC).tdeDps;
        compensated = block.rateDps - tdeDps;
        m_scores.after.add(block.timeS, before - tdeDps);
    }
    m_view.append(block, compensated);
    const bool held = m_holds.isHolding();
    const std::size_t ended = m_holds.holds().size();
    m_holds.add(block.timeS, block.temperatureC);
    const bool scoring = m_sinceScored.elapsed() >= kScoreEveryMs;
    if (scoring || m_holds.isHolding() != held || m_holds.holds().size() != ended) {
        std::vector<LiveHold> shown;
        for (const TemperatureHold &hold : m_holds.holds())
            shown.push_back({hold.startS, hold.endS, hold.meanC});
        m_view.setHolds(std::move(shown));
    }
    const double intervalS = m_view.traces().intervalS();
    m_link.rateHz = intervalS > 0.0 ? 1.0 / intervalS : 0.0;
    if (scoring) {
        m_sinceScored.start();
        emit scored();
    }
    const auto where = progress();
    if (where && where->ended && !m_planEnded) {
        m_planEnded = true;
        emit planEnded();
    }
}

void LiveRun::countSaturated(const SampleBlock &block)
{
    if (m_rangeDps > 0.0)
        m_link.saturated += (block.rateDps.array().abs() >= kAtTheEnd * m_rangeDps).rowwise().any().count();
}

void LiveRun::takeGap(const SampleGap &gap)
{
    if (!m_recording || !m_firstS || gap.endS < *m_firstS)
        return;
    const QString cause = QString::fromStdString(std::string(gapCauseText(gap.cause)));
    m_view.addGap({gap.startS - *m_firstS, gap.endS - *m_firstS, gap.lostSamples, cause});
    m_link.lost += std::max<std::int64_t>(gap.lostSamples, 0);
    if (gap.cause == GapCause::DeviceOverrun)
        ++m_link.overruns;
    m_link.lastGapS = gap.startS - *m_firstS;
}

void LiveRun::takeEvent(const QString &sentence)
{
    if (!m_recording)
        return;
    m_view.addEvent(m_elapsedS, sentence);
    // Sources say it in words only; the gap that carries the cause comes when the device is back.
    if (sentence.contains(QLatin1String("was unplugged")) && !m_unpluggedAtS) {
        m_unpluggedAtS = m_elapsedS;
        emit deviceAway();
    }
}

std::optional<double> LiveRun::temperatureC() const
{
    const auto means = m_view.traces().means(m_elapsedS - 1.0, m_elapsedS);
    return means ? std::optional((*means)[TracePyramid::kTemperature]) : std::nullopt;
}

std::optional<double> LiveRun::silentForS() const
{
    return m_recording ? m_silence.overdueForS() : std::nullopt;
}

} // namespace driftbench
