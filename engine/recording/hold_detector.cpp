#include "engine/recording/hold_detector.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

void HoldDetector::add(const Eigen::Ref<const Eigen::VectorXd> &timeS,
                       const Eigen::Ref<const Eigen::VectorXd> &temperatureC)
{
    for (Eigen::Index i = 0; i < timeS.size(); ++i) {
        if (!std::isfinite(timeS[i]) || !std::isfinite(temperatureC[i]))
            continue;
        if (m_inBlock > 0 && timeS[i] >= m_blockStartS + kBlockS) {
            addBlock({m_blockStartS, m_blockEndS, m_sumC / static_cast<double>(m_inBlock)});
            m_inBlock = 0;
        }
        if (m_inBlock == 0) {
            m_blockStartS = timeS[i];
            m_sumC = 0.0;
        }
        m_sumC += temperatureC[i];
        m_blockEndS = timeS[i];
        ++m_inBlock;
    }
}

void HoldDetector::restart(const Block &block)
{
    m_candidates = {block};
    m_startS = block.startS;
    m_endS = block.endS;
    m_lowC = m_highC = m_blockSumC = block.meanC;
    m_blocks = 1;
}

std::optional<TemperatureHold> HoldDetector::current() const
{
    if (m_blocks == 0 || m_endS - m_startS < kShortestS)
        return std::nullopt;
    return TemperatureHold{m_startS, m_endS, m_blockSumC / static_cast<double>(m_blocks)};
}

void HoldDetector::addBlock(const Block &block)
{
    if (m_blocks == 0) {
        restart(block);
        return;
    }
    const double low = std::min(m_lowC, block.meanC);
    const double high = std::max(m_highC, block.meanC);
    const auto hold = current();
    if (hold && std::abs(block.meanC - hold->meanC) > kBandC) {
        m_ended.push_back(*hold);
        restart(block);
        return;
    }
    if (!hold && high - low > kBandC) {
        // Not long enough to be one: it may begin later.
        std::deque<Block> rest = std::move(m_candidates);
        rest.push_back(block);
        const auto fits = [&] {
            const auto [lowest, highest] = std::minmax_element(
                rest.begin(), rest.end(), [](const Block &a, const Block &b) { return a.meanC < b.meanC; });
            return highest->meanC - lowest->meanC <= kBandC;
        };
        while (!fits())
            rest.pop_front();
        const std::deque<Block> kept = std::move(rest);
        restart(kept.front());
        for (std::size_t i = 1; i < kept.size(); ++i)
            addBlock(kept[i]);
        return;
    }
    m_lowC = low;
    m_highC = high;
    m_endS = block.endS;
    m_blockSumC += block.meanC;
    ++m_blocks;
    if (m_endS - m_startS < kShortestS)
        m_candidates.push_back(block);
    else
        m_candidates.clear();
}

std::vector<TemperatureHold> HoldDetector::holds() const
{
    std::vector<TemperatureHold> all = m_ended;
    if (const auto hold = current())
        all.push_back(*hold);
    return all;
}

} // namespace driftbench
