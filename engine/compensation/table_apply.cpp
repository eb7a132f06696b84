#include "engine/compensation/table_apply.h"

#include <algorithm>

namespace driftbench {

template <class Scalar>
struct TableApply<Scalar>::Block
{
    alignas(64) std::int32_t cell[kBlock];
    alignas(64) Scalar fraction[kBlock];
    alignas(64) Scalar tde[kBlock][4];
};

template <class Scalar>
TableApply<Scalar>::TableApply(const CompensationTable &table)
    : m_first(static_cast<Scalar>(table.firstTemperatureC()))
    , m_inverseStep(static_cast<Scalar>(1.0 / table.stepC()))
    , m_lastPosition(static_cast<Scalar>(table.size() - 1))
    , m_cells(static_cast<std::size_t>(table.size() - 1))
{
    const Columns knots = table.tdeDps.cast<Scalar>();
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        for (int axis = 0; axis < 3; ++axis) {
            m_cells[i].value[axis] = knots(row, axis);
            m_cells[i].slope[axis] = knots(row + 1, axis) - knots(row, axis);
        }
        m_cells[i].value[3] = m_cells[i].slope[3] = 0;
    }
}

template <class Scalar>
void TableApply<Scalar>::locate(const Scalar *temperatureC, Eigen::Index count, Block &block) const
{
    const Scalar first = m_first;
    const Scalar inverseStep = m_inverseStep;
    const Scalar lastPosition = m_lastPosition;
    const Scalar lastCell = m_lastPosition - Scalar(1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Scalar position = (temperatureC[i] - first) * inverseStep;
        // Not a number compares false and lands on 0, so that the cell is always one of the table.
        Scalar held = position > Scalar(0) ? position : Scalar(0);
        held = held < lastPosition ? held : lastPosition;
        const auto cell = static_cast<std::int32_t>(held < lastCell ? held : lastCell);
        block.cell[i] = cell;
        // The last term is 0, or not a number where the temperature is not finite: cheaper than a branch.
        const Scalar zeroOrNaN = position - position; // NOLINT(misc-redundant-expression)
        block.fraction[i] = (held - static_cast<Scalar>(cell)) + zeroOrNaN;
    }
}

template <class Scalar>
void TableApply<Scalar>::evaluate(Eigen::Index count, Block &block) const
{
    using Lanes = Eigen::Array<Scalar, 4, 1>;
    const Cell *cells = m_cells.data();
    for (Eigen::Index i = 0; i < count; ++i) {
        const Cell &cell = cells[block.cell[i]];
        Eigen::Map<Lanes, Eigen::Aligned16>(block.tde[i]) =
            Eigen::Map<const Lanes, Eigen::Aligned16>(cell.value) +
            block.fraction[i] * Eigen::Map<const Lanes, Eigen::Aligned16>(cell.slope);
    }
}

template <class Scalar>
typename TableApply<Scalar>::Columns
TableApply<Scalar>::tde(const Eigen::Ref<const Column> &temperatureC) const
{
    Columns tdeDps(temperatureC.size(), 3);
    Block block;
    for (Eigen::Index start = 0; start < temperatureC.size(); start += kBlock) {
        const Eigen::Index count = std::min(kBlock, temperatureC.size() - start);
        locate(temperatureC.data() + start, count, block);
        evaluate(count, block);
        for (int axis = 0; axis < 3; ++axis) {
            Scalar *column = tdeDps.col(axis).data() + start;
            for (Eigen::Index i = 0; i < count; ++i)
                column[i] = block.tde[i][axis];
        }
    }
    return tdeDps;
}

template <class Scalar>
void TableApply<Scalar>::apply(const Eigen::Ref<const Column> &temperatureC,
                               const Eigen::Ref<const Columns> &rateDps,
                               Eigen::Ref<Columns> compensatedDps) const
{
    Block block;
    for (Eigen::Index start = 0; start < temperatureC.size(); start += kBlock) {
        const Eigen::Index count = std::min(kBlock, temperatureC.size() - start);
        locate(temperatureC.data() + start, count, block);
        evaluate(count, block);
        for (int axis = 0; axis < 3; ++axis) {
            const Scalar *rate = rateDps.col(axis).data() + start;
            Scalar *compensated = compensatedDps.col(axis).data() + start;
            for (Eigen::Index i = 0; i < count; ++i)
                compensated[i] = rate[i] - block.tde[i][axis];
        }
    }
}

template class TableApply<float>;
template class TableApply<double>;

} // namespace driftbench
