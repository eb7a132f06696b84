#include "engine/recording/mask.h"

#include <algorithm>

namespace driftbench {

std::string_view maskReasonName(MaskReason reason)
{
    switch (reason) {
    case MaskReason::NonFinite:
        return "non-finite";
    case MaskReason::BadTime:
        return "bad time";
    case MaskReason::StartUp:
        return "start-up";
    case MaskReason::Saturated:
        return "saturated";
    case MaskReason::Motion:
        return "motion";
    case MaskReason::TemperatureFault:
        return "temperature fault";
    case MaskReason::Excluded:
        return "excluded";
    case MaskReason::Outlier:
        return "outlier";
    }
    return "";
}

Eigen::Index Mask::count(MaskReason reason) const
{
    const auto bit = static_cast<std::uint16_t>(reason);
    return std::count_if(m_bits.begin(), m_bits.end(),
                         [bit](std::uint16_t bits) { return (bits & bit) != 0; });
}

Eigen::Index Mask::countUsableForJudging() const
{
    Eigen::Index usable = 0;
    for (Eigen::Index i = 0; i < size(); ++i)
        usable += usableForJudging(i) ? 1 : 0;
    return usable;
}

Eigen::Index Mask::countUsableForTraining() const
{
    return std::count(m_bits.begin(), m_bits.end(), std::uint16_t{0});
}

} // namespace driftbench
