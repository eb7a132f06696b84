#include "engine/features/thermal_curve.h"

#include "engine/features/temperature_quantities.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace driftbench {

void ThermalCell::merge(const ThermalCell &other)
{
    count += other.count;
    sumQuantities += other.sumQuantities;
    sumTdeDps += other.sumTdeDps;
    sumTdeSquared += other.sumTdeSquared;
}

ThermalCell &ThermalCurve::cellAt(std::int64_t key)
{
    if (m_cells.empty())
        m_firstKey = key;
    if (key < m_firstKey) {
        m_cells.insert(m_cells.begin(), static_cast<std::size_t>(m_firstKey - key), ThermalCell());
        m_firstKey = key;
    }
    const auto index = static_cast<std::size_t>(key - m_firstKey);
    if (index >= m_cells.size())
        m_cells.resize(index + 1);
    return m_cells[index];
}

std::int64_t ThermalCurve::keyOf(double deltaT) const
{
    return static_cast<std::int64_t>(std::floor(deltaT / m_cellWidthC + 0.5));
}

void ThermalCurve::add(double deltaT, const Eigen::Vector3d &tdeDps)
{
    assert(std::abs(deltaT) <= kLargestDeltaT);
    ThermalCell &cell = cellAt(keyOf(deltaT));
    cell.count += 1.0;
    cell.sumQuantities += temperatureQuantities(deltaT);
    cell.sumTdeDps += tdeDps;
    cell.sumTdeSquared += tdeDps.cwiseAbs2();
}

void ThermalCurve::add(double deltaT, const Eigen::Vector3d &tdeDps, double samples,
                       const Eigen::Vector3d &varianceDps2)
{
    assert(std::abs(deltaT) <= kLargestDeltaT);
    ThermalCell &cell = cellAt(keyOf(deltaT));
    cell.count += samples;
    cell.sumQuantities += samples * temperatureQuantities(deltaT);
    cell.sumTdeDps += samples * tdeDps;
    cell.sumTdeSquared += samples * (tdeDps.cwiseAbs2() + varianceDps2);
}

void ThermalCurve::add(const Eigen::VectorXd &deltaT, const Eigen::MatrixX3d &tdeDps)
{
    if (deltaT.size() == 0)
        return;
    makeRoomFrom(deltaT.minCoeff());
    for (Eigen::Index i = 0; i < deltaT.size(); ++i)
        add(deltaT[i], Eigen::Vector3d(tdeDps(i, 0), tdeDps(i, 1), tdeDps(i, 2)));
}

void ThermalCurve::merge(const ThermalCurve &other)
{
    assert(m_cellWidthC == other.m_cellWidthC);
    for (std::size_t i = 0; i < other.m_cells.size(); ++i) {
        if (other.m_cells[i].count > 0.0)
            cellAt(other.m_firstKey + static_cast<std::int64_t>(i)).merge(other.m_cells[i]);
    }
}

void ThermalCurve::shift(const Eigen::Vector3d &offsetDps)
{
    for (ThermalCell &cell : m_cells) {
        cell.sumTdeSquared +=
            cell.count * offsetDps.cwiseAbs2() - 2.0 * offsetDps.cwiseProduct(cell.sumTdeDps);
        cell.sumTdeDps -= cell.count * offsetDps;
    }
}

double ThermalCurve::totalCount() const
{
    double total = 0.0;
    for (const ThermalCell &cell : m_cells)
        total += cell.count;
    return total;
}

double ThermalCurve::lowestDeltaT() const
{
    return m_cells.empty() ? std::numeric_limits<double>::quiet_NaN() : m_cells.front().meanDeltaT();
}

double ThermalCurve::highestDeltaT() const
{
    return m_cells.empty() ? std::numeric_limits<double>::quiet_NaN() : m_cells.back().meanDeltaT();
}

ThermalCurve ThermalCurve::coarsened(int factor) const
{
    assert(factor >= 1);
    ThermalCurve coarse(m_cellWidthC * factor);
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        if (m_cells[i].count > 0.0)
            coarse.cellAt(static_cast<std::int64_t>(std::floor(cellCentreC(i) / coarse.m_cellWidthC + 0.5)))
                .merge(m_cells[i]);
    }
    return coarse;
}

Eigen::Vector3d ThermalCurve::pooledVariance() const
{
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    double degreesOfFreedom = 0.0;
    for (const ThermalCell &cell : m_cells) {
        if (cell.count < 2.0)
            continue;
        squares += (cell.sumTdeSquared - cell.sumTdeDps.cwiseAbs2() / cell.count).cwiseMax(0.0);
        degreesOfFreedom += cell.count - 1.0;
    }
    if (degreesOfFreedom == 0.0)
        return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return squares / degreesOfFreedom;
}

} // namespace driftbench
