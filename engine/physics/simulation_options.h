// What a simulated run is made of. Every figure is an option; the defaults are those of a gyro like the
// I3G4250D in the paper's chamber. sensor_presets.h has those of a certain gyro.
#pragma once

#include "engine/base/result.h"
#include "engine/physics/comb_drift.h"
#include "engine/physics/drift_curves.h"
#include "engine/physics/temperature_profile.h"
#include "engine/recording/recording.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace driftbench {

struct ChamberOptions
{
    double lagS = 20.0;                    // of the air behind the set-point, first order
    double deadTimeS = 0.0;                // until a new set-point begins to reach the air
    double thermometerNoiseC = 0.01;       // standard deviation; an accuracy of +-0.03 C is three of it
    double thermometerCountsPerC = 1000.0; // resolution of the logged temperature; 1: stairs of 1 C; 0: none
};

struct GyroOptions
{
    double sampleRateHz = 10.0;
    Eigen::Vector3d referenceRateDps = Eigen::Vector3d::Zero();
    double noiseDps = 0.14;                 // standard deviation of the white noise of each sample and axis
    double biasInstabilityDps = 0.0;        // coefficient B of the flicker noise; flicker_noise.h
    double rateRandomWalkDpsPerRootS = 0.0; // coefficient K; rate_random_walk.h
    double spread = 0.002;         // relative standard deviation of a run's curve; see drift_curves.h
    double turnOnBiasDps = 0.0;    // standard deviation of a run's constant bias
    double packageLagS = 0.0;      // of the die behind the air at the thermometer, first order
    double hysteresisDps = 0.0;    // heating branch minus cooling branch, the curve lies half-way
    double hysteresisPlayC = 5.0;  // half the way back after which the other branch is reached
    double sensitivityMdps = 8.75; // of one count; 0: not quantised
    double rangeDps = 245.0;       // the rate saturates at +- this
};

struct FaultOptions
{
    int biasSteps = 0;
    double biasStepDps = 0.5; // size; a step's axes differ by up to half of it
    int motionBursts = 0;
    double motionDps = 20.0; // peak
    double motionS = 20.0;   // length of a burst
    int gaps = 0;
    double gapS = 5.0;            // length of a gap; its samples are lost
    double outlierFraction = 0.0; // of the samples, on all axes at once
    double outlierDps = 3.0;
    double nonFiniteFraction = 0.0; // of the samples: the rates are NaN
};

struct SimulationOptions
{
    TemperatureProfile profile;
    DriftCurves truth;
    ChamberOptions chamber{};
    GyroOptions gyro{};
    FaultOptions faults{};
    SensorIdentity sensor{"I3G4250D", "SIM-0001"};
    std::uint64_t seed = 1;
    std::optional<CombDrift> combs{}; // what truth was made from, if it was combs: for the record
};

// Errc::InvalidOption with the first option that can't be, what it is and what it must be.
Status checkOptions(const SimulationOptions &options);

} // namespace driftbench
