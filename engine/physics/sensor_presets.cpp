#include "engine/physics/sensor_presets.h"

#include "engine/physics/datasheets.h"

#include <cassert>

namespace driftbench {

namespace {

// What the datasheet does not say.
struct Preset
{
    std::string_view model;
    double noiseDps;
    std::array<double, kAxisCount> restDps;
    std::array<PackageTerm, kAxisCount> packages;
};

constexpr double kBiasInstabilityDps = 0.003;

constexpr std::array<Preset, kSensorNames.size()> kPresets{{
    {"I3G4250D",
     0.1414,
     {110.0, -181.0, 15.0},
     {{{0.08, 45.0, 15.0}, {-0.17, 45.0, 15.0}, {-0.225, 50.0, 12.0}}}},
    {"L3GD20H",
     0.1775,
     {202.45, -203.07, 202.45},
     {{{0.13, 40.0, 15.0}, {-0.13, 40.0, 15.0}, {0.13, 40.0, 15.0}}}},
}};

// Of a model that has a datasheet.
const Preset &presetOf(std::string_view model)
{
    for (const Preset &preset : kPresets) {
        if (preset.model == model)
            return preset;
    }
    assert(false && "a datasheet without a preset");
    return kPresets.front();
}

} // namespace

Result<CombDrift> presetCombDrift(std::string_view model)
{
    const auto datasheet = namedSensor(model);
    if (!datasheet)
        return datasheet.error();
    const Preset &preset = presetOf(datasheet->model);
    CombDrift drift;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        drift.axes[axis].restDps = preset.restDps[axis];
        drift.axes[axis].package = preset.packages[axis];
    }
    return drift;
}

Result<SimulationOptions> presetSimulation(std::string_view model, const Eigen::Vector3d &referenceRateDps)
{
    const auto datasheet = namedSensor(model);
    if (!datasheet)
        return datasheet.error();
    const auto drift = presetCombDrift(model);
    if (!drift)
        return drift.error();
    auto curves = combDriftCurves(*drift, referenceRateDps);
    if (!curves)
        return curves.error();
    auto profile = TemperatureProfile::named("paper");
    if (!profile)
        return profile.error();
    SimulationOptions options{*std::move(profile), *std::move(curves)};
    options.combs = *drift;
    options.sensor.model = datasheet->model;
    options.gyro.referenceRateDps = referenceRateDps;
    options.gyro.sensitivityMdps = datasheet->sensitivityMdps;
    options.gyro.rangeDps = datasheet->rangeDps;
    options.gyro.noiseDps = presetOf(datasheet->model).noiseDps;
    options.gyro.biasInstabilityDps = kBiasInstabilityDps;
    if (const Status ok = checkOptions(options); !ok)
        return ok.error();
    return options;
}

} // namespace driftbench
