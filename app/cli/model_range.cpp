#include "app/cli/model_range.h"

#include "engine/base/text.h"

#include <algorithm>

namespace driftbench::cli {

namespace {

constexpr double kThermometerNoiseC = 0.5;

} // namespace

void ModelRange::add(const Eigen::VectorXd &temperatureC)
{
    for (const double t : temperatureC) {
        if (!std::isfinite(t))
            continue;
        ++m_samples;
        m_outside += t < m_trained[0] || t > m_trained[1] ? 1 : 0;
        m_lowestC = std::min(m_lowestC, t);
        m_highestC = std::max(m_highestC, t);
    }
}

bool ModelRange::reachesBeyond() const
{
    return m_lowestC < m_trained[0] - kThermometerNoiseC || m_highestC > m_trained[1] + kThermometerNoiseC;
}

std::string ModelRange::trainedText() const
{
    return forReading(m_trained[0], 1) + " to " + forReading(m_trained[1], 1) + " °C";
}

Error ModelRange::refusal(const std::string &what, const std::string &modelFile) const
{
    return {Errc::OutsideTrainedRange, what + " lies at " + forReading(m_lowestC, 1) + " to " +
                                           forReading(m_highestC, 1) + " °C, wholly outside the " +
                                           trainedText() + " that " + modelFile +
                                           " was trained on; record a run that covers it, or say --force to "
                                           "hold the edge value."};
}

std::string ModelRange::notice(const std::string &what) const
{
    return std::to_string(m_outside) + " of " + std::to_string(m_samples) + " samples of " + what +
           " lie outside the trained range of " + trainedText() + "; the edge value is held there.";
}

} // namespace driftbench::cli
