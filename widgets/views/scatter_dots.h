// The dots of several runs, thinned to what a panel can show, by the direction of the temperature.
#pragma once

#include "engine/features/run_features.h"
#include "widgets/plot/legend_element.h"

#include <QVector>

#include <memory>
#include <vector>

namespace driftbench {

struct ScatterDots
{
    struct Group
    {
        QVector<double> deltaT;
        QVector<double> valueDps;
    };
    Group heating, cooling, excluded; // excluded: outliers, kept out of training

    bool empty() const
    {
        return heating.deltaT.isEmpty() && cooling.deltaT.isEmpty() && excluded.deltaT.isEmpty();
    }
};

inline constexpr Eigen::Index kMostDots = 4000; // a panel, excluded ones aside

// valuesDps[r]: as many values as runs[r] has samples. Pairs that are not finite are left out.
ScatterDots scatterDots(const std::vector<std::shared_ptr<const RunFeatures>> &runs,
                        const std::vector<Eigen::VectorXd> &valuesDps, Eigen::Index most = kMostDots);

// Entries for the groups that have dots.
std::vector<LegendEntry> dotLegend(const ScatterDots &dots, const Palette &palette);

} // namespace driftbench
