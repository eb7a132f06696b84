#include "widgets/views/rbf_centres.h"

namespace driftbench {

static constexpr double kLargestWidthC = 1000.0;
static constexpr int kBisections = 60;

static double sigmaOfWidth(const RbfNetwork &network, double deltaT, double width)
{
    const Eigen::RowVector3d apart =
        (temperatureQuantities(deltaT + width) - temperatureQuantities(deltaT - width)).transpose();
    return 0.5 * (apart.array() / network.inputs.scale.array()).matrix().norm();
}

std::vector<RbfCentre> rbfCentres(const RbfNetwork &network)
{
    std::vector<RbfCentre> centres;
    for (Eigen::Index k = 0; k < network.size(); ++k) {
        const double deltaT = network.centres(k, 0) * network.inputs.scale[0] + network.inputs.mean[0];
        double low = 0.0;
        double high = kLargestWidthC;
        for (int i = 0; i < kBisections; ++i) {
            const double middle = 0.5 * (low + high);
            (sigmaOfWidth(network, deltaT, middle) < network.widths[k] ? low : high) = middle;
        }
        centres.push_back({deltaT, 0.5 * (low + high)});
    }
    return centres;
}

} // namespace driftbench
