// Whether the die thermometer counts the way it is taken to: its slope against an external thermometer while
// the sensor warms up or cools down.
//
//   slope = cov(count, T) / var(T)   in counts per degree Celsius, told once, when T has moved by kSpanC
//
// Public drivers disagree on the sign, and a wrong one turns the drift curve round.
#pragma once

#include <optional>
#include <string>

namespace driftbench {

class DieSignCheck
{
public:
    static constexpr double kSpanC = 5.0; // the die counts whole degrees

    // cPerCount is how a count is taken: -1.0 for a falling one.
    explicit DieSignCheck(double cPerCount) : m_cPerCount(cPerCount) {}

    // A sentence when the matter is settled, once.
    std::optional<std::string> add(double externalC, int dieCount);

private:
    std::string verdict(double countsPerC) const;

    double m_cPerCount;
    bool m_done = false;
    double m_samples = 0.0;
    double m_meanC = 0.0;
    double m_meanCount = 0.0;
    double m_squaresC = 0.0;
    double m_products = 0.0;
    double m_lowestC = 0.0;
    double m_highestC = 0.0;
};

} // namespace driftbench
