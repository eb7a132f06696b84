// Stretches over which the temperature is held, found while it is being measured.
//
// Means over kBlockS are taken one after the other. A hold is a longest stretch of them that stays within
// kBandC (highest less lowest) for kShortestS or longer; what drifts faster than 0.25 degrees a minute is
// none. Rows whose time or temperature is not finite are left out. Memory does not grow with the samples but
// for the holds. Times in seconds, temperatures in degrees Celsius.
#pragma once

#include <Eigen/Core>

#include <deque>
#include <optional>
#include <vector>

namespace driftbench {

struct TemperatureHold
{
    double startS = 0.0;
    double endS = 0.0;
    double meanC = 0.0; // of the blocks
};

class HoldDetector
{
public:
    static constexpr double kBlockS = 5.0;
    static constexpr double kBandC = 0.25;
    static constexpr double kShortestS = 60.0;

    // Rows in the order of time.
    void add(const Eigen::Ref<const Eigen::VectorXd> &timeS,
             const Eigen::Ref<const Eigen::VectorXd> &temperatureC);

    // In the order of time; the one that goes on is the last.
    std::vector<TemperatureHold> holds() const;
    bool isHolding() const { return current().has_value(); } // now

private:
    struct Block
    {
        double startS = 0.0, endS = 0.0;
        double meanC = 0.0;
    };

    void addBlock(const Block &block);
    void restart(const Block &block);
    std::optional<TemperatureHold> current() const;

    std::vector<TemperatureHold> m_ended;
    // The block being filled.
    double m_blockStartS = 0.0, m_blockEndS = 0.0, m_sumC = 0.0;
    Eigen::Index m_inBlock = 0;
    // The stretch that may be, or is, a hold. The blocks are kept until it is one.
    std::deque<Block> m_candidates;
    double m_startS = 0.0, m_endS = 0.0;
    double m_lowC = 0.0, m_highC = 0.0; // until it is one
    double m_blockSumC = 0.0;
    Eigen::Index m_blocks = 0;
};

} // namespace driftbench
