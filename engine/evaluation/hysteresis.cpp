#include "engine/evaluation/hysteresis.h"

#include "engine/evaluation/sweeps.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace driftbench {

namespace {

constexpr int kCellFactor = 50; // of the thermal curve's 0.02 degrees: 1 degree
constexpr double kNearC = 1.0;
constexpr double kFewestSamples = 3.0;

struct Sum
{
    double count = 0.0;
    Eigen::Vector3d tdeDps = Eigen::Vector3d::Zero();
};

// One sweep's TDE around the multiples of a step of temperature.
struct PassageSums
{
    std::string run;
    bool heating = true;
    std::map<int, Sum> byStep;
};

double stepOf(const TrainingSet &set)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto &run : set.runs) {
        if (run->deltaT.size() == 0)
            continue;
        low = std::min(low, run->deltaT.minCoeff());
        high = std::max(high, run->deltaT.maxCoeff());
    }
    return high - low >= 20.0 ? 5.0 : 1.0;
}

PassageSums sumAroundSteps(const std::string &run, bool heating, const ThermalCurve &curve, double referenceC,
                           double stepC)
{
    PassageSums sums{run, heating, {}};
    for (const ThermalCell &cell : curve.cells()) {
        if (cell.count == 0.0)
            continue;
        const double temperatureC = cell.meanDeltaT() + referenceC;
        const double nearest = std::round(temperatureC / stepC);
        if (std::abs(temperatureC - nearest * stepC) > kNearC)
            continue;
        Sum &sum = sums.byStep[static_cast<int>(nearest)];
        sum.count += cell.count;
        sum.tdeDps += cell.sumTdeDps;
    }
    std::erase_if(sums.byStep, [](const auto &entry) { return entry.second.count < kFewestSamples; });
    return sums;
}

void findMeeting(Hysteresis &result, const std::vector<PassageSums> &passages, double stepC)
{
    std::map<int, int> met;
    int most = 0;
    for (const PassageSums &passage : passages) {
        for (const auto &[step, sum] : passage.byStep)
            most = std::max(most, ++met[step]);
    }
    if (most < 2)
        return;
    std::erase_if(met, [most](const auto &entry) { return entry.second < most; });
    const auto middle = static_cast<std::ptrdiff_t>((met.size() - 1) / 2);
    const int step = std::next(met.begin(), middle)->first;
    result.meetingTemperatureC = step * stepC;
    for (const PassageSums &passage : passages) {
        const auto found = passage.byStep.find(step);
        if (found != passage.byStep.end())
            result.passages.push_back(
                {passage.run, passage.heating, found->second.tdeDps / found->second.count});
    }
}

void compareDirections(Hysteresis &result, const ThermalCurve &heating, const ThermalCurve &cooling)
{
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    double common = 0.0;
    for (std::size_t i = 0; i < heating.cells().size(); ++i) {
        const auto j = heating.firstKey() + static_cast<std::int64_t>(i) - cooling.firstKey();
        if (j < 0 || j >= static_cast<std::int64_t>(cooling.cells().size()))
            continue;
        const ThermalCell &up = heating.cells()[i];
        const ThermalCell &down = cooling.cells()[static_cast<std::size_t>(j)];
        if (up.count < kFewestSamples || down.count < kFewestSamples)
            continue;
        squares += (up.meanTdeDps() - down.meanTdeDps()).cwiseAbs2();
        common += 1.0;
    }
    result.heatingAndCooling = common > 0.0;
    if (result.heatingAndCooling)
        result.rmsDps = (squares / common).cwiseSqrt();
}

} // namespace

Hysteresis analyseHysteresis(const TrainingSet &set)
{
    const double stepC = stepOf(set);
    ThermalCurve heating;
    ThermalCurve cooling;
    std::vector<PassageSums> passages;
    for (const auto &run : set.runs) {
        for (const Sweep &sweep : sweepsOf(*run)) {
            const ThermalCurve curve = curveOf(*run, sweep);
            (sweep.heating ? heating : cooling).merge(curve);
            passages.push_back(
                sumAroundSteps(run->name, sweep.heating, curve, set.referenceTemperatureC, stepC));
        }
    }
    Hysteresis result;
    compareDirections(result, heating.coarsened(kCellFactor), cooling.coarsened(kCellFactor));
    findMeeting(result, passages, stepC);
    return result;
}

} // namespace driftbench
