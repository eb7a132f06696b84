// The seven steps of a calibration, in the order of the rail, and what the rail says of each.
#pragma once

#include <QString>

#include <array>

namespace driftbench {

enum class Step
{
    Source,
    Plan,
    Record,
    Inspect,
    Train,
    Compare,
    Export
};

inline constexpr std::array<Step, 7> kSteps{Step::Source, Step::Plan,    Step::Record, Step::Inspect,
                                            Step::Train,  Step::Compare, Step::Export};

enum class StepMark
{
    None,
    Done,      // check
    Warning,   // warn
    Recording, // red dot
    Working    // half
};

struct StepState
{
    QString note;       // what the step holds: "5 runs"; before it holds anything, what it is for
    bool holds = false; // a step that holds nothing is muted
    StepMark mark = StepMark::None;
};

QString stepName(Step step);
QString stepPurpose(Step step); // the note of a step that holds nothing: "Fit models"
QString stepIcon(Step step);

} // namespace driftbench
