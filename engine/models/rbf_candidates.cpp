#include "engine/models/rbf_candidates.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kFewestSamples = 50.0;
constexpr int kPaperCentres = 65;

class Support
{
public:
    explicit Support(const ThermalRows &rows) : m_rows(rows) {}

    // Whether the data around d can tell what a Gaussian of that width should do.
    bool carries(double d, double width) const
    {
        return largestHole(d - 2.0 * width, d + 2.0 * width) <= width &&
               samplesWithin(d - width, d + width) >= kFewestSamples;
    }

private:
    double largestHole(double from, double to) const
    {
        const auto deltaT = m_rows.deltaT();
        const double low = std::max(from, deltaT[0]);
        const double high = std::min(to, deltaT[deltaT.size() - 1]);
        double previous = low;
        double hole = 0.0;
        for (Eigen::Index i = 0; i < deltaT.size() && deltaT[i] <= high; ++i) {
            if (deltaT[i] < low)
                continue;
            hole = std::max(hole, deltaT[i] - previous);
            previous = deltaT[i];
        }
        return std::max(hole, high - previous);
    }

    double samplesWithin(double from, double to) const
    {
        const auto deltaT = m_rows.deltaT();
        return ((deltaT.array() >= from) && (deltaT.array() <= to)).select(m_rows.count.array(), 0.0).sum();
    }

    const ThermalRows &m_rows;
};

Eigen::RowVector3d standardised(const Standardiser &inputs, double deltaT)
{
    return inputs.transform(temperatureQuantities(deltaT).transpose());
}

// The half width in degrees whose image in TCQ space is sigma, by bisection: the distance grows with w.
double widthInDegrees(const Standardiser &inputs, double d, double sigma, double span)
{
    double low = 0.0;
    double high = 4.0 * span;
    for (int i = 0; i < 60; ++i) {
        const double w = 0.5 * (low + high);
        const double distance = 0.5 * (standardised(inputs, d + w) - standardised(inputs, d - w)).norm();
        (distance < sigma ? low : high) = w;
    }
    return 0.5 * (low + high);
}

class Collector
{
public:
    Collector(const ThermalRows &rows, const Standardiser &inputs) : m_support(rows), m_inputs(inputs) {}

    void offer(double d, double width, double sigma)
    {
        if (!m_support.carries(d, width) || !(sigma > 0.0))
            return;
        m_centres.push_back(standardised(m_inputs, d));
        m_sigmas.push_back(sigma);
        m_result.centreDeltaT.push_back(d);
        m_result.widthDeltaT.push_back(width);
    }

    RbfCandidates take()
    {
        const auto count = static_cast<Eigen::Index>(m_centres.size());
        m_result.centres.resize(count, 3);
        for (Eigen::Index i = 0; i < count; ++i)
            m_result.centres.row(i) = m_centres[static_cast<std::size_t>(i)];
        m_result.widths = Eigen::Map<const Eigen::VectorXd>(m_sigmas.data(), count);
        return std::move(m_result);
    }

private:
    Support m_support;
    const Standardiser &m_inputs;
    std::vector<Eigen::RowVector3d> m_centres;
    std::vector<double> m_sigmas;
    RbfCandidates m_result;
};

} // namespace

RbfCandidates rbfCandidates(const ThermalRows &rows, const Standardiser &inputs,
                            const RbfPathOptions &options)
{
    const double low = rows.deltaT()[0];
    const double span = rows.deltaT()[rows.size() - 1] - low;
    Collector collector(rows, inputs);
    if (!(span > 0.0))
        return collector.take();
    if (options.standardisedWidth > 0.0) {
        for (int i = 0; i < kPaperCentres; ++i) {
            const double d = low + span * i / (kPaperCentres - 1);
            const double sigma = options.standardisedWidth;
            collector.offer(d, widthInDegrees(inputs, d, sigma, span), sigma);
        }
        return collector.take();
    }
    for (int level = 0; level < options.levels; ++level) {
        const int halves = 2 << level;
        const double width = 2.0 * span / halves;
        for (int i = 0; i <= halves; ++i) {
            const double d = low + span * i / halves;
            const double sigma =
                0.5 * (standardised(inputs, d + width) - standardised(inputs, d - width)).norm();
            collector.offer(d, width, sigma);
        }
    }
    return collector.take();
}

} // namespace driftbench
