// Long recordings made small enough to draw, without hiding what is in them. Values that are not finite are
// left out.
#pragma once

#include <Eigen/Core>
#include <QVector>

#include <cstdint>
#include <vector>

namespace driftbench {

// Lowest, highest and mean value in each of `columns` equal stretches of the key.
struct Envelope
{
    QVector<double> key; // middle of the stretch
    QVector<double> low, high, mean;
};

// key: N, rising; value: N. The result is over firstKey..lastKey, with keys divided by keyUnit. Where more
// than three stretches in a row are empty a NaN breaks the line: a gap of the recording stays a gap. With few
// samples the stretches get wider, so that each holds four on average.
Envelope envelope(const Eigen::VectorXd &key, const Eigen::Ref<const Eigen::VectorXd> &value, double firstKey,
                  double lastKey, int columns, double keyUnit = 1.0);

// At most `most` of `count` samples, one drawn from each of as many equal stretches: the density of dots
// stays what it was, and no period of the data can beat against the step. Always the same for the same
// arguments.
std::vector<Eigen::Index> thinned(Eigen::Index count, Eigen::Index most);

// 1 where the temperature rises, 0 where it falls, N. Judged from means over a minute or a 256th of the run,
// whichever is longer; where those stand still, as in a hold, the direction before (or the first after)
// counts.
std::vector<std::uint8_t> heatingFlags(const Eigen::VectorXd &timeS, const Eigen::VectorXd &deltaT);

} // namespace driftbench
