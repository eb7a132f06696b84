#include "engine/exports/px4_export.h"

#include "engine/base/axes.h"
#include "engine/exports/cubic_refit.h"
#include "engine/exports/export_text.h"

#include <charconv>

namespace driftbench {

namespace {

constexpr int kLastGyro = 3;

std::optional<std::uint32_t> serialAsId(const std::string &serial)
{
    std::uint32_t id = 0;
    const auto [end, code] = std::from_chars(serial.data(), serial.data() + serial.size(), id);
    if (serial.empty() || code != std::errc() || end != serial.data() + serial.size())
        return std::nullopt;
    return id;
}

Result<std::uint32_t> deviceIdOf(const TrainedModel &model, const ExportOptions &options)
{
    const auto id = options.deviceId ? options.deviceId : serialAsId(model.sensor.serial);
    if (id && *id != 0)
        return *id;
    return Error{Errc::InvalidOption,
                 "PX4 finds the parameters of a gyro by its device id, which the model of " +
                     forComment(model.sensor.text()) +
                     " does not know; read it from the log (sensor_gyro, device_id) and give it with "
                     "--device-id."};
}

class ParameterLines
{
public:
    explicit ParameterLines(int gyro) : m_prefix("TC_G" + std::to_string(gyro) + "_") {}

    void integer(const std::string &name, std::int32_t value) { line(name, std::to_string(value), 6); }
    void integerOfGyro(const std::string &name, std::int32_t value) { integer(m_prefix + name, value); }
    void realOfGyro(const std::string &name, double value)
    {
        line(m_prefix + name, shortestFloat(static_cast<float>(value)), 9);
    }
    const std::string &text() const { return m_text; }

private:
    void line(const std::string &name, const std::string &value, int type)
    {
        m_text += "1\t1\t" + name + "\t" + value + "\t" + std::to_string(type) + "\n";
    }

    std::string m_prefix;
    std::string m_text;
};

std::string parameterLines(const CubicRefit &cubic, int gyro, std::uint32_t deviceId)
{
    ParameterLines lines(gyro);
    lines.integer("TC_G_ENABLE", 1);
    // PX4 keeps the 32 bits of the id in a signed parameter.
    lines.integerOfGyro("ID", static_cast<std::int32_t>(deviceId));
    lines.realOfGyro("TMIN", cubic.lowestTemperatureC);
    lines.realOfGyro("TMAX", cubic.highestTemperatureC);
    lines.realOfGyro("TREF", cubic.centreC);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        for (int power = 0; power < 4; ++power) {
            lines.realOfGyro("X" + std::to_string(power) + "_" + std::to_string(axis),
                             cubic.coefficientsDps(power, axis) / kDegreesPerRadian);
        }
    }
    return lines.text();
}

} // namespace

Result<Exported> exportForPx4(const TrainedModel &model, const ExportOptions &options,
                              const AxisSelection &selection)
{
    const int gyro = options.gyro.value_or(0);
    if (gyro < 0 || gyro > kLastGyro) {
        return Error{Errc::InvalidOption, "PX4 has temperature parameters for gyros 0 to 3, none for gyro " +
                                              std::to_string(gyro) + "; choose one of these."};
    }
    const auto deviceId = deviceIdOf(model, options);
    if (!deviceId)
        return deviceId.error();
    if (const Status status = checkTabulable(model); !status)
        return status.error();

    const double low = model.lowestTemperatureC;
    const double high = model.highestTemperatureC;
    const CubicRefit cubic = refitCubic(model, selection.compensated, 0.5 * (low + high), low, high);
    const std::string loss = lossSentence(cubic, model.name, selection.compensated);
    const std::string recalibrate =
        "Calibrate the gyro in PX4 again after loading: a CAL_GYRO offset from before is taken off as well.";

    std::vector<std::string> header{
        "Temperature compensation of one gyro for PX4 (TC_G*), in rad/s and deg C"};
    for (std::string &line : provenanceLines(provenanceOf(model), selection.compensated))
        header.push_back(std::move(line));
    header.insert(header.end(), {loss, recalibrate, "Vehicle-Id Component-Id Name Value Type"});

    Exported exported{commented(header, "# ") + parameterLines(cubic, gyro, *deviceId), selection.notes};
    exported.notes.insert(exported.notes.end(), {loss, recalibrate});
    return exported;
}

} // namespace driftbench
