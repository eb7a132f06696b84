#include "engine/recording/block_means.h"

#include "engine/recording/quality_checks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace driftbench {

std::int64_t samplesAPoint(std::int64_t samples, std::int64_t mostPoints)
{
    std::int64_t each = 1;
    while ((samples + each - 1) / each > mostPoints)
        each *= 2;
    return each;
}

BlockMeans::BlockMeans(std::int64_t samplesAPoint, std::int64_t room) : m_samplesAPoint(samplesAPoint)
{
    assert(samplesAPoint > 1);
    m_temperatureC.reserve(static_cast<std::size_t>(samplesAPoint));
    resizeRows(static_cast<Eigen::Index>(room / samplesAPoint + 1));
}

void BlockMeans::resizeRows(Eigen::Index rows)
{
    m_made.timeS.conservativeResize(rows);
    m_made.temperatureC.conservativeResize(rows);
    m_made.rateDps.conservativeResize(rows, Eigen::NoChange);
    m_made.points.samples.conservativeResize(rows);
    m_made.points.varianceDps2.conservativeResize(rows, Eigen::NoChange);
}

void BlockMeans::add(const double *timeS, const double *temperatureC,
                     const std::array<const double *, 3> &rateDps, Eigen::Index count)
{
    for (Eigen::Index i = 0; i < count; ++i)
        add({timeS[i], temperatureC[i], {rateDps[0][i], rateDps[1][i], rateDps[2][i]}});
}

void BlockMeans::add(const Sample &sample)
{
    // Infinities of either sign and NaN all leave a sum that is not finite.
    const bool finite = std::isfinite(sample.timeS + sample.temperatureC + sample.rateDps[0] +
                                      sample.rateDps[1] + sample.rateDps[2]);
    if (finite && m_finite && sample.timeS == m_lastS) {
        ++m_repeats;
        return;
    }
    if (m_count > 0 && !continues(sample, finite))
        endPoint();
    if (m_count == 0) {
        m_first = sample;
        m_finite = finite;
    }
    put(sample);
    if (m_count == m_samplesAPoint)
        endPoint();
}

bool BlockMeans::continues(const Sample &sample, bool finite) const
{
    if (finite != m_finite)
        return false;
    if (!finite)
        return true;
    const double stepS = sample.timeS - m_lastS;
    const double n = static_cast<double>(m_samplesAPoint);
    const double expectedS = m_count > 1 ? n * (m_lastS - m_first.timeS) / (m_count - 1) : 0.0;
    const double longestS = std::max(m_pointLastsS, expectedS);
    return stepS > 0.0 && (longestS == 0.0 || stepS <= longestS);
}

void BlockMeans::put(const Sample &sample)
{
    ++m_count;
    m_lastS = sample.timeS;
    m_sumTimeS += sample.timeS - m_first.timeS;
    m_temperatureC.push_back(sample.temperatureC);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double difference = sample.rateDps[axis] - m_first.rateDps[axis];
        m_sumDps[axis] += difference;
        m_squares[axis] += difference * difference;
    }
}

double BlockMeans::temperatureOfPoint()
{
    double sum = 0.0;
    bool stairs = false;
    for (std::size_t i = 1; i < m_temperatureC.size(); ++i) {
        sum += m_temperatureC[i] - m_temperatureC.front();
        stairs = stairs || std::abs(m_temperatureC[i] - m_temperatureC[i - 1]) >= kStairsC;
    }
    if (!stairs)
        return m_temperatureC.front() + sum / static_cast<double>(m_temperatureC.size());
    const auto middle = m_temperatureC.begin() + static_cast<std::ptrdiff_t>(m_temperatureC.size() / 2);
    std::nth_element(m_temperatureC.begin(), middle, m_temperatureC.end());
    return *middle;
}

void BlockMeans::endPoint()
{
    if (m_points == m_made.timeS.size())
        resizeRows(m_points + m_points / 2 + 1);
    const double n = m_count;
    m_made.timeS[m_points] = m_first.timeS + m_sumTimeS / n;
    m_made.temperatureC[m_points] = temperatureOfPoint();
    m_made.points.samples[m_points] = m_count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double mean = m_sumDps[axis] / n;
        const auto column = static_cast<Eigen::Index>(axis);
        m_made.rateDps(m_points, column) = m_first.rateDps[axis] + mean;
        m_made.points.varianceDps2(m_points, column) =
            static_cast<float>(std::max(0.0, m_squares[axis] / n - mean * mean));
    }
    ++m_points;
    if (m_finite && m_count == m_samplesAPoint)
        m_pointLastsS = n * (m_lastS - m_first.timeS) / (n - 1.0);
    m_count = 0;
    m_sumTimeS = 0.0;
    m_sumDps = m_squares = {};
    m_temperatureC.clear();
}

Recording BlockMeans::finish(RecordingInfo info)
{
    if (m_count > 0)
        endPoint();
    resizeRows(m_points);
    m_made.info = std::move(info);
    if (m_repeats > 0)
        m_made.info.warnings.push_back(std::to_string(m_repeats) +
                                       (m_repeats == 1 ? " sample repeats" : " samples repeat") +
                                       " the time stamp of the sample before and is left out of the means.");
    return std::move(m_made);
}

Recording shortened(Recording recording, std::int64_t mostPoints)
{
    const std::int64_t each = samplesAPoint(recording.size(), mostPoints);
    if (each == 1)
        return recording;
    BlockMeans means(each, recording.size());
    means.add(
        recording.timeS.data(), recording.temperatureC.data(),
        {recording.rateDps.col(0).data(), recording.rateDps.col(1).data(), recording.rateDps.col(2).data()},
        recording.size());
    return means.finish(std::move(recording.info));
}

std::string meansText(const Recording &recording)
{
    if (recording.points.empty())
        return {};
    return "Its " + quality::countText(recording.samples()) + " samples are taken as " +
           quality::countText(recording.size()) + " means of " +
           std::to_string(recording.points.samples.maxCoeff()) + " in a row.";
}

} // namespace driftbench
