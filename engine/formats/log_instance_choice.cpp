#include "engine/formats/log_instance_choice.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

std::string listed(const std::vector<LogInstance> &instances)
{
    std::string text;
    for (const LogInstance &instance : instances)
        text += (text.empty() ? "" : "; ") + described(instance);
    return text;
}

} // namespace

void note(LogInstance &instance, double timeS, double temperatureC)
{
    if (instance.samples++ == 0)
        instance.startS = timeS;
    instance.durationS = std::max(instance.durationS, timeS - instance.startS);
    if (std::isfinite(temperatureC)) {
        instance.lowestTemperatureC = std::fmin(instance.lowestTemperatureC, temperatureC);
        instance.highestTemperatureC = std::fmax(instance.highestTemperatureC, temperatureC);
    }
}

std::string described(const LogInstance &instance)
{
    std::string text = std::to_string(instance.instance);
    if (!instance.name.empty())
        text += " (" + instance.name + ")";
    text += ": " + std::to_string(instance.samples) + " samples";
    if (instance.durationS > 0.0)
        text += " at " + forReading(instance.meanRateHz(), 1) + " Hz for " +
                forReading(instance.durationS, 1) + " s";
    if (!instance.hasTemperature())
        return text + ", no temperature";
    return text + ", " + forReading(instance.lowestTemperatureC, 1) + " to " +
           forReading(instance.highestTemperatureC, 1) + " °C";
}

Result<LogInstance> chooseInstance(const std::vector<LogInstance> &instances, std::optional<int> wanted,
                                   const std::vector<int> &preferred, const std::string &file)
{
    if (!wanted && preferred.size() == 1)
        wanted = preferred.front();
    if (!wanted) {
        return Error{Errc::NoSuchInstance,
                     file + " holds several gyros, choose one with --instance N: " + listed(instances) + "."};
    }
    const auto found = std::find_if(instances.begin(), instances.end(),
                                    [&](const LogInstance &one) { return one.instance == *wanted; });
    if (found == instances.end()) {
        return Error{Errc::NoSuchInstance, file + " has no gyro number " + std::to_string(*wanted) +
                                               ", choose another with --instance N: " + listed(instances) +
                                               "."};
    }
    if (!found->hasTemperature()) {
        return Error{Errc::MissingColumn, file + " has no temperature for gyro " + std::to_string(*wanted) +
                                              " (" + found->name + "): log the sensor's temperature too."};
    }
    return *found;
}

} // namespace driftbench
