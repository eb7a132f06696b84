// Which samples of a recording are not used, and why. The mask is part of a run and shown in every output.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace driftbench {

// One bit a reason; a sample may have several.
enum class MaskReason : std::uint16_t
{
    NonFinite = 1 << 0,        // a value is NaN or infinite
    BadTime = 1 << 1,          // duplicate or backward time stamp
    StartUp = 1 << 2,          // the sensor was not up yet
    Saturated = 1 << 3,        // the rate stands at the end of its range
    Motion = 1 << 4,           // the gyro moved
    TemperatureFault = 1 << 5, // temperature stuck or jumping
    Excluded = 1 << 6,         // taken out by the user
    Outlier = 1 << 7,          // kept for judging, left out of training
};

inline constexpr std::array<MaskReason, 8> kMaskReasons{
    MaskReason::NonFinite, MaskReason::BadTime,          MaskReason::StartUp,  MaskReason::Saturated,
    MaskReason::Motion,    MaskReason::TemperatureFault, MaskReason::Excluded, MaskReason::Outlier};

std::string_view maskReasonName(MaskReason reason); // "motion", "start-up", ...

class Mask
{
public:
    Mask() = default;
    explicit Mask(Eigen::Index size) : m_bits(static_cast<std::size_t>(size), 0) {}

    Eigen::Index size() const { return static_cast<Eigen::Index>(m_bits.size()); }

    void set(Eigen::Index sample, MaskReason reason)
    {
        m_bits[static_cast<std::size_t>(sample)] |= static_cast<std::uint16_t>(reason);
    }
    bool has(Eigen::Index sample, MaskReason reason) const
    {
        return (m_bits[static_cast<std::size_t>(sample)] & static_cast<std::uint16_t>(reason)) != 0;
    }
    // Outliers of the noise stay in what a model is judged on; everything else leaves both.
    bool usableForJudging(Eigen::Index sample) const
    {
        constexpr auto outlier = static_cast<std::uint16_t>(MaskReason::Outlier);
        return (m_bits[static_cast<std::size_t>(sample)] & ~outlier) == 0;
    }
    bool usableForTraining(Eigen::Index sample) const
    {
        return m_bits[static_cast<std::size_t>(sample)] == 0;
    }

    Eigen::Index count(MaskReason reason) const;
    Eigen::Index countUsableForJudging() const;
    Eigen::Index countUsableForTraining() const;

private:
    std::vector<std::uint16_t> m_bits;
};

} // namespace driftbench
