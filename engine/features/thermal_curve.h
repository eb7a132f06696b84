// The thermal curve: a run collapsed to weighted temperature cells.
//
// Every model of temperature alone estimates one curve g(dT) per axis; of a run it needs only, for each cell
// of dT, how many samples fell into it and the sums of what was seen there. With cell width h the cell of a
// sample is key = floor(dT / h + 1/2). Curves merge by adding their cells, across runs, files and machines,
// and the least-squares solution over the cells (weight n, target mean y) is that over the samples up to the
// change of g within a cell. Memory depends on the temperature range, not on the number of samples.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace driftbench {

struct ThermalCell
{
    double count = 0.0;
    Eigen::Vector3d sumQuantities = Eigen::Vector3d::Zero(); // of dT, dT^2, signed root
    Eigen::Vector3d sumTdeDps = Eigen::Vector3d::Zero();     // per axis
    Eigen::Vector3d sumTdeSquared = Eigen::Vector3d::Zero(); // per axis, dps^2

    void merge(const ThermalCell &other);
    double meanDeltaT() const { return sumQuantities[0] / count; }
    Eigen::Vector3d meanTdeDps() const { return sumTdeDps / count; }
};

class ThermalCurve
{
public:
    static constexpr double kDefaultCellWidthC = 0.02;
    // Beyond this |dT| a reading is no temperature of a sensor; such samples must be masked before.
    static constexpr double kLargestDeltaT = 1000.0;

    explicit ThermalCurve(double cellWidthC = kDefaultCellWidthC) : m_cellWidthC(cellWidthC) {}

    double cellWidthC() const { return m_cellWidthC; }

    void add(double deltaT, const Eigen::Vector3d &tdeDps);
    // That many samples with this mean, and among them this variance (1/n) of the TDE.
    void add(double deltaT, const Eigen::Vector3d &tdeDps, double samples,
             const Eigen::Vector3d &varianceDps2);
    // N samples; the same as N times the first of these.
    void add(const Eigen::VectorXd &deltaT, const Eigen::MatrixX3d &tdeDps);
    // Before a falling temperature would put one cell after the other before all that are there.
    void makeRoomFrom(double lowestDeltaT) { cellAt(keyOf(lowestDeltaT)); }
    // Many samples of one cell at once, as another curve of the same width and reference has them.
    void addCell(std::int64_t key, const ThermalCell &cell) { cellAt(key).merge(cell); }
    // The other curve must have the same cell width and the same reference temperature.
    void merge(const ThermalCurve &other);

    // Subtracts offsetDps from every sample that is in the curve.
    void shift(const Eigen::Vector3d &offsetDps);

    // Cells side by side from the lowest to the highest key that was seen; some may be empty (count 0).
    std::int64_t firstKey() const { return m_firstKey; }
    const std::vector<ThermalCell> &cells() const { return m_cells; }
    double cellCentreC(std::size_t cell) const
    {
        return static_cast<double>(m_firstKey + static_cast<std::int64_t>(cell)) * m_cellWidthC;
    }

    double totalCount() const;
    bool empty() const { return m_cells.empty(); }
    double lowestDeltaT() const; // mean dT of the first occupied cell; NaN if empty
    double highestDeltaT() const;

    // The same samples in cells of a whole multiple of this curve's width.
    ThermalCurve coarsened(int factor) const;

    // Variance within cells, pooled over all cells with two samples or more: what no function of temperature
    // can remove. Sum over cells of (sum y^2 - (sum y)^2 / n) / sum (n - 1), per axis, dps^2; NaN without
    // any.
    Eigen::Vector3d pooledVariance() const;

private:
    std::int64_t keyOf(double deltaT) const;
    ThermalCell &cellAt(std::int64_t key);

    double m_cellWidthC;
    std::int64_t m_firstKey = 0;
    std::vector<ThermalCell> m_cells;
};

} // namespace driftbench
