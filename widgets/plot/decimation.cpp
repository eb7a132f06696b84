#include "widgets/plot/decimation.h"

#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace driftbench {

static constexpr int kSamplesAColumn = 4;
static constexpr int kColumnsOfAGap = 3;
static constexpr double kStandstillC = 0.1; // between means a minute apart or more

namespace {

struct Column
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    double keySum = 0.0;
    int count = 0;
};

} // namespace

static std::vector<Column> fillColumns(const Eigen::VectorXd &key,
                                       const Eigen::Ref<const Eigen::VectorXd> &value, double firstKey,
                                       double lastKey, int columns)
{
    std::vector<Column> filled(static_cast<std::size_t>(columns));
    const double scale = lastKey > firstKey ? columns / (lastKey - firstKey) : 0.0;
    for (Eigen::Index i = 0; i < key.size(); ++i) {
        if (!(key[i] >= firstKey && key[i] <= lastKey) || !std::isfinite(value[i]))
            continue;
        const int at = std::min(static_cast<int>((key[i] - firstKey) * scale), columns - 1);
        Column &column = filled[static_cast<std::size_t>(at)];
        column.low = std::min(column.low, value[i]);
        column.high = std::max(column.high, value[i]);
        column.sum += value[i];
        column.keySum += key[i];
        ++column.count;
    }
    return filled;
}

Envelope envelope(const Eigen::VectorXd &key, const Eigen::Ref<const Eigen::VectorXd> &value, double firstKey,
                  double lastKey, int columns, double keyUnit)
{
    Envelope result;
    const auto most = static_cast<int>(std::min<Eigen::Index>(columns, key.size() / kSamplesAColumn));
    const auto filled = fillColumns(key, value, firstKey, lastKey, std::max(most, 1));
    int empty = 0;
    for (const Column &column : filled) {
        if (column.count == 0) {
            ++empty;
            continue;
        }
        const double middle = column.keySum / column.count / keyUnit;
        if (empty > kColumnsOfAGap && !result.key.isEmpty()) {
            result.key.append(0.5 * (result.key.last() + middle));
            for (QVector<double> *values : {&result.low, &result.high, &result.mean})
                values->append(std::numeric_limits<double>::quiet_NaN());
        }
        empty = 0;
        result.key.append(middle);
        result.low.append(column.low);
        result.high.append(column.high);
        result.mean.append(column.sum / column.count);
    }
    return result;
}

std::vector<Eigen::Index> thinned(Eigen::Index count, Eigen::Index most)
{
    std::vector<Eigen::Index> kept;
    if (count <= 0 || most <= 0)
        return kept;
    const Eigen::Index strata = std::min(count, most);
    kept.reserve(static_cast<std::size_t>(strata));
    Random random(static_cast<std::uint64_t>(count));
    const double width = static_cast<double>(count) / static_cast<double>(strata);
    for (Eigen::Index i = 0; i < strata; ++i) {
        const double place = (static_cast<double>(i) + (count > most ? random.uniform() : 0.0)) * width;
        kept.push_back(std::min(static_cast<Eigen::Index>(place), count - 1));
    }
    return kept;
}

std::vector<std::uint8_t> heatingFlags(const Eigen::VectorXd &timeS, const Eigen::VectorXd &deltaT)
{
    const Eigen::Index count = timeS.size();
    std::vector<std::uint8_t> flags(static_cast<std::size_t>(count), 1);
    if (count < 2)
        return flags;
    const double span = timeS[count - 1] - timeS[0];
    const int blocks = std::clamp(static_cast<int>(span / 60.0), 1, 256);
    const auto columns = fillColumns(timeS, deltaT, timeS[0], timeS[count - 1], blocks);
    std::vector<double> means;
    for (const Column &column : columns)
        means.push_back(column.count > 0 ? column.sum / column.count : (means.empty() ? NAN : means.back()));

    std::vector<int> directions(means.size(), 0);
    for (std::size_t k = 0; k < means.size(); ++k) {
        const double change = means[std::min(k + 1, means.size() - 1)] - means[k > 0 ? k - 1 : 0];
        directions[k] = change > kStandstillC ? 1 : (change < -kStandstillC ? -1 : 0);
    }
    const auto first = std::find_if(directions.begin(), directions.end(), [](int d) { return d != 0; });
    int direction = first == directions.end() ? 1 : *first;
    for (int &d : directions)
        d = direction = d != 0 ? d : direction;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double place = span > 0.0 ? (timeS[i] - timeS[0]) / span * blocks : 0.0;
        const auto block = static_cast<std::size_t>(std::clamp(static_cast<int>(place), 0, blocks - 1));
        flags[static_cast<std::size_t>(i)] = directions[block] > 0 ? 1 : 0;
    }
    return flags;
}

} // namespace driftbench
