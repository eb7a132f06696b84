// From the runs of a session to judged models, off the thread that owns it: reads what is not in memory,
// checks the runs, trains and compares. A cancel while models are trained keeps those that are finished.
//
//   connect(&job, &TrainingJob::prepared, &session, &Session::setPrepared) and so on
//   job.start(session.trainingInput());
#pragma once

#include "app/session/job.h"
#include "app/session/prepared_campaign.h"

#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

struct TrainingInput
{
    CalibrationPlan plan;
    std::vector<LoadedRun> known;        // runs that are in memory
    std::shared_ptr<SessionFile> file{}; // a connection of its own for the others; null: there are none
    std::shared_ptr<const PreparedCampaign> prepared{}; // if the plan has been prepared already
    bool train = true;                                  // else it ends with the prepared campaign
};

class TrainingJob final : public Job
{
    Q_OBJECT

public:
    explicit TrainingJob(QObject *parent = nullptr) : Job(parent) {}
    ~TrainingJob() override { cancelAndWait(); }

    bool start(TrainingInput input); // false: it is still running

signals:
    // What was made of the runs, also where they are refused; not for one that was given.
    void prepared(const std::shared_ptr<const driftbench::PreparedCampaign> &campaign);
    void modelTrained(const QString &name, double seconds);
    // Of a start with train. Errors: of reading, the refusal, those of compareModels, Cancelled.
    void trained(const driftbench::Result<std::shared_ptr<const driftbench::CalibrationResult>> &outcome);
    void failed(const driftbench::Error &error); // before anything was prepared
};

} // namespace driftbench
