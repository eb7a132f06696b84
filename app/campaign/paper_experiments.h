// The paper's two experiments on the simulator: five runs of an L3GD20H at rest (Table 1) and five of an
// I3G4250D on a turning table (Tables 2 to 6). Each run is judged, absolute, by models trained on the other
// four.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/evaluation/paper_tables.h"
#include "engine/evaluation/scoring.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

inline constexpr int kPaperRuns = 5;

struct PaperExperiment
{
    std::string sensor;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    int firstTable = 0; // that shows it
    int lastTable = 0;

    bool shows(int table) const { return table >= firstTable && table <= lastTable; }
};
const std::vector<PaperExperiment> &paperExperiments();

// Which model stands for a role other than Before; Novel is played by the first of kNovelModels, and beside
// it by the others.
inline constexpr std::string_view kConventional1Model = "linear";
inline constexpr std::string_view kConventional2Model = "bpnn";
inline constexpr std::array<std::string_view, 2> kNovelModels{"rbf-paper", "rbf"};
std::vector<std::string> paperModelNames();

struct PaperExperimentOutcome
{
    PaperExperiment experiment;
    std::uint64_t seed = 0;
    std::vector<ComparisonRow> rows; // by run, axis and model
    std::vector<std::string> warnings;

    // In dps^2; run and axis from 0.
    MsdByRole msds(int run, int axis, std::string_view novel) const;
};

// The same seed gives the same figures, whatever the number of threads. Errc: Cancelled if the hook says
// Stop; what the preset, the checks of a run and the comparison report.
Result<PaperExperimentOutcome> runPaperExperiment(const PaperExperiment &experiment, std::uint64_t seed,
                                                  const ProgressHook &hook = {});

} // namespace driftbench
