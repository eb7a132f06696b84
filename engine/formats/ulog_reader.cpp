#include "engine/formats/ulog_reader.h"

#include "engine/formats/log_instance_choice.h"
#include "engine/formats/temperature_join.h"
#include "engine/formats/ulog_survey.h"

#include <algorithm>

namespace driftbench {

namespace {

std::vector<LogInstance> listedOf(const ULogSurvey &survey)
{
    std::vector<LogInstance> instances;
    for (const ULogGyro &gyro : survey.gyros)
        instances.push_back(gyro.listed);
    return instances;
}

RecordingInfo infoOf(const ULogSurvey &survey, const ULogGyro &gyro, const std::string &file)
{
    RecordingInfo info;
    info.source = file;
    info.format = logFormatName(LogFormat::ULog);
    info.instance = gyro.listed.instance;
    info.sensor = gyro.listed.sensor;
    info.warnings = survey.warnings;
    if (gyro.rates.topic != "sensor_combined")
        return info;
    info.warnings.push_back("sensor_combined of " + file +
                            " has no temperature of its own; it was taken from " + gyro.temperature.topic +
                            ' ' + std::to_string(gyro.temperature.multiId) + '.');
    if (survey.compensatedOnBoard) {
        info.warnings.push_back("The autopilot compensated the rates in sensor_combined of " + file +
                                " by itself (TC_G_ENABLE is 1): calibrate from sensor_gyro instead.");
    }
    return info;
}

// The second pass: the messages of one gyro to a sink.
class GyroReader
{
public:
    GyroReader(const ULogGyro &gyro, BlockBuffer &buffer) : m_gyro(gyro), m_buffer(buffer), m_join(buffer) {}

    Flow take(const ULogMessage &message)
    {
        const bool isRate = m_gyro.rates.carries(message);
        const bool isTemperature = m_gyro.temperature.carries(message);
        if (!isRate && !isTemperature)
            return Flow::Continue;
        const ULogGyroFields fields(*message.subscription->format);
        if (fields.timestamp == nullptr || (isRate && !fields.hasRate()))
            return Flow::Continue;
        const std::string_view data = message.payload;
        if (isRate && isTemperature)
            return m_buffer.push(fields.timeS(data), fields.temperatureC(data), fields.rateDps(data));
        return isRate ? m_join.addRate(fields.timeS(data), fields.rateDps(data))
                      : m_join.addTemperature(fields.timeS(data), fields.temperatureC(data));
    }

    Flow finish() { return m_join.finish() == Flow::Stop ? Flow::Stop : m_buffer.flush(); }

private:
    const ULogGyro &m_gyro;
    BlockBuffer &m_buffer;
    TemperatureJoin m_join;
};

} // namespace

Result<std::vector<LogInstance>> listULog(const std::filesystem::path &path, const ProgressHook &hook)
{
    const auto survey = surveyULog(path, hook);
    if (!survey)
        return survey.error();
    return listedOf(*survey);
}

Result<RecordingInfo> readULogBlocks(const std::filesystem::path &path, std::optional<int> instance,
                                     const BlockSink &sink, const ProgressHook &hook)
{
    const auto survey = surveyULog(path, hook);
    if (!survey)
        return survey.error();
    const auto chosen = chooseInstance(listedOf(*survey), instance, survey->preferred, path.string());
    if (!chosen)
        return chosen.error();
    const auto gyro = std::find_if(survey->gyros.begin(), survey->gyros.end(), [&](const ULogGyro &one) {
        return one.listed.instance == chosen->instance;
    });
    auto parser = ULogParser::open(path);
    if (!parser)
        return parser.error();
    BlockBuffer buffer([&](const SampleBlock &block) {
        if (report(hook, "reading", parser->fractionRead()) == Flow::Stop)
            return Flow::Stop;
        return sink(block);
    });
    GyroReader reader(*gyro, buffer);
    ULogMessage message;
    Flow flow = Flow::Continue;
    while (flow == Flow::Continue && parser->next(message))
        flow = reader.take(message);
    if (!parser->status())
        return parser->status().error();
    if (flow == Flow::Stop || reader.finish() == Flow::Stop)
        return Error{Errc::Cancelled, "Reading " + path.string() + " was stopped."};
    return infoOf(*survey, *gyro, path.string());
}

} // namespace driftbench
