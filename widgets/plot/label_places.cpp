#include "widgets/plot/label_places.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace driftbench {

std::vector<double> pushedApart(const std::vector<double> &wanted, double distance, double low, double high)
{
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    // Blocks of labels that touch; each stands where the mean of its members wants it.
    struct Block
    {
        double sumOfFirst = 0.0; // of where each member would have the block's first label
        std::size_t members = 0;
        double first(double span, double lowest, double highest) const
        {
            return std::max(lowest, std::min(sumOfFirst / static_cast<double>(members), highest - span));
        }
    };
    std::vector<Block> blocks;
    const auto firstOf = [&](const Block &block) {
        return block.first(distance * static_cast<double>(block.members - 1), low, high);
    };
    for (const std::size_t index : order) {
        blocks.push_back({wanted[index], 1});
        while (blocks.size() > 1) {
            Block &upper = blocks[blocks.size() - 2];
            const Block lower = blocks.back();
            const double end = firstOf(upper) + distance * static_cast<double>(upper.members);
            if (firstOf(lower) >= end)
                break;
            upper.sumOfFirst +=
                lower.sumOfFirst - distance * static_cast<double>(upper.members * lower.members);
            upper.members += lower.members;
            blocks.pop_back();
        }
    }
    std::vector<double> places(wanted.size());
    auto next = order.begin();
    for (const Block &block : blocks) {
        for (std::size_t k = 0; k < block.members; ++k)
            places[*next++] = firstOf(block) + distance * static_cast<double>(k);
    }
    return places;
}

} // namespace driftbench
