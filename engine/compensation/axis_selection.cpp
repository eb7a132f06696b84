#include "engine/compensation/axis_selection.h"

#include "engine/base/axes.h"

#include <algorithm>

namespace driftbench {

namespace {

bool hasYes(const TrainedModel &model, std::size_t axis)
{
    return model.verdicts[axis] == Verdict::Yes;
}

// "x (not repeatable: at 40 C the runs read ...)"
std::string describe(const TrainedModel &model, std::size_t axis)
{
    std::string text = std::string(kAxisNames[axis]) + " (" + verdictText(model.verdicts[axis]);
    // The reason stands inside a sentence, so its own full stop goes.
    std::string reason = model.reasons[axis];
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
        reason.pop_back();
    return reason.empty() ? text + ")" : text + ": " + reason + ")";
}

std::string describeAll(const TrainedModel &model, const std::vector<std::size_t> &axes)
{
    std::string text;
    for (const std::size_t axis : axes)
        text += (text.empty() ? "" : ", ") + describe(model, axis);
    return text;
}

Error forbidden(const TrainedModel &model, const std::vector<std::size_t> &axes)
{
    return {Errc::VerdictForbids,
            "Model " + model.name + " must not compensate without a verdict of yes, which is missing on " +
                describeAll(model, axes) + "; record more runs, leave the axis out, or use --force."};
}

} // namespace

std::string verdictText(const std::optional<Verdict> &verdict)
{
    return verdict ? std::string(verdictName(*verdict)) : "never judged";
}

Result<AxisSelection> selectAxes(const TrainedModel &model, const std::optional<std::array<bool, 3>> &wanted,
                                 bool force)
{
    if (wanted && std::none_of(wanted->begin(), wanted->end(), [](bool w) { return w; }))
        return Error{Errc::InvalidOption, "No axis was chosen; name at least one of x, y and z."};

    AxisSelection selection;
    std::vector<std::size_t> withoutYes;
    std::vector<std::size_t> forced;
    std::vector<std::size_t> leftOut;
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        const bool yes = hasYes(model, axis);
        const bool asked = wanted ? (*wanted)[axis] : (yes || force);
        selection.compensated[axis] = asked;
        if (asked && !yes)
            (force ? forced : withoutYes).push_back(axis);
        if (!asked)
            leftOut.push_back(axis);
    }
    if (!withoutYes.empty())
        return forbidden(model, withoutYes);
    if (leftOut.size() == kAxisNames.size())
        return forbidden(model, leftOut);
    if (!forced.empty())
        selection.notes.push_back("Compensated by force: " + describeAll(model, forced) + ".");
    if (!leftOut.empty())
        selection.notes.push_back("Not compensated: " + describeAll(model, leftOut) + ".");
    return selection;
}

} // namespace driftbench
