#include "app/cli/inspection_text.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width)
{
    // Only ASCII is padded here; the few signs beyond it stand at line ends.
    if (text.size() < width)
        text.insert(0, width - text.size(), ' ');
    return text;
}

std::string figure(double value, int decimals)
{
    return std::isfinite(value) ? fixed(value, decimals) : std::string("unknown");
}

std::string_view severityName(FindingSeverity severity)
{
    switch (severity) {
    case FindingSeverity::Note:
        return "note";
    case FindingSeverity::Warning:
        return "warning";
    case FindingSeverity::Refusal:
        return "refusal";
    }
    return "";
}

Json finite(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

std::string axesAsText(const RunReport &report)
{
    std::string text = "  axis   mean dps    from dps      to dps   noise dps (cells, differences)\n";
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const AxisReport &of = report.axes[axis];
        text += "  " + std::string(kAxisNames[axis]) + padded(figure(of.meanDps, 4), 14) +
                padded(figure(of.lowestDps, 4), 12) + padded(figure(of.highestDps, 4), 12) +
                padded(figure(of.noiseWithinCellDps, 4), 12) + padded(figure(of.noiseDifferencesDps, 4), 10) +
                "\n";
    }
    return text;
}

std::string maskedAsText(const RunReport &report)
{
    std::string text;
    for (const MaskCount &count : report.masked) {
        text += text.empty() ? "masked       " : ", ";
        text += std::to_string(count.samples) + " " + std::string(maskReasonName(count.reason)) + " (" +
                fixed(count.percent, 2) + " %)";
    }
    return text.empty() ? text : text + "\n";
}

Json axesToJson(const RunReport &report)
{
    Json axes = Json::array();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const AxisReport &of = report.axes[axis];
        axes.push_back({{"axis", std::string(kAxisNames[axis])},
                        {"mean_dps", finite(of.meanDps)},
                        {"lowest_dps", finite(of.lowestDps)},
                        {"highest_dps", finite(of.highestDps)},
                        {"noise_within_cell_dps", finite(of.noiseWithinCellDps)},
                        {"noise_differences_dps", finite(of.noiseDifferencesDps)}});
    }
    return axes;
}

Json findingsToJson(const std::vector<Finding> &findings)
{
    Json list = Json::array();
    for (const Finding &finding : findings) {
        list.push_back({{"severity", std::string(severityName(finding.severity))},
                        {"kind", finding.kind},
                        {"message", finding.message},
                        {"start_s", finite(finding.startS)},
                        {"end_s", finite(finding.endS)}});
    }
    return list;
}

} // namespace

std::string instancesAsText(const std::string &file, const std::vector<LogInstance> &instances)
{
    std::string text = file + " holds " + std::to_string(instances.size()) + " gyros:\n";
    for (const LogInstance &instance : instances) {
        text += "  " + std::to_string(instance.instance) + "  " + instance.name + "  " +
                std::to_string(instance.samples) + " samples, " + fixed(instance.durationS, 1) + " s at " +
                fixed(instance.meanRateHz(), 2) + " Hz, ";
        text += instance.hasTemperature() ? fixed(instance.lowestTemperatureC, 1) + " to " +
                                                fixed(instance.highestTemperatureC, 1) + " °C"
                                          : std::string("no temperature");
        text += (instance.sensor.known() ? ", " + instance.sensor.text() : "") + "\n";
    }
    return text;
}

Json instancesToJson(const std::vector<LogInstance> &instances)
{
    Json list = Json::array();
    for (const LogInstance &instance : instances) {
        list.push_back({{"instance", instance.instance},
                        {"name", instance.name},
                        {"sensor", {{"model", instance.sensor.model}, {"serial", instance.sensor.serial}}},
                        {"samples", instance.samples},
                        {"start_s", finite(instance.startS)},
                        {"duration_s", finite(instance.durationS)},
                        {"rate_hz", finite(instance.meanRateHz())},
                        {"lowest_temperature_C", finite(instance.lowestTemperatureC)},
                        {"highest_temperature_C", finite(instance.highestTemperatureC)}});
    }
    return list;
}

std::string inspectionAsText(const Inspection &inspection)
{
    const RunReport &report = inspection.report;
    std::string text = inspection.file + "\n";
    text += "format       " + inspection.info.format + ", instance " +
            std::to_string(inspection.info.instance) + ", " + inspection.info.sensor.text() +
            (inspection.info.simulated ? ", simulated data" : "") + "\n";
    text += "samples      " + std::to_string(report.samples) + ", usable " +
            std::to_string(report.usableForJudging) + ", for training " +
            std::to_string(report.usableForTraining) + "\n";
    text += "time         " + fixed(report.durationS, 1) + " s from " + fixed(report.startS, 3) + " s, " +
            fixed(report.sampleRateHz, 2) + " Hz\n";
    text += "temperature  " + fixed(report.lowestTemperatureC, 1) + " to " +
            fixed(report.highestTemperatureC, 1) + " °C; heats up to " +
            fixed(report.largestHeatingCPerMin, 1) + ", cools up to " +
            fixed(report.largestCoolingCPerMin, 1) + " °C/min; " +
            fixed(100.0 * report.heatedAndCooledPart, 0) + " % heated and cooled\n";
    text += maskedAsText(report) + axesAsText(report);
    for (const std::string &warning : inspection.info.warnings)
        text += "warning      " + warning + "\n";
    for (const Finding &finding : inspection.findings)
        text += std::string(severityName(finding.severity)) +
                std::string(13 - severityName(finding.severity).size(), ' ') + finding.message + "\n";
    text += inspection.refusal ? "verdict      can't be calibrated\n" : "verdict      can be calibrated\n";
    return text;
}

Json inspectionToJson(const Inspection &inspection)
{
    const RunReport &report = inspection.report;
    Json coverage = Json::array();
    for (const CoverageCell &cell : report.coverage)
        coverage.push_back(
            {{"temperature_C", cell.centreC}, {"heating_s", cell.heatingS}, {"cooling_s", cell.coolingS}});
    Json masked = Json::object();
    for (const MaskCount &count : report.masked)
        masked[std::string(maskReasonName(count.reason))] = count.samples;
    return {{"file", inspection.file},
            {"format", inspection.info.format},
            {"instance", inspection.info.instance},
            {"sensor", {{"model", inspection.info.sensor.model}, {"serial", inspection.info.sensor.serial}}},
            {"simulated", inspection.info.simulated},
            {"samples", report.samples},
            {"usable", report.usableForJudging},
            {"usable_for_training", report.usableForTraining},
            {"start_s", finite(report.startS)},
            {"duration_s", finite(report.durationS)},
            {"rate_hz", finite(report.sampleRateHz)},
            {"lowest_temperature_C", finite(report.lowestTemperatureC)},
            {"highest_temperature_C", finite(report.highestTemperatureC)},
            {"masked", masked},
            {"axes", axesToJson(report)},
            {"coverage", coverage},
            {"warnings", inspection.info.warnings},
            {"findings", findingsToJson(inspection.findings)},
            {"can_be_calibrated", !inspection.refusal}};
}

} // namespace driftbench::cli
