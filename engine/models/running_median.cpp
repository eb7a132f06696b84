#include "engine/models/running_median.h"

#include "engine/base/statistics.h"

#include <array>
#include <cstddef>

namespace driftbench {

namespace {

constexpr std::size_t kSize = kMedianWindow;
constexpr Eigen::Index kHalf = kMedianWindow / 2;

// The window's values in order. Each replacement passes over all of them without a branch: in noise, a branch
// that looks for the place is wrong half the time and costs more than the whole pass.
class SortedWindow
{
public:
    void replace(double leaving, double entering)
    {
        // From the first value equal to the leaving one on, each place takes the value of the next.
        for (std::size_t i = 0; i < kSize; ++i)
            m_rest[i + 1] = m_values[i] < leaving ? m_values[i] : m_values[i + 1];
        // Each place keeps its value below the entering one, and takes that of the place before above it.
        for (std::size_t i = 0; i < kSize; ++i) {
            const double lower = m_rest[i + 1] < entering ? m_rest[i + 1] : entering;
            m_values[i] = m_rest[i] < lower ? lower : m_rest[i];
        }
    }

    double median() const { return m_values[kSize / 2]; }

private:
    static std::array<double, kSize + 1> closed(double first, double last)
    {
        std::array<double, kSize + 1> values{}; // zeros, as beyond the ends of the series
        values.front() = first;
        values.back() = last;
        return values;
    }

    std::array<double, kSize + 1> m_values = closed(0.0, kInfinity);
    std::array<double, kSize + 1> m_rest = closed(-kInfinity, kInfinity);
};

} // namespace

Eigen::VectorXd runningMedian(const Eigen::VectorXd &values)
{
    const Eigen::Index count = values.size();
    Eigen::VectorXd medians(count);
    SortedWindow window;
    for (Eigen::Index i = 0; i < count + kHalf; ++i) {
        const double leaving = i >= kMedianWindow ? values[i - kMedianWindow] : 0.0;
        window.replace(leaving, i < count ? values[i] : 0.0);
        if (i >= kHalf)
            medians[i - kHalf] = window.median();
    }
    return medians;
}

} // namespace driftbench
