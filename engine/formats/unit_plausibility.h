// Whether rates and times look as if they were in another unit than the one they were read in.
//
// White noise of standard deviation s gives first differences of standard deviation s * sqrt(2); slow drift
// hardly adds to them. The noise of a MEMS gyro at its logged rate lies between about 2 mdps and 2 dps: what
// reads far below in dps was probably rad/s, what reads far above mdps or counts. No noise at all (a constant
// column, an exact simulation) says nothing.
#pragma once

#include "engine/formats/sample_block.h"

#include <array>
#include <string>
#include <vector>

namespace driftbench {

class UnitPlausibility
{
public:
    // Only the first samples are looked at: one cheap pass, whatever the length of the log.
    static constexpr std::int64_t kSamplesLookedAt = 65536;

    void add(const SampleBlock &block);

    // Sentences, for info.warnings. rateUnitStated: the log or the user states the unit of the rates.
    std::vector<std::string> warnings(const std::string &file, bool rateUnitStated) const;

    std::array<double, 3> noiseDps() const; // NaN with under two samples
    double medianStepS() const;             // of the first block; NaN with under two samples

private:
    std::int64_t m_differences = 0;
    std::array<double, 3> m_sumOfSquares{};
    std::vector<double> m_stepsS;
};

} // namespace driftbench
