// What is left of a rate that is still being measured, judged while it comes: mean square deviation (paper
// Eq. 31) and the rms after averaging over windows of 10 s, per axis, in constant memory.
//
//   MSD = mean(r^2)        rms10s = sqrt(mean(mean_w(r)^2))        r = rate - reference, or less a model as
//   well
//
// Windows are those of noise_floor.h, counted from the first sample on. A window counts where it is at least
// half full; how many samples fill one is taken from the median of the first kIntervals intervals
// (noise_floor.h: of all). Rows with a value that is not finite are left out and counted. Rates in dps.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace driftbench {

class RunningScore
{
public:
    static constexpr std::size_t kIntervals = 1000;

    explicit RunningScore(double windowS = 10.0) : m_windowS(windowS) {}

    // Rows in the order of time; residualDps: N x 3.
    void add(const Eigen::Ref<const Eigen::VectorXd> &timeS,
             const Eigen::Ref<const Eigen::MatrixX3d> &residualDps);

    std::int64_t samples() const { return m_samples; }
    std::int64_t leftOut() const { return m_leftOut; }
    Eigen::Vector3d msdDps2() const; // NaN without a sample
    Eigen::Vector3d rmsDps() const { return msdDps2().cwiseSqrt(); }
    Eigen::Index windows() const;
    Eigen::Vector3d rms10sDps() const; // NaN without a window

private:
    struct Window
    {
        double index = 0.0; // of the windows since the first sample
        std::int64_t samples = 0;
        Eigen::Vector3d sumDps = Eigen::Vector3d::Zero();
    };

    void addRow(double timeS, const Eigen::Vector3d &residualDps);
    void learnInterval();
    void count(const Window &window);
    RunningScore closed() const; // as if the last window were over

    double m_windowS;
    std::int64_t m_samples = 0;
    std::int64_t m_leftOut = 0;
    Eigen::Vector3d m_squares = Eigen::Vector3d::Zero();
    double m_firstS = 0.0;
    double m_lastS = 0.0;
    std::vector<double> m_intervals; // until the median is known
    double m_fewest = 0.0;           // samples of a half full window; 0: not known yet
    std::vector<Window> m_waiting;   // closed before that
    Window m_open;
    Eigen::Index m_windows = 0;
    Eigen::Vector3d m_windowSquares = Eigen::Vector3d::Zero();
};

// Before and after a model, from the same samples.
struct RunningScores
{
    RunningScore before;
    RunningScore after;
};

} // namespace driftbench
