#include "engine/formats/ulog_survey.h"

#include "engine/base/axes.h"
#include "engine/formats/little_endian.h"
#include "engine/formats/log_instance_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace driftbench {

namespace {

constexpr double kMicrosecondsPerSecond = 1e6;
constexpr std::array<std::string_view, 4> kTopics{"sensor_gyro", "sensor_combined", "sensor_accel",
                                                  "sensor_baro"};

double numberOr(std::string_view data, const ULogField *field, std::size_t index, double otherwise)
{
    return field == nullptr ? otherwise : ulogNumber(data, *field, index).value_or(otherwise);
}

// Ids are whole numbers; what a damaged log may say instead is no id.
std::uint64_t idFrom(std::string_view data, const ULogField *field)
{
    constexpr double kLargestId = 4294967295.0;
    const double number = numberOr(data, field, 0, 0.0);
    return number >= 0.0 && number <= kLargestId ? static_cast<std::uint64_t>(number) : 0;
}

struct Stream
{
    LogInstance seen; // its temperature range is that of the topic itself
    std::uint64_t deviceId = 0;
    bool hasRate = false;
};

class Surveyor
{
public:
    void take(const ULogMessage &message)
    {
        if (message.type == 'D' && message.subscription != nullptr)
            takeData(message);
        else if (message.type == 'P')
            takeParameter(message.payload);
        else if (message.type == 'O')
            takeDropout(message.payload);
    }

    ULogSurvey survey(const std::string &file) const
    {
        ULogSurvey survey;
        survey.compensatedOnBoard = m_compensatedOnBoard;
        addGyros(survey);
        addCombined(survey);
        choosePreferred(survey);
        if (m_dropouts > 0) {
            survey.warnings.push_back("The logger of " + file +
                                      " could not keep up and left out data: " + std::to_string(m_dropouts) +
                                      " times, " + std::to_string(m_dropoutMs) + " ms in all.");
        }
        return survey;
    }

private:
    using Key = std::pair<std::string, int>;

    void takeData(const ULogMessage &message)
    {
        const ULogSubscription &subscription = *message.subscription;
        if (subscription.topic == "sensor_selection") {
            const ULogField *const id = subscription.format->find("gyro_device_id");
            m_selectedDevice = idFrom(message.payload, id);
            return;
        }
        if (std::find(kTopics.begin(), kTopics.end(), subscription.topic) == kTopics.end())
            return;
        const ULogGyroFields fields(*subscription.format);
        if (fields.timestamp == nullptr)
            return;
        Stream &stream = m_streams[{subscription.topic, subscription.multiId}];
        note(stream.seen, fields.timeS(message.payload), fields.temperatureC(message.payload));
        stream.hasRate = fields.hasRate();
        stream.deviceId = idFrom(message.payload, fields.deviceId);
    }

    // PX4's own compensation applies where TC_G_ENABLE is 1.
    void takeParameter(std::string_view payload)
    {
        constexpr std::string_view kKey = "int32_t TC_G_ENABLE";
        if (payload.substr(1).starts_with(kKey) && payload.size() == 1 + kKey.size() + 4)
            m_compensatedOnBoard = littleEndian<std::int32_t>(payload, 1 + kKey.size()) == 1;
    }

    void takeDropout(std::string_view payload)
    {
        ++m_dropouts;
        m_dropoutMs += littleEndian<std::uint16_t>(payload, 0);
    }

    static SensorIdentity identity(const Stream &stream)
    {
        SensorIdentity sensor;
        if (stream.deviceId != 0)
            sensor.serial = std::to_string(stream.deviceId);
        return sensor;
    }

    void addGyros(ULogSurvey &survey) const
    {
        for (const auto &[key, stream] : m_streams) {
            if (key.first != "sensor_gyro" || !stream.hasRate)
                continue;
            ULogGyro gyro{stream.seen, {key.first, key.second}, {key.first, key.second}};
            gyro.listed.instance = key.second;
            gyro.listed.name = key.first + ' ' + std::to_string(key.second);
            gyro.listed.sensor = identity(stream);
            survey.gyros.push_back(std::move(gyro));
        }
    }

    void addCombined(ULogSurvey &survey) const
    {
        const auto combined = m_streams.find({"sensor_combined", 0});
        if (combined == m_streams.end() || !combined->second.hasRate)
            return;
        ULogGyro gyro{combined->second.seen, {"sensor_combined", 0}, {"sensor_combined", 0}};
        gyro.listed.instance = survey.gyros.empty() ? 0 : survey.gyros.back().listed.instance + 1;
        gyro.listed.name = "sensor_combined";
        if (const auto source = temperatureSource(); source != m_streams.end()) {
            gyro.temperature = {source->first.first, source->first.second};
            gyro.listed.lowestTemperatureC = source->second.seen.lowestTemperatureC;
            gyro.listed.highestTemperatureC = source->second.seen.highestTemperatureC;
            if (source->first.first == "sensor_gyro")
                gyro.listed.sensor = identity(source->second);
        }
        survey.gyros.push_back(std::move(gyro));
    }

    std::map<Key, Stream>::const_iterator temperatureSource() const
    {
        const auto isSelected = [this](const auto &entry) {
            return entry.first.first == "sensor_gyro" && entry.second.seen.hasTemperature() &&
                   entry.second.deviceId == m_selectedDevice;
        };
        const auto selected = std::find_if(m_streams.begin(), m_streams.end(), isSelected);
        if (selected != m_streams.end() && m_selectedDevice != 0)
            return selected;
        for (const std::string_view topic :
             {"sensor_gyro", "sensor_accel", "sensor_combined", "sensor_baro"}) {
            const auto first = std::find_if(m_streams.begin(), m_streams.end(), [topic](const auto &entry) {
                return entry.first.first == topic && entry.second.seen.hasTemperature();
            });
            if (first != m_streams.end())
                return first;
        }
        return m_streams.end();
    }

    static void choosePreferred(ULogSurvey &survey)
    {
        for (const ULogGyro &gyro : survey.gyros) {
            if (gyro.rates.topic == "sensor_gyro" && gyro.listed.hasTemperature())
                survey.preferred.push_back(gyro.listed.instance);
        }
        if (survey.preferred.empty() && !survey.gyros.empty())
            survey.preferred.push_back(survey.gyros.back().listed.instance);
    }

    std::map<Key, Stream> m_streams;
    std::uint64_t m_selectedDevice = 0;
    std::uint64_t m_dropouts = 0;
    std::uint64_t m_dropoutMs = 0;
    bool m_compensatedOnBoard = false;
};

} // namespace

ULogGyroFields::ULogGyroFields(const ULogFormat &format)
    : timestamp(format.find("timestamp"))
    , rate{format.find("x"), format.find("y"), format.find("z")}
    , temperature(format.find("temperature"))
    , deviceId(format.find("device_id"))
{
    if (temperature == nullptr)
        temperature = format.find("baro_temp_celcius"); // spelled so in the logs
    if (const ULogField *const array = format.find("gyro_rad"); array != nullptr && array->count == 3) {
        std::fill(std::begin(rate), std::end(rate), array);
        rateIsArray = true;
    }
}

double ULogGyroFields::timeS(std::string_view data) const
{
    return numberOr(data, timestamp, 0, 0.0) / kMicrosecondsPerSecond;
}

double ULogGyroFields::temperatureC(std::string_view data) const
{
    return numberOr(data, temperature, 0, std::numeric_limits<double>::quiet_NaN());
}

Eigen::Vector3d ULogGyroFields::rateDps(std::string_view data) const
{
    Eigen::Vector3d rates;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double rateRadPerS =
            numberOr(data, rate[axis], rateIsArray ? axis : 0, std::numeric_limits<double>::quiet_NaN());
        rates[static_cast<Eigen::Index>(axis)] = rateRadPerS * kDegreesPerRadian;
    }
    return rates;
}

Result<ULogSurvey> surveyULog(const std::filesystem::path &path, const ProgressHook &hook)
{
    constexpr int kMessagesPerReport = 65536;
    auto parser = ULogParser::open(path);
    if (!parser)
        return parser.error();
    Surveyor surveyor;
    ULogMessage message;
    for (int count = 1; parser->next(message); ++count) {
        surveyor.take(message);
        if (count % kMessagesPerReport == 0 &&
            report(hook, "looking through", parser->fractionRead()) == Flow::Stop)
            return Error{Errc::Cancelled, "Looking through " + path.string() + " was stopped."};
    }
    if (!parser->status())
        return parser->status().error();
    const std::string file = path.string();
    ULogSurvey survey = surveyor.survey(file);
    const LogDamage &damage = parser->damage();
    if (damage.firstByte)
        survey.warnings.push_back(damage.warning(file));
    if (!survey.gyros.empty())
        return survey;
    if (damage.firstByte) {
        return Error{Errc::DamagedLog,
                     file + " is damaged at byte " + std::to_string(*damage.firstByte) +
                         " and no gyro can be read from it: copy it from the vehicle again."};
    }
    return Error{Errc::MissingColumn,
                 file + " holds no gyro (neither sensor_gyro nor sensor_combined): log one of "
                        "these topics."};
}

} // namespace driftbench
