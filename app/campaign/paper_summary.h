// What the simulated runs of one of the paper's experiments show: means over the runs, beside what is
// printed.
#pragma once

#include "app/campaign/paper_experiments.h"
#include "engine/evaluation/paper_tables.h"

#include <string>
#include <vector>

namespace driftbench {

struct ModelOnAxis
{
    std::string model;
    double msd = 0.0;             // dps^2
    double excessOverFloor = 0.0; // (msd - floor) / floor, of the means
};

// Means over the runs.
struct AxisSummary
{
    int axis = 0;
    double msdBefore = 0.0;          // dps^2
    double floor = 0.0;              // dps^2
    std::vector<ModelOnAxis> models; // in the order of paperModelNames
};

// One improvement column on one axis, mean over the runs in %.
struct ImprovementSummary
{
    PaperRole role = PaperRole::Novel;
    PaperRole against = PaperRole::Conventional2;
    std::string model; // that plays role
    int axis = 0;
    double printed = 0.0; // recomputed from the printed MSDs
    double simulated = 0.0;
    double standardError = 0.0; // of simulated, from the scatter between the runs
};

struct ExperimentSummary
{
    std::string sensor;
    std::vector<AxisSummary> axes; // that the tables show
    std::vector<ImprovementSummary> improvements;
};

ExperimentSummary summarise(const PaperExperimentOutcome &outcome);

} // namespace driftbench
