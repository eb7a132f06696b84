#include "engine/exports/export_text.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/compensation/axis_selection.h"

#include <charconv>

namespace driftbench {

namespace {

bool mustPart(char left, char right)
{
    return (left == '*' && right == '/') || (left == '/' && right == '*') || (left == '?' && right == '?');
}

std::string joined(const std::vector<std::string> &names)
{
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string axisLine(const TableProvenance &provenance, std::size_t axis, bool compensated)
{
    std::string line = "axis " + std::string(kAxisNames[axis]) + ": ";
    line += compensated ? "compensated" : "not compensated, zero";
    line += "; verdict " + verdictText(provenance.verdicts[axis]);
    if (!provenance.judging.empty())
        line += " (" + provenance.judging + ")";
    return provenance.reasons[axis].empty() ? line : line + ": " + provenance.reasons[axis];
}

} // namespace

std::string forComment(std::string_view text)
{
    std::string clean;
    for (const char c : text) {
        const char shown = (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? ' ' : c;
        if (!clean.empty() && mustPart(clean.back(), shown))
            clean += ' ';
        clean += shown;
    }
    // A backslash at the end of a line would join it with the next.
    while (!clean.empty() && (clean.back() == '\\' || clean.back() == ' '))
        clean.pop_back();
    return clean;
}

std::vector<std::string> provenanceLines(const TableProvenance &provenance,
                                         const std::array<bool, 3> &compensated)
{
    std::vector<std::string> lines;
    if (provenance.simulated)
        lines.emplace_back("SIMULATED: trained on simulated data, not for use in a device");
    lines.push_back("sensor: " + provenance.sensor.text());
    lines.push_back("model: " + provenance.modelName + ", reference temperature " +
                    fixed(provenance.referenceTemperatureC, 3) + " deg C");
    lines.push_back("trained from " + fixed(provenance.lowestTemperatureC, 3) + " to " +
                    fixed(provenance.highestTemperatureC, 3) + " deg C; outside, the edge value is held");
    lines.push_back("trained on: " + joined(provenance.trainedOn));
    for (std::size_t axis = 0; axis < compensated.size(); ++axis)
        lines.push_back(axisLine(provenance, axis, compensated[axis]));
    return lines;
}

std::string commented(const std::vector<std::string> &lines, std::string_view prefix)
{
    std::string text;
    for (const std::string &line : lines)
        text.append(prefix).append(forComment(line)).append("\n");
    return text;
}

std::string shortestFloat(float value)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

} // namespace driftbench
