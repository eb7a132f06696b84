// What every model of the temperature drift error has in common: it maps TCQs to the TDE of three axes.
#pragma once

#include "engine/features/temperature_quantities.h"

#include <Eigen/Core>
#include <concepts>

namespace driftbench {

// M says which TCQs it looks at (a constant per type) and predicts N x 3 dps from N x F raw, not
// standardised, quantities. A model standardises its inputs by itself, with the statistics of its training
// set.
template <class M>
concept TdeModel = requires(const M model, const Eigen::MatrixXd &quantities)
{
    {
        M::kFeatures
        } -> std::convertible_to<FeatureSet>;
    {
        model.predict(quantities)
        } -> std::same_as<Eigen::MatrixX3d>;
};

} // namespace driftbench
