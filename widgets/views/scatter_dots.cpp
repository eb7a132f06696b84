#include "widgets/views/scatter_dots.h"

#include "widgets/plot/decimation.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

ScatterDots scatterDots(const std::vector<std::shared_ptr<const RunFeatures>> &runs,
                        const std::vector<Eigen::VectorXd> &valuesDps, Eigen::Index most)
{
    Eigen::Index total = 0;
    for (const auto &run : runs)
        total += run->deltaT.size();
    ScatterDots dots;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const RunFeatures &run = *runs[r];
        const Eigen::Index count = run.deltaT.size();
        const auto heating = heatingFlags(run.timeS, run.deltaT);
        // Each run gets dots by its share of the samples, so that all runs are thinned alike.
        const Eigen::Index share = total > most ? std::max<Eigen::Index>(1, most * count / total) : count;
        for (const Eigen::Index i : thinned(count, share)) {
            const auto sample = static_cast<std::size_t>(i);
            const double value = valuesDps[r][i];
            if (!std::isfinite(value) || !std::isfinite(run.deltaT[i]))
                continue;
            const bool usable = sample >= run.usableForTraining.size() || run.usableForTraining[sample] != 0;
            ScatterDots::Group &group =
                usable ? (heating[sample] != 0 ? dots.heating : dots.cooling) : dots.excluded;
            group.deltaT.append(run.deltaT[i]);
            group.valueDps.append(value);
        }
    }
    return dots;
}

} // namespace driftbench
