#include "app/cli/dynamic_experiment_text.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <nlohmann/json.hpp>

namespace driftbench::cli {

std::string dynamicAsText(const std::vector<DynamicOutcome> &outcomes)
{
    std::string text =
        "\nExperiment: rbf with dT/dt and a lag added, MSD on held-out runs in dps^2. Not exported.\n";
    for (const DynamicOutcome &outcome : outcomes) {
        text += "  " + outcome.run + " " + std::string(kAxisNames[static_cast<std::size_t>(outcome.axis)]) +
                "  " + fixed(outcome.msdStatic, 6) + " -> " + fixed(outcome.msdDynamic, 6) + "  (lag " +
                fixed(outcome.lagTimeConstantS, 0) + " s)\n";
    }
    return text;
}

nlohmann::ordered_json dynamicToJson(const std::vector<DynamicOutcome> &outcomes)
{
    auto list = nlohmann::ordered_json::array();
    for (const DynamicOutcome &outcome : outcomes) {
        list.push_back({{"run", outcome.run},
                        {"axis", std::string(kAxisNames[static_cast<std::size_t>(outcome.axis)])},
                        {"msd_static", outcome.msdStatic},
                        {"msd_dynamic", outcome.msdDynamic},
                        {"noise_floor", outcome.noiseFloor},
                        {"lag_time_constant_s", outcome.lagTimeConstantS},
                        {"dps_per_C_per_s", outcome.dpsPerCPerS},
                        {"dps_per_lag_C", outcome.dpsPerLagC}});
    }
    return list;
}

} // namespace driftbench::cli
