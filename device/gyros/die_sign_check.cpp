#include "device/gyros/die_sign_check.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

// Below half a count per degree the die does not follow what the thermometer sees.
constexpr double kLeastCountsPerC = 0.5;

} // namespace

std::optional<std::string> DieSignCheck::add(double externalC, int dieCount)
{
    if (m_done)
        return {};
    m_lowestC = m_samples > 0.0 ? std::min(m_lowestC, externalC) : externalC;
    m_highestC = m_samples > 0.0 ? std::max(m_highestC, externalC) : externalC;
    m_samples += 1.0;
    const double fromMeanC = externalC - m_meanC;
    m_meanC += fromMeanC / m_samples;
    m_meanCount += (dieCount - m_meanCount) / m_samples;
    m_squaresC += fromMeanC * (externalC - m_meanC);
    m_products += fromMeanC * (dieCount - m_meanCount);
    if (m_highestC - m_lowestC < kSpanC)
        return {};
    m_done = true;
    return verdict(m_products / m_squaresC);
}

std::string DieSignCheck::verdict(double countsPerC) const
{
    const std::string measured = "The die thermometer moved by " + forReading(countsPerC, 2) +
                                 " counts per \u00b0C of the external one";
    if (std::abs(countsPerC) < kLeastCountsPerC)
        return measured + "; fasten the external thermometer to the sensor.";
    if ((countsPerC > 0.0) == (m_cPerCount > 0.0))
        return measured + ", which confirms its sign.";
    return measured + ", but is taken with the other sign; set its scale to " + forReading(-m_cPerCount, 1) +
           " \u00b0C per count.";
}

} // namespace driftbench
