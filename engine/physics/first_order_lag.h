// First-order lag tau dy/dt = x - y of a signal sampled every stepS, exact for an input that is constant
// between samples: y += (x - y)(1 - exp(-stepS / tau)). tau = 0 passes the input on.
//
// Behind a ramp of r per second the output lags by r tau (1 - exp(-t / tau)).
#pragma once

#include <cassert>
#include <cmath>

namespace driftbench {

class FirstOrderLag
{
public:
    FirstOrderLag(double timeConstantS, double stepS, double start)
        : m_gain(timeConstantS > 0.0 ? -std::expm1(-stepS / timeConstantS) : 1.0), m_value(start)
    {
        assert(timeConstantS >= 0.0 && stepS > 0.0);
    }

    double advance(double input)
    {
        m_value += (input - m_value) * m_gain;
        return m_value;
    }
    double value() const { return m_value; }

private:
    double m_gain;
    double m_value;
};

} // namespace driftbench
