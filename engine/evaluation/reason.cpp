#include "engine/evaluation/reason.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace driftbench {

namespace {

constexpr std::size_t kMostReadingsListed = 6;

// Three decimals, more where these would hide the figure.
std::string rmsText(double rmsDps)
{
    const int decimals = rmsDps >= 0.01 || rmsDps <= 0.0
                             ? 3
                             : std::min(6, 1 - static_cast<int>(std::floor(std::log10(rmsDps))));
    return forReading(rmsDps, decimals);
}

std::string percent(double fraction)
{
    return forReading(100.0 * fraction, 0) + " %";
}

std::string fromTo(const HeldOutError &run)
{
    return rmsText(std::sqrt(run.constantMsd)) + " \u2192 " + rmsText(std::sqrt(run.modelMsd)) + " dps rms";
}

std::string onAxis(const ReasonFacts &facts)
{
    std::string text = "On " + std::string(kAxisNames[static_cast<std::size_t>(facts.axis)]);
    if (facts.judging == Judging::Anchored)
        text += ", with each run's bias at its start removed,";
    return text + ' ';
}

// The run on which the model does most harm, in units of its noise; null if on none.
const HeldOutError *worstRun(const AxisEvidence &evidence)
{
    const auto harm = [](const HeldOutError &run) { return (run.modelMsd - run.constantMsd) / run.floor; };
    const HeldOutError *worst = nullptr;
    for (const HeldOutError &run : evidence.heldOut) {
        if (run.worse() && (worst == nullptr || harm(run) > harm(*worst)))
            worst = &run;
    }
    return worst;
}

std::string leaves(const ReasonFacts &facts)
{
    double constantMsd = 0.0;
    double modelMsd = 0.0;
    const auto runs = static_cast<double>(facts.evidence.heldOut.size());
    for (const HeldOutError &run : facts.evidence.heldOut) {
        constantMsd += run.constantMsd / runs;
        modelMsd += run.modelMsd / runs;
    }
    return facts.model + " leaves " + rmsText(std::sqrt(modelMsd)) + " dps rms where the constant leaves " +
           rmsText(std::sqrt(constantMsd));
}

std::string takesAway(const ReasonFacts &facts)
{
    if (facts.judgement.gain <= 0.0)
        return facts.model + " takes away nothing of what the constant leaves";
    return facts.model + " takes away only " + percent(facts.judgement.gain) + " of what the constant leaves";
}

std::string joined(const std::vector<std::string> &parts)
{
    std::string text = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i)
        text += (i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

// "at 40 degrees C the runs read ..."; empty where no two passages meet.
std::string readings(const ReasonFacts &facts)
{
    const std::vector<Passage> &passages = facts.hysteresis.passages;
    if (passages.size() < 2)
        return {};
    std::vector<double> values;
    bool sweeps = false;
    for (std::size_t i = 0; i < passages.size(); ++i) {
        values.push_back(passages[i].tdeDps[facts.axis]);
        sweeps = sweeps || (i > 0 && passages[i].run == passages[i - 1].run);
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const int decimals = *high - *low >= 0.05 ? 2 : *high - *low >= 0.005 ? 3 : 4;
    std::string text = "at " + forReading(facts.hysteresis.meetingTemperatureC, 0) + " \u00b0C the " +
                       (sweeps ? "sweeps" : "runs") + " read ";
    if (values.size() > kMostReadingsListed)
        return text + "from " + forReading(*low, decimals) + " to " + forReading(*high, decimals) + " dps";
    std::vector<std::string> listed;
    for (const double value : values)
        listed.push_back(forReading(value, decimals));
    return text + joined(listed) + " dps";
}

std::string repeatSentence(const ReasonFacts &facts)
{
    const double repeat = facts.repeatability.repeatRmsDps[facts.axis];
    if (!std::isfinite(repeat))
        return {};
    const double curve = facts.repeatability.curveRmsDps[facts.axis];
    const std::string differ = std::string(facts.repeatability.sweeps ? " Sweeps" : " Runs") + " differ by " +
                               rmsText(repeat) + " dps rms at the same temperature";
    if (curve == 0.0)
        return differ + " and share no curve.";
    return differ + "; the curve they share moves by " + rmsText(curve) + " dps rms.";
}

std::string yes(const ReasonFacts &facts)
{
    return onAxis(facts) + "the bias is a repeatable function of temperature: " + leaves(facts) +
           ", and no held-out run gets worse.";
}

std::string withCare(const ReasonFacts &facts)
{
    std::string text = onAxis(facts) + "compensation helps, but use it with care: " + leaves(facts);
    if (facts.evidence.singleRun)
        return text + ", but there is only one run, and nothing shows that another repeats it.";
    if (const HeldOutError *worst = worstRun(facts.evidence))
        return text + ", but on " + worst->run + " it does harm, " + fromTo(*worst) + '.' +
               repeatSentence(facts);
    return text + ", " + percent(1.0 - facts.judgement.gain) + " of the drift stays." + repeatSentence(facts);
}

std::string notRepeatable(const ReasonFacts &facts)
{
    std::vector<std::string> clauses;
    if (std::string text = readings(facts); !text.empty())
        clauses.push_back(std::move(text));
    if (const HeldOutError *worst = worstRun(facts.evidence))
        clauses.push_back("on " + worst->run + " compensation does harm, " + fromTo(*worst));
    else
        clauses.push_back(takesAway(facts));
    std::string text =
        onAxis(facts) + "the bias is not a repeatable function of temperature: " + clauses.front();
    for (std::size_t i = 1; i < clauses.size(); ++i)
        text += "; " + clauses[i];
    return text + '.' + repeatSentence(facts);
}

std::string noDrift(const ReasonFacts &facts)
{
    double floor = 0.0;
    for (const HeldOutError &run : facts.evidence.heldOut)
        floor += run.floor / static_cast<double>(facts.evidence.heldOut.size());
    const double drift = std::sqrt(std::max(0.0, facts.evidence.inRunVariance));
    return onAxis(facts) + "there is no temperature drift to remove: within a run the bias moves by " +
           rmsText(drift) + " dps rms with temperature, in noise of " + rmsText(std::sqrt(floor)) +
           " dps rms.";
}

} // namespace

std::string reasonFor(const ReasonFacts &facts)
{
    switch (facts.judgement.verdict) {
    case Verdict::Yes:
        return yes(facts);
    case Verdict::WithCare:
        return withCare(facts);
    case Verdict::NotRepeatable:
        return notRepeatable(facts);
    case Verdict::NoDrift:
        return noDrift(facts);
    }
    return {};
}

std::string reasonWithoutModel(int axis)
{
    return "On " + std::string(kAxisNames[static_cast<std::size_t>(axis)]) +
           " no model of temperature was compared with the constant.";
}

} // namespace driftbench
