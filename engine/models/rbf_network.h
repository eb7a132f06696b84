// The paper's novel model (MSD6, Eqs. 29-30): a Gaussian radial basis function network on the three TCQs,
//   tde_a = b_a + z . l_a + sum_j w_ja exp(-|z - c_j|^2 / (2 sigma_j^2))       z: standardised [dT, dT^2,
//   dT^(1/2)]
// The centres are shared by the axes; an axis that uses fewer has zero weights beyond its number. The preset
// `paper` has no linear term l (Gaussian + purelin exactly as Eq. 29).
#pragma once

#include "engine/features/temperature_quantities.h"
#include "engine/models/model_concept.h"
#include "engine/models/standardiser.h"

#include <array>

namespace driftbench {

struct RbfNetwork
{
    static constexpr FeatureSet kFeatures = FeatureSet::DeltaTSquaredRoot;

    Standardiser inputs;                                 // of 3 columns
    Eigen::MatrixX3d centres;                            // K x 3, standardised
    Eigen::VectorXd widths;                              // K, sigma in standardised units
    Eigen::MatrixX3d weightsDps;                         // K x 3 axes
    Eigen::Matrix3d linearDps = Eigen::Matrix3d::Zero(); // row: TCQ, column: axis
    Eigen::Vector3d biasDps = Eigen::Vector3d::Zero();
    std::array<int, 3> centreCount{}; // used by each axis: its weights are zero from there on

    Eigen::Index size() const { return widths.size(); }
    Eigen::MatrixX3d predict(const Eigen::MatrixXd &quantities) const; // N x 3
};

} // namespace driftbench
