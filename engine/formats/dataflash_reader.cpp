#include "engine/formats/dataflash_reader.h"

#include "engine/base/axes.h"
#include "engine/formats/dataflash_parser.h"
#include "engine/formats/log_instance_choice.h"

#include <charconv>
#include <map>

namespace driftbench {

namespace {

struct ImuSample
{
    int instance = 0;
    double timeS = 0.0;
    double temperatureC = std::numeric_limits<double>::quiet_NaN();
    Eigen::Vector3d rateDps;
};

double numberOr(const DataFlashMessage &message, const DataFlashField *field, double otherwise)
{
    return field == nullptr ? otherwise : dataFlashNumber(message.payload, *field).value_or(otherwise);
}

// The number in "IMU", "IMU2", "IMU3": 0, 1, 2; nothing if it is another message.
std::optional<int> numberInName(std::string_view name)
{
    if (!name.starts_with("IMU"))
        return std::nullopt;
    if (name.size() == 3)
        return 0;
    const char digit = name[3];
    return name.size() == 4 && digit >= '1' && digit <= '9' ? std::optional(digit - '1') : std::nullopt;
}

std::optional<ImuSample> imuSample(const DataFlashMessage &message)
{
    const DataFlashFormat &format = *message.format;
    const auto number = numberInName(format.name);
    const DataFlashField *const timeUs = format.find("TimeUS");
    const DataFlashField *const timeMs = format.find("TimeMS");
    if (!number || (timeUs == nullptr && timeMs == nullptr))
        return std::nullopt;
    ImuSample sample;
    sample.timeS =
        timeUs != nullptr ? numberOr(message, timeUs, 0.0) / 1e6 : numberOr(message, timeMs, 0.0) / 1e3;
    constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
    constexpr std::array<std::string_view, 3> kRates{"GyrX", "GyrY", "GyrZ"};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const DataFlashField *const rate = format.find(kRates[static_cast<std::size_t>(axis)]);
        if (rate == nullptr)
            return std::nullopt;
        sample.rateDps[axis] = numberOr(message, rate, kMissing) * kDegreesPerRadian;
    }
    const DataFlashField *const shortName = format.find("T");
    sample.temperatureC = numberOr(message, shortName != nullptr ? shortName : format.find("Temp"), kMissing);
    const double instance = numberOr(message, format.find("I"), *number);
    sample.instance = instance >= 0.0 && instance < 256.0 ? static_cast<int>(instance) : *number;
    return sample;
}

// The instance in "INS_GYR2_ID" or "INS4_GYR_ID" (prefix "INS", rest "GYR", end "_ID"): 1 and 3.
std::optional<int> instanceIn(std::string_view name, std::string_view word, std::string_view end)
{
    if (!name.starts_with("INS") || !name.ends_with(end))
        return std::nullopt;
    int number = 1;
    std::string_view middle = name.substr(3, name.size() - 3 - end.size());
    const auto takeNumber = [&number](std::string_view text) {
        const auto [behind, code] = std::from_chars(text.data(), text.data() + text.size(), number);
        return static_cast<std::size_t>(behind - text.data());
    };
    middle.remove_prefix(takeNumber(middle));
    if (!middle.starts_with("_") || !middle.substr(1).starts_with(word))
        return std::nullopt;
    middle.remove_prefix(1 + word.size());
    middle.remove_prefix(takeNumber(middle));
    return middle.empty() && number >= 1 ? std::optional(number - 1) : std::nullopt;
}

struct Survey
{
    std::map<int, LogInstance> imus;
    std::map<int, std::string> deviceIds;
    std::map<int, bool> compensatedOnBoard;
    LogDamage damage;

    void take(const DataFlashMessage &message)
    {
        if (message.format->name == "PARM") {
            takeParameter(message);
        } else if (const auto sample = imuSample(message)) {
            LogInstance &imu = imus[sample->instance];
            note(imu, sample->timeS, sample->temperatureC);
            imu.name = message.format->name;
        }
    }

    void takeParameter(const DataFlashMessage &message)
    {
        const DataFlashField *const nameField = message.format->find("Name");
        if (nameField == nullptr)
            return;
        const std::string name = dataFlashText(message.payload, *nameField);
        const double value = numberOr(message, message.format->find("Value"), 0.0);
        constexpr double kLargestId = 4294967295.0;
        if (const auto gyro = instanceIn(name, "GYR", "_ID"); gyro && value >= 1.0 && value <= kLargestId)
            deviceIds[*gyro] = std::to_string(static_cast<std::uint64_t>(value));
        if (const auto gyro = instanceIn(name, "TCAL", "_ENABLE"))
            compensatedOnBoard[*gyro] = value == 1.0;
    }

    std::vector<LogInstance> listed() const
    {
        std::vector<LogInstance> instances;
        for (const auto &[number, imu] : imus) {
            LogInstance &one = instances.emplace_back(imu);
            one.instance = number;
            if (const auto id = deviceIds.find(number); id != deviceIds.end())
                one.sensor.serial = id->second;
        }
        return instances;
    }
};

Result<Survey> surveyDataFlash(const std::filesystem::path &path, const ProgressHook &hook)
{
    constexpr int kMessagesPerReport = 65536;
    auto parser = DataFlashParser::open(path);
    if (!parser)
        return parser.error();
    Survey survey;
    DataFlashMessage message;
    for (int count = 1; parser->next(message); ++count) {
        survey.take(message);
        if (count % kMessagesPerReport == 0 &&
            report(hook, "looking through", parser->fractionRead()) == Flow::Stop)
            return Error{Errc::Cancelled, "Looking through " + path.string() + " was stopped."};
    }
    if (!parser->status())
        return parser->status().error();
    survey.damage = parser->damage();
    if (!survey.imus.empty())
        return survey;
    if (survey.damage.firstByte) {
        return Error{Errc::DamagedLog,
                     path.string() + " is damaged at byte " + std::to_string(*survey.damage.firstByte) +
                         " and no gyro can be read from it: copy it from the vehicle again."};
    }
    return Error{Errc::MissingColumn,
                 path.string() + " holds no gyro (no IMU message): set LOG_BITMASK to log the IMU."};
}

RecordingInfo infoOf(const Survey &survey, const LogInstance &imu, const std::string &file)
{
    RecordingInfo info;
    info.source = file;
    info.format = logFormatName(LogFormat::DataFlash);
    info.instance = imu.instance;
    info.sensor = imu.sensor;
    if (survey.damage.firstByte)
        info.warnings.push_back(survey.damage.warning(file));
    if (const auto on = survey.compensatedOnBoard.find(imu.instance);
        on != survey.compensatedOnBoard.end() && on->second) {
        info.warnings.push_back("The autopilot compensated gyro " + std::to_string(imu.instance) + " of " +
                                file + " by itself (INS_TCAL" + std::to_string(imu.instance + 1) +
                                "_ENABLE is 1): record with it switched off.");
    }
    return info;
}

std::vector<int> withTemperature(const std::vector<LogInstance> &instances)
{
    std::vector<int> numbers;
    for (const LogInstance &instance : instances) {
        if (instance.hasTemperature() || instances.size() == 1)
            numbers.push_back(instance.instance);
    }
    return numbers;
}

} // namespace

Result<std::vector<LogInstance>> listDataFlash(const std::filesystem::path &path, const ProgressHook &hook)
{
    const auto survey = surveyDataFlash(path, hook);
    if (!survey)
        return survey.error();
    return survey->listed();
}

Result<RecordingInfo> readDataFlashBlocks(const std::filesystem::path &path, std::optional<int> instance,
                                          const BlockSink &sink, const ProgressHook &hook)
{
    const auto survey = surveyDataFlash(path, hook);
    if (!survey)
        return survey.error();
    const std::vector<LogInstance> instances = survey->listed();
    const auto imu = chooseInstance(instances, instance, withTemperature(instances), path.string());
    if (!imu)
        return imu.error();
    auto parser = DataFlashParser::open(path);
    if (!parser)
        return parser.error();
    BlockBuffer buffer([&](const SampleBlock &block) {
        if (report(hook, "reading", parser->fractionRead()) == Flow::Stop)
            return Flow::Stop;
        return sink(block);
    });
    DataFlashMessage message;
    Flow flow = Flow::Continue;
    while (flow == Flow::Continue && parser->next(message)) {
        const auto sample = imuSample(message);
        if (sample && sample->instance == imu->instance)
            flow = buffer.push(sample->timeS, sample->temperatureC, sample->rateDps);
    }
    if (!parser->status())
        return parser->status().error();
    if (flow == Flow::Stop || buffer.flush() == Flow::Stop)
        return Error{Errc::Cancelled, "Reading " + path.string() + " was stopped."};
    return infoOf(*survey, *imu, path.string());
}

} // namespace driftbench
