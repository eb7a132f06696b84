#include "app/session/session_source.h"

#include "app/campaign/json_optional.h"
#include "app/campaign/read_options_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

// A profile of the house by its name, any other by its steps.
Json profileToJson(const std::optional<TemperatureProfile> &profile)
{
    if (!profile)
        return nullptr;
    const std::string &name = profile->name();
    if (std::find(kProfileNames.begin(), kProfileNames.end(), name) != kProfileNames.end())
        return name;
    Json steps = Json::array();
    for (const ProfileStep &step : profile->steps())
        steps.push_back({step.startS, step.setpointC});
    return {{"name", name}, {"duration_s", profile->durationS()}, {"steps", steps}};
}

std::optional<TemperatureProfile> profileFrom(const Json &json)
{
    if (json.is_null())
        return std::nullopt;
    if (json.is_string()) {
        auto named = TemperatureProfile::named(json.get<std::string>());
        return named ? std::optional(*named) : std::nullopt;
    }
    const auto steps = json.at("steps").get<std::vector<std::array<double, 2>>>();
    const double endS = json.at("duration_s").get<double>();
    std::vector<ProfileSegment> segments;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double lastsS = (i + 1 < steps.size() ? steps[i + 1][0] : endS) - steps[i][0];
        const double byC = i > 0 ? std::abs(steps[i][1] - steps[i - 1][1]) : 0.0;
        if (byC > 0.0)
            segments.emplace_back(RampSegment{steps[i][1], byC, lastsS});
        else
            segments.emplace_back(HoldSegment{lastsS});
    }
    auto built = TemperatureProfile::build(json.at("name").get<std::string>(), steps.at(0)[1], segments);
    return built ? std::optional(*built) : std::nullopt;
}

Json besideText(const SimulatedChoice &choice)
{
    const Eigen::Vector3d &rate = choice.referenceRateDps;
    return {{"profile", profileToJson(choice.profile)},
            {"reference_rate_dps", {rate[0], rate[1], rate[2]}},
            {"seed", choice.seed},
            {"run", choice.run},
            {"speed", choice.speed},
            {"noise_dps", orNull(choice.noiseDps)},
            {"spread", orNull(choice.spread)},
            {"clock_error_ppm", choice.clockErrorPpm},
            {"external_thermometer", choice.externalThermometer},
            {"flash_file", choice.flashFile.string()},
            {"drift", choice.drift}};
}

Json besideText(const NativeChoice &choice)
{
    Json ids = Json::array();
    for (const UsbId id : choice.ids)
        ids.push_back(usbIdText(id));
    return {{"ids", ids}};
}

Json besideText(const I2cChoice &choice)
{
    return {{"gyro_serial", choice.gyroSerial},
            {"bus_khz", choice.busKHz},
            {"die_offset_C", choice.dieOffsetC},
            {"die_C_per_count", choice.dieCPerCount}};
}

Json besideText(const FileChoice &choice)
{
    return {{"read", readOptionsToJson(choice.read)}};
}

void readBeside(const Json &json, SimulatedChoice &choice)
{
    choice.profile = profileFrom(json.at("profile"));
    const auto rate = json.at("reference_rate_dps").get<std::array<double, 3>>();
    choice.referenceRateDps = {rate[0], rate[1], rate[2]};
    choice.seed = json.at("seed").get<std::uint64_t>();
    choice.run = json.at("run").get<int>();
    choice.speed = json.at("speed").get<double>();
    choice.noiseDps = optionalAt<double>(json, "noise_dps");
    choice.spread = optionalAt<double>(json, "spread");
    choice.clockErrorPpm = json.at("clock_error_ppm").get<double>();
    choice.externalThermometer = json.at("external_thermometer").get<bool>();
    choice.flashFile = json.at("flash_file").get<std::string>();
    choice.drift = json.value("drift", std::string());
}

void readBeside(const Json &json, NativeChoice &choice)
{
    for (const Json &text : json.at("ids")) {
        if (const auto id = parseUsbId(text.get<std::string>()))
            choice.ids.push_back(*id);
    }
}

void readBeside(const Json &json, I2cChoice &choice)
{
    choice.gyroSerial = json.at("gyro_serial").get<std::string>();
    choice.busKHz = json.at("bus_khz").get<int>();
    choice.dieOffsetC = json.at("die_offset_C").get<double>();
    choice.dieCPerCount = json.at("die_C_per_count").get<double>();
}

void readBeside(const Json &json, FileChoice &choice)
{
    if (const auto read = readOptionsFromJson(json.at("read")))
        choice.read = *read;
}

// Throws Json::exception where the document is of another shape.
Result<SourceChoice> choiceFrom(const Json &json)
{
    auto choice = parseSourceChoice(json.at("source").get<std::string>());
    if (!choice)
        return choice;
    choice->rateHz = json.at("rate_hz").get<double>();
    choice->rangeDps = json.at("range_dps").get<double>();
    choice->thermometer = static_cast<ThermometerChoice>(std::clamp(json.at("thermometer").get<int>(), 0, 2));
    choice->compensate = json.at("compensate").get<bool>();
    std::visit([&json](auto &kind) { readBeside(json.at("beside"), kind); }, choice->from);
    return choice;
}

// The source with the board and the clock that it needs.
class OwnedSource final : public SampleSource
{
public:
    explicit OwnedSource(OpenedSource opened) : m_opened(std::move(opened)) {}

    const SourceInfo &info() const override { return m_opened.source->info(); }
    Result<SourceStats> run(SampleSink &sink, std::stop_token stop) override
    {
        return m_opened.source->run(sink, std::move(stop));
    }

private:
    OpenedSource m_opened;
};

} // namespace

std::string sourceChoiceToJson(const SourceChoice &choice)
{
    const Json json{{"source", sourceChoiceText(choice)},
                    {"rate_hz", choice.rateHz},
                    {"range_dps", choice.rangeDps},
                    {"thermometer", static_cast<int>(choice.thermometer)},
                    {"compensate", choice.compensate},
                    {"beside", std::visit([](const auto &kind) { return besideText(kind); }, choice.from)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

Result<SourceChoice> sourceChoiceFromJson(const std::string &json)
{
    try {
        return choiceFrom(Json::parse(json));
    } catch (const Json::exception &problem) {
        return Error{Errc::SessionDamaged, std::string("The source in the session is damaged (") +
                                               problem.what() + "); choose it anew."};
    }
}

Acquisition::OpenSource sourceOpener(SourceChoice choice, HidAccess access,
                                     std::function<void(const OpenedSource &)> opened)
{
    return [choice = std::move(choice), access = std::move(access),
            tell = std::move(opened)]() -> Result<std::unique_ptr<SampleSource>> {
        auto source = openSource(choice, access);
        if (!source)
            return source.error();
        if (tell)
            tell(*source);
        return std::unique_ptr<SampleSource>(std::make_unique<OwnedSource>(*std::move(source)));
    };
}

OpenClient clientOpener(SourceChoice choice, HidAccess access)
{
    return
        [choice = std::move(choice), access = std::move(access)]() -> Result<std::shared_ptr<BridgeClient>> {
            auto opened = openBridge(choice, access);
            if (!opened)
                return opened.error();
            // The client lives in what it needs.
            const auto kept = std::make_shared<OpenedBridge>(*std::move(opened));
            return std::shared_ptr<BridgeClient>(kept, kept->client.get());
        };
}

} // namespace driftbench
