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

Eigen::Vector3d PointSamples::varianceAt(Eigen::Index row) const
{
    if (empty())
        return Eigen::Vector3d::Zero();
    return varianceDps2.row(row).cast<double>().transpose();
}

PointSamples PointSamples::rows(const std::vector<Eigen::Index> &kept) const
{
    if (empty())
        return {};
    return {samples(kept), varianceDps2(kept, Eigen::all)};
}

std::int64_t Recording::samples() const
{
    return points.empty() ? size() : points.samples.cast<std::int64_t>().sum();
}

} // namespace driftbench
