// A verdict in words, with its figures.
#pragma once

#include "engine/evaluation/hysteresis.h"
#include "engine/evaluation/repeatability.h"
#include "engine/evaluation/scoring.h"
#include "engine/evaluation/verdict.h"

#include <string>

namespace driftbench {

struct ReasonFacts
{
    int axis = 0;
    std::string model; // that is judged
    const AxisEvidence &evidence;
    const Judgement &judgement;
    const Hysteresis &hysteresis;
    const Repeatability &repeatability;
    Judging judging = Judging::Absolute;
};

// "On x the bias is not a repeatable function of temperature: at 40 degrees C the runs read -3.99, -4.21 and
// -3.42 dps; on run1 compensation does harm, 0.168 -> 0.306 dps rms." with the signs and arrows of print.
std::string reasonFor(const ReasonFacts &facts);

// Where there is nothing but the constant.
std::string reasonWithoutModel(int axis);

} // namespace driftbench
