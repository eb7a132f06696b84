#include "app/cli/log_options.h"

#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "engine/base/text.h"

#include <cmath>
#include <optional>

namespace driftbench::cli {

namespace {

// "time,temperature,x,y,z": names or numbers from 1
void parseColumns(const std::string &text, CsvOptions &csv)
{
    std::size_t start = 0;
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
        const std::size_t comma = text.find(',', start);
        const bool last = i + 1 == csv.columns.size();
        if (last != (comma == std::string::npos))
            throw CLI::ValidationError(
                "--columns", "\"" + text + "\" is not five names or numbers: TIME,TEMPERATURE,X,Y,Z");
        csv.columns[i] = std::string(trimmed(std::string_view(text).substr(start, comma - start)));
        start = comma + 1;
    }
}

char parseSeparator(const std::string &text)
{
    if (text == "tab" || text == "\\t" || text == "\t")
        return '\t';
    if (text == "," || text == "comma")
        return ',';
    if (text == ";" || text == "semicolon")
        return ';';
    throw CLI::ValidationError("--separator", "\"" + text + "\" is not comma, semicolon or tab");
}

template <class Unit>
void addUnitOption(CLI::App &command, const std::string &name, const std::string &known,
                   std::optional<Unit> &unit, std::optional<Unit> (*named)(std::string_view))
{
    const auto parse = [name, known, &unit, named](const std::string &text) {
        unit = named(text);
        if (!unit)
            throw CLI::ValidationError(name, "\"" + text + "\" is none of " + known);
    };
    command.add_option_function<std::string>(name, parse, known + " (default: what the header says)")
        ->type_name("UNIT");
}

TimeRange parseRange(const std::string &text)
{
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
        const auto start = parseNumber(text.substr(0, colon));
        const auto end = parseNumber(text.substr(colon + 1));
        if (start && end && *start <= *end)
            return {*start, *end};
    }
    throw CLI::ValidationError("--exclude", "\"" + text + "\" is not a stretch of time in s, like 120:180.5");
}

} // namespace

void addReadOptions(CLI::App &command, ReadOptions &read)
{
    command.add_option("--instance", read.instance, "Which sensor of the log (see inspect)")->type_name("N");
    command
        .add_option_function<std::string>(
            "--columns", [&read](const std::string &text) { parseColumns(text, read.csv); },
            "Columns of a CSV, by name or by number from 1 (default: by their usual names)")
        ->type_name("TIME,TEMP,X,Y,Z");
    command
        .add_option_function<std::string>(
            "--separator", [&read](const std::string &text) { read.csv.separator = parseSeparator(text); },
            "comma, semicolon or tab (default: from the first line)")
        ->type_name("SEP");
    addUnitOption(command, "--time-unit", "s, ms, us, ns", read.csv.timeUnit, &timeUnitNamed);
    addUnitOption(command, "--rate-unit", "dps, rad/s, mdps, counts", read.csv.rateUnit, &rateUnitNamed);
    addUnitOption(command, "--temperature-unit", "C, K, F", read.csv.temperatureUnit, &temperatureUnitNamed);
    command
        .add_option("--sensitivity", read.csv.sensitivityMdpsPerCount,
                    "Of rates in counts, in mdps per count")
        ->type_name("MDPS");
}

void addSensorOption(CLI::App &command, SensorIdentity &sensor)
{
    const auto parse = [&sensor](const std::string &text) {
        const std::size_t colon = text.find(':');
        sensor.model = text.substr(0, colon);
        sensor.serial = colon == std::string::npos ? "" : text.substr(colon + 1);
    };
    command
        .add_option_function<std::string>(
            "--sensor", parse, "Which sensor measured, for logs that don't say, like I3G4250D:0042")
        ->type_name("MODEL:SERIAL");
}

void addQualityOptions(CLI::App &command, QualityOptions &quality)
{
    const auto exclude = [&quality](const std::vector<std::string> &ranges) {
        for (const std::string &range : ranges)
            quality.excluded.push_back(parseRange(range));
    };
    command
        .add_option_function<std::vector<std::string>>(
            "--exclude", exclude, "Leave a stretch of the log's time out; may be repeated")
        ->type_name("FROM:TO")
        ->allow_extra_args(false);
    command.add_flag("--mask-bad-rows", quality.maskBadRows,
                     "Mask rows whose values or times are bad instead of refusing the log");
    command.add_flag_callback(
        "--force-span", [&quality] { quality.allowSmallSpan = quality.allowShort = true; },
        "Go on with a temperature span or a duration that is too small for a calibration");
}

void addCampaignOptions(CLI::App &command, CampaignRequest &request)
{
    command
        .add_option("RUN", request.files,
                    "Logs of one sensor: CSV, TSV, PX4 ULog, ArduPilot DataFlash; or one session")
        ->required();
    const auto reference = [&request](const std::string &text) {
        if (text == "hold") {
            request.campaign.referenceRate = ReferenceRateKind::InitialHold;
            return;
        }
        request.campaign.referenceRateDps = parseTriple("--reference-rate", text);
    };
    command
        .add_option_function<std::string>(
            "--reference-rate", reference,
            "Rate that was really there, per axis in dps (default 0,0,0), or hold: the "
            "mean of each run's initial hold")
        ->type_name("X,Y,Z");
    const auto temperature = [&request](const std::string &text) {
        request.referenceTemperatureC = parseNumber(text);
        if (!request.referenceTemperatureC || !std::isfinite(*request.referenceTemperatureC))
            throw CLI::ValidationError("--reference-temperature",
                                       "\"" + text + "\" is not a temperature in °C, like -40");
    };
    command
        .add_option_function<std::string>(
            "--reference-temperature", temperature,
            "Temperature in °C at which dT is 0 (default: the initial hold that the runs share, else the "
            "lowest temperature)")
        ->type_name("C");
    addSensorOption(command, request.sensor);
    addQualityOptions(command, request.quality);
    addReadOptions(command, request.read);
}

void printWarnings(const std::string &about, const std::vector<std::string> &warnings)
{
    for (const std::string &warning : warnings)
        printNotice(about.empty() ? warning : about + ": " + warning);
}

void printFindings(const Campaign &campaign)
{
    for (const Run &run : campaign.runs) {
        printWarnings(run.name, run.recording->info.warnings);
        for (const Finding &finding : run.findings) {
            if (finding.severity != FindingSeverity::Note)
                printNotice(run.name + ": " + finding.message);
        }
    }
    printWarnings("", campaign.warnings);
}

} // namespace driftbench::cli
