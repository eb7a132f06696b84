// A compensation table made ready for many samples: compensated rate = rate - tde(T).
//
// Arithmetic, all in Scalar (float or double), the same in the exported C header:
//   p = (T - first) * (1 / step)          position in cells; the reciprocal is rounded once, beforehand
//   p = min(max(p, 0), n - 1)             outside the table the end value is held
//   i = min(floor(p), n - 2),  f = p - i
//   tde = v_i + f * (v_{i+1} - v_i)       the difference is taken beforehand
// A temperature that is not finite gives rates that are not a number.
#pragma once

#include "engine/compensation/compensation_table.h"

#include <Eigen/Core>
#include <vector>

namespace driftbench {

template <class Scalar>
class TableApply
{
public:
    using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;

    explicit TableApply(const CompensationTable &table);

    Columns tde(const Eigen::Ref<const Column> &temperatureC) const; // N x 3, dps

    // compensatedDps: N x 3, as rateDps; the two may be the same memory.
    void apply(const Eigen::Ref<const Column> &temperatureC, const Eigen::Ref<const Columns> &rateDps,
               Eigen::Ref<Columns> compensatedDps) const;

private:
    // Value and slope per cell of the three axes, padded to four: one load each with vector instructions.
    struct alignas(8 * sizeof(Scalar)) Cell
    {
        Scalar value[4];
        Scalar slope[4];
    };
    static constexpr Eigen::Index kBlock = 64;
    struct Block;

    void locate(const Scalar *temperatureC, Eigen::Index count, Block &block) const;
    void evaluate(Eigen::Index count, Block &block) const;

    Scalar m_first;
    Scalar m_inverseStep;
    Scalar m_lastPosition;
    std::vector<Cell> m_cells;
};

extern template class TableApply<float>;
extern template class TableApply<double>;

} // namespace driftbench
