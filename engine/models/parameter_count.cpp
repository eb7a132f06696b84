#include "engine/models/parameter_count.h"

namespace driftbench {

namespace {

struct Counter
{
    int operator()(const ConstantModel &) const { return 3; }
    int operator()(const LinearModel &) const { return 6; }
    int operator()(const PolynomialModel &model) const { return static_cast<int>(model.coefficients.size()); }
    int operator()(const BpNetwork &network) const
    {
        int count = 0;
        for (const BpNetwork::Axis &axis : network.axes)
            count += static_cast<int>(axis.hiddenWeights.size() + axis.hiddenBias.size() +
                                      axis.outputWeights.size()) +
                     1;
        return count;
    }
    int operator()(const RbfNetwork &network) const
    {
        int count = 3 + 2 * static_cast<int>(network.size());
        for (const int used : network.centreCount)
            count += used;
        return network.linearDps.isZero() ? count : count + static_cast<int>(network.linearDps.size());
    }
    // Each axis has its share of the model that it was given.
    int operator()(const PerAxisModel &model) const
    {
        int count = 0;
        for (const auto &axis : model.axes)
            count += parameterCount(axis->model) / 3;
        return count;
    }
};

} // namespace

int parameterCount(const AnyModel &model)
{
    return std::visit(Counter{}, model);
}

} // namespace driftbench
