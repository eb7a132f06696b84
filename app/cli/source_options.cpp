#include "app/cli/source_options.h"

#include "app/cli/command.h"
#include "app/cli/log_options.h"

namespace driftbench::cli {

namespace {

Error invalid(std::string message)
{
    return {Errc::InvalidOption, std::move(message)};
}

// Options of one kind of source, taken down until it is known which is meant.
class KindOptions
{
public:
    KindOptions(CLI::App &command, std::string kind, std::vector<SourceArguments::ForKind> &given)
        : m_command(command), m_kind(std::move(kind)), m_given(given)
    {
        m_command.option_defaults()->group("Source " + m_kind);
    }

    template <class Kind, class Field, class Value = Field>
    void add(const std::string &name, const char *unit, Field Kind::*field, const std::string &description)
    {
        const auto take = [name, kind = m_kind, given = &m_given, field](const Value &value) {
            given->push_back(
                {name, kind, [field, value](SourceChoice &choice) { choice.as<Kind>()->*field = value; }});
        };
        m_command.add_option_function<Value>(name, take, description)->type_name(unit);
    }

private:
    CLI::App &m_command;
    std::string m_kind;
    std::vector<SourceArguments::ForKind> &m_given;
};

void addSimulatedOptions(CLI::App &command, SourceArguments &arguments)
{
    KindOptions options(command, "simulated", arguments.given);
    command
        .add_option("--profile", arguments.profile,
                    "Temperature profile of its chamber, if there is no plan (default: paper)")
        ->type_name("NAME");
    const auto reference = [&arguments](const std::string &text) {
        arguments.referenceRateDps = parseTriple("--reference-rate", text);
    };
    command
        .add_option_function<std::string>("--reference-rate", reference,
                                          "Rate that is really there, per axis in dps (default 0,0,0)")
        ->type_name("X,Y,Z");
    const auto run = [&arguments](int number) {
        if (number < 1)
            throw CLI::ValidationError("--run", "runs count from 1");
        arguments.given.push_back({"--run", "simulated", [number](SourceChoice &choice) {
                                       choice.as<SimulatedChoice>()->run = number - 1;
                                   }});
    };
    command
        .add_option_function<int>("--run", run, "Which run of the campaign, from 1: each has its own noise")
        ->type_name("N");
    options.add("--seed", "N", &SimulatedChoice::seed, "The same seed and options give the same samples");
    options.add<SimulatedChoice, std::optional<double>, double>(
        "--noise", "DPS", &SimulatedChoice::noiseDps, "Standard deviation of the white noise in dps");
    options.add<SimulatedChoice, std::optional<double>, double>(
        "--spread", "FRACTION", &SimulatedChoice::spread,
        "Relative standard deviation of the drift between runs");
    options.add("--clock-error", "PPM", &SimulatedChoice::clockErrorPpm,
                "By how much the device's clock runs fast");
    options.add<SimulatedChoice, std::filesystem::path, std::string>(
        "--flash", "FILE", &SimulatedChoice::flashFile,
        "File that keeps the device's tables from one command to the next");
}

void addI2cOptions(CLI::App &command, SourceArguments &arguments)
{
    KindOptions options(command, "i2c", arguments.given);
    options.add("--gyro-serial", "NAME", &I2cChoice::gyroSerial,
                "Which gyro it is, as the gyro itself can't say");
    options.add("--bus-speed", "KHZ", &I2cChoice::busKHz, "Speed of the I2C bus (default 400)");
    options.add("--die-offset", "C", &I2cChoice::dieOffsetC,
                "Temperature of the die at count 0 (default 0: its temperatures are relative)");
    options.add("--die-scale", "C", &I2cChoice::dieCPerCount,
                "Degrees per count of the die's thermometer (default -1)");
}

Status takeThermometer(SourceChoice &choice, const std::string &name)
{
    if (name.empty())
        return {};
    if (name == "auto")
        choice.thermometer = ThermometerChoice::Automatic;
    else if (name == "external")
        choice.thermometer = ThermometerChoice::External;
    else if (name == "die")
        choice.thermometer = ThermometerChoice::Die;
    else
        return invalid("There is no thermometer \"" + name + "\"; say auto, external or die.");
    return {};
}

Status takeSpeed(SourceChoice &choice, double speed)
{
    if (auto *simulated = choice.as<SimulatedChoice>())
        simulated->speed = speed;
    else if (auto *file = choice.as<FileChoice>())
        file->speed = speed;
    else
        return invalid("--speed is for the sources simulated and file; a real device can't be hurried.");
    return {};
}

Status takeChamber(SourceChoice &choice, const SourceArguments &arguments,
                   const std::optional<TestPlan> &plan)
{
    auto *simulated = choice.as<SimulatedChoice>();
    if (!simulated)
        return arguments.profile || arguments.referenceRateDps
                   ? invalid("--profile and --reference-rate are for the source simulated.")
                   : Status();
    if (plan && arguments.profile)
        return invalid("--plan and --profile both say what the chamber does; give one of them.");
    if (plan || arguments.profile) {
        auto profile = plan ? plan->profile() : TemperatureProfile::named(*arguments.profile);
        if (!profile)
            return profile.error();
        simulated->profile = *std::move(profile);
    }
    simulated->referenceRateDps = arguments.referenceRateDps.value_or(simulated->referenceRateDps);
    return {};
}

std::string kindOf(const SourceChoice &choice)
{
    const std::string text = sourceChoiceText(choice);
    return text.substr(0, text.find(':'));
}

// Only options of the source's own kind were given.
Status fits(const SourceChoice &choice, const SourceArguments &arguments)
{
    const std::string kind = kindOf(choice);
    const auto wrong = [&arguments](const std::string &option, const std::string &its) {
        return invalid(option + " is for the source " + its + ", and the source is " + arguments.source +
                       ".");
    };
    for (const SourceArguments::ForKind &option : arguments.given) {
        if (option.kind != kind)
            return wrong(option.option, option.kind);
    }
    for (const CLI::Option *option : arguments.readOptions) {
        if (option->count() > 0 && kind != "file")
            return wrong(option->get_name(), "file");
    }
    if (!arguments.usbIds.empty() && kind != "hid")
        return wrong("--usb-id", "hid");
    return {};
}

} // namespace

void addSourceOptions(CLI::App &command, SourceArguments &arguments)
{
    command
        .add_option("--source", arguments.source,
                    "simulated[:SENSOR[:SERIAL]]; hid[:SERIAL]: a native gyro bridge; "
                    "i2c:CHIP[:SERIAL]/GYRO[@ADDRESS][+THERMOMETER]: a gyro behind an mcp2221a, cp2112 or "
                    "ft260, like i2c:mcp2221a/l3gd20h+tmp117 or i2c:cp2112/auto; file:PATH[*SPEED]: a log "
                    "played back. See driftbench-cli devices")
        ->required()
        ->type_name("SOURCE");
    command.add_option("--rate", arguments.rateHz, "Samples per second (default: the plan's, else as it is)")
        ->type_name("HZ");
    command.add_option("--range", arguments.rangeDps, "Full scale in dps (default: as it is)")
        ->type_name("DPS");
    command
        .add_option("--thermometer", arguments.thermometer,
                    "auto (default): the external one if there is one; external; die")
        ->type_name("NAME");
    command.add_flag("--compensate", arguments.compensate,
                     "Let the device take its table off the rates; native bridges only");
    command
        .add_option("--speed", arguments.speed,
                    "simulated, file: times real time (default 1); 0: as fast as it goes")
        ->type_name("N");
    addUsbIdOption(command, arguments.usbIds);
    addSimulatedOptions(command, arguments);
    addI2cOptions(command, arguments);
    command.option_defaults()->group("Source file");
    addReadOptions(command, arguments.read);
    for (const CLI::Option *option : command.get_options()) {
        if (option->get_group() == "Source file")
            arguments.readOptions.push_back(option);
    }
}

Result<SourceChoice> sourceChoiceOf(const SourceArguments &arguments, const std::optional<TestPlan> &plan)
{
    auto choice = parseSourceChoice(arguments.source);
    if (!choice)
        return choice;
    if (const Status ok = fits(*choice, arguments); !ok)
        return ok.error();
    for (const SourceArguments::ForKind &option : arguments.given)
        option.set(*choice);
    choice->rateHz = arguments.rateHz;
    choice->rangeDps = arguments.rangeDps;
    choice->compensate = arguments.compensate;
    auto *file = choice->as<FileChoice>();
    if (file)
        file->read = arguments.read;
    else if (plan && arguments.rateHz == 0.0)
        choice->rateHz = plan->sampleRateHz;
    if (auto *native = choice->as<NativeChoice>()) {
        auto ids = usbIdsOf(arguments.usbIds);
        if (!ids)
            return ids.error();
        native->ids = *std::move(ids);
    }
    if (const Status ok = takeThermometer(*choice, arguments.thermometer); !ok)
        return ok.error();
    if (arguments.speed) {
        if (const Status ok = takeSpeed(*choice, *arguments.speed); !ok)
            return ok.error();
    }
    if (const Status ok = takeChamber(*choice, arguments, plan); !ok)
        return ok.error();
    return choice;
}

} // namespace driftbench::cli
