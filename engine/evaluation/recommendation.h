// Which model of temperature to take on an axis.
#pragma once

#include "engine/evaluation/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct Candidate
{
    std::string name;
    int complexity = 0;
    Judgement judgement;
    std::vector<double> loss; // per held-out run: MSD after in units of the run's noise floor
};

// The simplest of the candidates that are within one paired standard error (over the held-out runs) of the
// one with the lowest mean loss and whose verdict is as good as its. Nothing of an empty list. With one
// held-out run there is no standard error, and 1e-4 of the noise variance takes its place.
std::optional<std::size_t> recommended(const std::vector<Candidate> &candidates);

} // namespace driftbench
