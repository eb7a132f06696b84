// What a model leaves on one axis of every held-out run, against a limit and against the constant: the
// figures behind "write the table", "write only a constant", "no table".
//
// left: sqrt(MSD after), dps. The finding is the worse of two: the verdict of the comparison (verdict.h), and
//   yes        every run within the limit, none better off with the constant
//   with care  every run within the limit, but some better off with the constant
//   no         some run over the limit
// A run is better off with the constant if the model's MSD exceeds the constant's by more than 0.02 of the
// noise floor, as in verdict.h. Without a limit every run is within it.
#pragma once

#include "engine/evaluation/comparison.h"
#include "engine/evaluation/scoring.h"
#include "engine/models/trained_model.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

struct RunLeft
{
    std::string run;
    double leftDps = 0.0;
    double constantDps = std::numeric_limits<double>::quiet_NaN(); // left by the constant; NaN: not compared
    double noiseDps = 0.0;                                         // square root of the noise floor
    bool withinLimit = true;
    bool constantIsBetter = false;
};

struct AxisFinding
{
    int axis = 0;
    std::string model;
    Verdict verdict = Verdict::NotRepeatable;
    std::vector<RunLeft> runs; // in the order of the rows
    std::optional<double> limitDps;

    std::size_t passing() const; // runs within the limit
    std::size_t losing() const;  // runs that are better off with the constant
};

// The model that a verdict is about: the recommended one, or where that is the constant, `fallback`.
std::string judgedModel(const AxisVerdict &verdict, const std::string &fallback);

// judged: the verdict of the comparison for this axis. Runs without a row of the model are left out.
AxisFinding findAxis(const std::vector<ComparisonRow> &rows, int axis, const std::string &model,
                     Verdict judged, std::optional<double> limitDps);

} // namespace driftbench
