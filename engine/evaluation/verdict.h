// Whether compensation is worth it on an axis, by what models did on runs they had not seen.
//
// f: noise floor of a held-out run; E0, E1: MSD of the constant and of the model there, less f (anchored: and
// less f / n of the start). G = 1 - sum E1 / sum E0. A run is worse if E1 > E0 + 0.02 f.
//   yes        mean E0 > 0.001 f, G >= 0.75, no run worse
//   with care  mean E0 > 0.001 f, G >= 0.5, at most floor(R / 3) runs worse; the best for a single run
//   no drift   else, if within a run the bias varies over temperature by no more than 0.02 f (variance)
//   not repeatable  else
#pragma once

#include "engine/models/trained_model.h"

#include <string>
#include <vector>

namespace driftbench {

// One model on one axis of one held-out run.
struct HeldOutError
{
    std::string run;
    double constantMsd = 0.0; // dps^2, of what the constant leaves
    double modelMsd = 0.0;
    double floor = 0.0;       // f
    double anchorNoise = 0.0; // f / n_start where judging is anchored, else 0

    double constantError() const { return constantMsd - floor - anchorNoise; } // E0
    double modelError() const { return modelMsd - floor - anchorNoise; }       // E1
    bool worse() const;
};

struct AxisEvidence
{
    std::vector<HeldOutError> heldOut;
    double inRunVariance = 0.0; // dps^2, over temperature, noise removed
    bool singleRun = false;     // the held-out parts are blocks of one run
};

struct Judgement
{
    Verdict verdict = Verdict::NotRepeatable;
    double gain = 0.0; // G; 0 where the constant leaves nothing
    int worse = 0;     // held-out runs
};

Judgement judge(const AxisEvidence &evidence);

} // namespace driftbench
