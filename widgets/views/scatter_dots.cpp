#include "widgets/views/scatter_dots.h"

#include "widgets/plot/decimation.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr Eigen::Index kExcludedShare = 8; // at most one excluded dot to this many others

static bool usable(const RunFeatures &run, Eigen::Index sample)
{
    const auto at = static_cast<std::size_t>(sample);
    return at >= run.usableForTraining.size() || run.usableForTraining[at] != 0;
}

static void append(ScatterDots::Group &group, double deltaT, double valueDps)
{
    if (!std::isfinite(deltaT) || !std::isfinite(valueDps))
        return;
    group.deltaT.append(deltaT);
    group.valueDps.append(valueDps);
}

// Excluded samples are few and far between: thinned with the rest they would vanish.
static void addExcluded(ScatterDots &dots, const RunFeatures &run, const Eigen::VectorXd &valuesDps,
                        Eigen::Index most)
{
    std::vector<Eigen::Index> excluded;
    for (Eigen::Index i = 0; i < run.deltaT.size(); ++i) {
        if (!usable(run, i))
            excluded.push_back(i);
    }
    for (const Eigen::Index k : thinned(static_cast<Eigen::Index>(excluded.size()), most)) {
        const Eigen::Index i = excluded[static_cast<std::size_t>(k)];
        append(dots.excluded, run.deltaT[i], valuesDps[i]);
    }
}

ScatterDots scatterDots(const std::vector<std::shared_ptr<const RunFeatures>> &runs,
                        const std::vector<Eigen::VectorXd> &valuesDps, Eigen::Index most)
{
    Eigen::Index total = 0;
    for (const auto &run : runs)
        total += run->deltaT.size();
    ScatterDots dots;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const RunFeatures &run = *runs[r];
        const Eigen::Index count = run.deltaT.size();
        const auto heating = heatingFlags(run.timeS, run.deltaT);
        // Each run gets dots by its share of the samples, so that all runs are thinned alike.
        const Eigen::Index share = total > most ? std::max<Eigen::Index>(1, most * count / total) : count;
        for (const Eigen::Index i : thinned(count, share)) {
            if (usable(run, i))
                append(heating[static_cast<std::size_t>(i)] != 0 ? dots.heating : dots.cooling, run.deltaT[i],
                       valuesDps[r][i]);
        }
        addExcluded(dots, run, valuesDps[r], std::max<Eigen::Index>(1, share / kExcludedShare));
    }
    return dots;
}

std::vector<LegendEntry> dotLegend(const ScatterDots &dots, const Palette &palette)
{
    const auto translated = [](const char *text) {
        return QCoreApplication::translate("driftbench::ScatterDots", text);
    };
    std::vector<LegendEntry> entries;
    const auto add = [&](const ScatterDots::Group &group, const QString &text, const QColor &color) {
        if (!group.deltaT.isEmpty())
            entries.push_back({LegendEntry::Kind::Dot, text, QPen(Qt::NoPen), color});
    };
    add(dots.heating, translated(QT_TRANSLATE_NOOP("driftbench::ScatterDots", "Heating")), palette.heating);
    add(dots.cooling, translated(QT_TRANSLATE_NOOP("driftbench::ScatterDots", "Cooling")), palette.cooling);
    add(dots.excluded, translated(QT_TRANSLATE_NOOP("driftbench::ScatterDots", "Excluded")),
        palette.excluded);
    return entries;
}

} // namespace driftbench
