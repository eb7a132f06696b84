// What the Inspect page shows of a prepared campaign, made off the window's thread: few enough dots to draw,
// a curve of temperature with what it leaves, figures, coverage, and what is excluded. Also of runs that are
// refused, as far as they have samples.
#pragma once

#include "app/session/job.h"
#include "app/session/prepared_campaign.h"
#include "engine/evaluation/campaign_inspection.h"
#include "engine/models/trained_model.h"
#include "widgets/views/model_curve.h"
#include "widgets/views/tcq_density.h"
#include "widgets/views/tcq_time_view.h"

#include <Eigen/Core>
#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// The runs lie one after the other in the strip of time.
struct InspectedRun
{
    RunId id = 0;
    std::string name;
    double firstS = 0.0; // in the run's time
    double lastS = 0.0;
    double stripStartS = 0.0;
    bool heating = false; // parts of it
    bool cooling = false;
    std::shared_ptr<const RunFeatures> dots; // thinned

    double toStrip(double timeS) const { return stripStartS + timeS - firstS; }
    double toRun(double stripS) const { return firstS + stripS - stripStartS; }
    double stripEndS() const { return toStrip(lastS); }
};

struct ExcludedStretch
{
    std::size_t run = 0;
    double startS = 0.0; // in the run's time
    double endS = 0.0;
    std::int64_t samples = 0;
    std::string why;
    std::optional<std::size_t> own; // of the plan's exclusions of this run
    bool everywhere = false;        // single samples all over the run
};

struct ExcludedDots
{
    std::vector<std::size_t> run;
    Eigen::VectorXd timeS; // in the run's time
    Eigen::VectorXd deltaT;
    Eigen::MatrixX3d tdeDps;
};

struct InspectionData
{
    std::shared_ptr<const PreparedCampaign> prepared;
    std::vector<InspectedRun> runs;
    double stripSpanS = 0.0;
    double referenceTemperatureC = 0.0;
    bool simulated = false;
    std::optional<ModelCurve> curve;              // nothing where none can be fitted
    std::optional<CampaignInspection> inspection; // likewise
    std::shared_ptr<const TcqDensity> density;    // of all samples, where dots would be a blot
    ExcludedDots excludedDots;
    std::vector<ExcludedStretch> excluded;
    std::int64_t samples = 0;
    std::int64_t excludedSamples = 0;
    double sampleRateHz = 0.0;
    int samplesAPoint = 1; // more where a run is long: what is drawn are means of so many (block_means.h)
    TcqTimeTraces overTime;
};

inline constexpr Eigen::Index kInspectedDots = 8000; // of all runs together

// model: the session's, if it has one; else a curve is fitted. Cancelled if the hook says Stop.
Result<InspectionData> inspect(const std::shared_ptr<const PreparedCampaign> &prepared,
                               const std::shared_ptr<const TrainedModel> &model,
                               const ProgressHook &hook = {});

class InspectionJob final : public Job
{
    Q_OBJECT

public:
    explicit InspectionJob(QObject *parent = nullptr) : Job(parent) {}
    ~InspectionJob() override { cancelAndWait(); }

    bool start(std::shared_ptr<const PreparedCampaign> prepared, std::shared_ptr<const TrainedModel> model);

signals:
    void finished(const std::shared_ptr<const driftbench::InspectionData> &seen); // null: cancelled
};

} // namespace driftbench
