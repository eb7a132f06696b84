// Seeded random numbers whose sequence is the same with every compiler and library, which the distributions
// of <random> do not promise.
//
// Generator: xoshiro256++ (Blackman & Vigna 2021), seeded through splitmix64. Normal deviates: the ziggurat
// of Marsaglia & Tsang (2000) with 256 layers, in the form with separate bits for layer and abscissa
// (Doornik 2005).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace driftbench {

class Random
{
public:
    explicit Random(std::uint64_t seed = 1);

    // An independent generator for a named purpose, so that one stream's use never shifts another's.
    Random fork(std::uint64_t stream) const;

    std::uint64_t bits();                      // 64 uniform bits
    double uniform();                          // [0, 1), 53 bits
    double uniform(double low, double high);   // [low, high)
    std::uint64_t below(std::uint64_t bound);  // 0 .. bound - 1, unbiased
    double normal();                           // mean 0, standard deviation 1
    void fillNormal(std::span<double> values); // what as many calls of normal() give, in less time

private:
    double normalOutsideLayer(std::uint64_t layer, double abscissa, bool negative);

    std::uint64_t m_seed;
    std::array<std::uint64_t, 4> m_state;
};

// The normal deviates of a generator one at a time, made many at a time.
class NormalStream
{
public:
    explicit NormalStream(const Random &random) : m_random(random) {}

    double next()
    {
        if (m_used == m_values.size()) {
            m_random.fillNormal(m_values);
            m_used = 0;
        }
        return m_values[m_used++];
    }

private:
    static constexpr std::size_t kAtOnce = 192;

    Random m_random;
    std::array<double, kAtOnce> m_values{};
    std::size_t m_used = kAtOnce;
};

} // namespace driftbench
