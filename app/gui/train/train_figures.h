// What the page Train shows, from the values of the session.
#pragma once

#include "app/session/prepared_campaign.h"
#include "widgets/tables/models_table_model.h"
#include "widgets/views/centres_view.h"

#include <map>
#include <string>

namespace driftbench {

// Of the running training: which models are done, and how far the whole is.
struct TrainingProgress
{
    bool running = false;
    double fraction = 0.0;
    std::map<std::string, double> trainedS; // by model
};

CentresData centresData(const PreparedCampaign &prepared, const CalibrationResult &result);

// result: null where there is none yet; stopped: the last training was cancelled.
ModelsTableData modelsData(const CalibrationPlan &plan, const CalibrationResult *result,
                           const TrainingProgress &progress, bool stopped);

} // namespace driftbench
