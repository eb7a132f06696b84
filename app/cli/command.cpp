#include "app/cli/command.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace driftbench::cli {

namespace {

// In the order in which a calibration uses them.
constexpr std::array<AddCommand, 13> kCommands{
    addPlanCommand,   addDevicesCommand,  addRecordCommand,   addSimulateCommand, addInspectCommand,
    addFitCommand,    addEvaluateCommand, addApplyCommand,    addExportCommand,   addSessionCommand,
    addDeviceCommand, addPhysicsCommand,  addReproduceCommand};

// "25,5,53"
std::optional<Eigen::Vector3d> threeNumbers(std::string_view text)
{
    Eigen::Vector3d triple;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const bool last = axis + 1 == kAxisCount;
        const auto comma = text.find(',');
        if (last != (comma == std::string_view::npos))
            return std::nullopt;
        const auto value = parseNumber(text.substr(0, comma));
        if (!value || !std::isfinite(*value))
            return std::nullopt;
        triple[axis] = *value;
        text.remove_prefix(last ? text.size() : comma + 1);
    }
    return triple;
}

} // namespace

std::span<const AddCommand> allCommands()
{
    return kCommands;
}

CLI::App *addCommand(CLI::App &program, const std::string &name, const std::string &description,
                     const std::string &example)
{
    CLI::App *command = program.add_subcommand(name, description);
    command->footer("Example:\n  " + example);
    return command;
}

void addJsonOption(CLI::App &command, bool &json)
{
    command.add_flag("--json", json, "Print the outcome as JSON, for machines");
}

void addSeedOption(CLI::App &command, std::uint64_t &seed)
{
    // By hand: the library would take -1 for a very large number.
    const auto parse = [&seed](const std::string &text) {
        const char *end = text.data() + text.size();
        const auto [parsed, code] = std::from_chars(text.data(), end, seed);
        if (code != std::errc() || parsed != end)
            throw CLI::ValidationError("--seed", "\"" + text + "\" is not a whole number from 0 to 2^64 - 1");
    };
    command
        .add_option_function<std::string>("--seed", parse,
                                          "The same seed, options and input give the same files (default " +
                                              std::to_string(seed) + ")")
        ->type_name("N");
}

void addJudgeOption(CLI::App &command, Judging &judging)
{
    const auto parse = [&judging](const std::string &text) {
        const auto named = judgingFromName(text);
        if (!named)
            throw CLI::ValidationError("--judge", "\"" + text + "\" is neither absolute nor anchored");
        judging = *named;
    };
    command
        .add_option_function<std::string>(
            "--judge", parse,
            "absolute (default): the turn-on bias counts; anchored: each run's bias at its start is removed")
        ->type_name("HOW");
}

Result<std::array<bool, 3>> axesNamed(const std::string &text)
{
    std::array<bool, 3> axes{};
    for (const char c : text) {
        if (c == ',')
            continue;
        const std::size_t axis = std::string_view("xyz").find(c);
        if (axis == std::string_view::npos)
            return Error{Errc::InvalidOption,
                         "--axes \"" + text + "\" names no axes. Say x, y and z with commas."};
        axes[axis] = true;
    }
    return axes;
}

Eigen::Vector3d parseTriple(const std::string &option, const std::string &text)
{
    const auto triple = threeNumbers(text);
    if (!triple) {
        throw CLI::ValidationError(
            option, "\"" + text + "\" is not three numbers with commas between them, like 25,5,53");
    }
    return *triple;
}

void addReferenceRateOption(CLI::App &command, Eigen::Vector3d &referenceRateDps)
{
    const auto parse = [&referenceRateDps](const std::string &text) {
        referenceRateDps = parseTriple("--reference-rate", text);
    };
    command
        .add_option_function<std::string>("--reference-rate", parse,
                                          "Rate that was really there, per axis in dps (default 0,0,0)")
        ->type_name("X,Y,Z");
}

} // namespace driftbench::cli
