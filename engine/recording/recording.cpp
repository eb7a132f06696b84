#include "engine/recording/recording.h"

namespace driftbench {

namespace {

bool differ(const std::string &a, const std::string &b)
{
    return !a.empty() && !b.empty() && a != b;
}

} // namespace

bool SensorIdentity::contradicts(const SensorIdentity &other) const
{
    return differ(model, other.model) || differ(serial, other.serial);
}

std::string SensorIdentity::text() const
{
    if (!known())
        return "unknown sensor";
    if (model.empty() || serial.empty())
        return model + serial;
    return model + ' ' + serial;
}

} // namespace driftbench
