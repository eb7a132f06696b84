// The play operator, the elementary hysteresis of Krasnosel'skii and Pokrovskii (1989): a state that is
// pushed along by its input once the input has used up the play of +-halfWidth: p <- min(max(p, x - r), x +
// r).
//
// After a travel of 2r the state stands r behind the input, whichever way the input goes.
#pragma once

#include <algorithm>

namespace driftbench {

class PlayOperator
{
public:
    PlayOperator(double halfWidth, double start) : m_halfWidth(halfWidth), m_state(start) {}

    double advance(double input)
    {
        m_state = std::clamp(m_state, input - m_halfWidth, input + m_halfWidth);
        return m_state;
    }
    // Where the input stands in the play: +1 when it has been rising, -1 when it has been falling.
    double deflection(double input) const { return (input - m_state) / m_halfWidth; }

private:
    double m_halfWidth;
    double m_state;
};

} // namespace driftbench
