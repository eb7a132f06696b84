#include "engine/exports/ardupilot_export.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/exports/cubic_refit.h"
#include "engine/exports/export_text.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr int kLastImu = 3;
constexpr double kReferenceC = 35.0;
constexpr double kLowestC = -70.0;
constexpr double kHighestC = 80.0;
constexpr double kSmallestSpanC = 10.0;
constexpr double kUnitsPerRadian = 1e6;
constexpr std::array<char, kAxisCount> kAxisLetters{'X', 'Y', 'Z'};

std::string line(const std::string &name, double value)
{
    return name + " " + shortestFloat(static_cast<float>(value)) + "\n";
}

std::string coefficientLines(const CubicRefit &cubic, const std::string &imu)
{
    std::string text;
    for (int power = 1; power < 4; ++power) {
        for (int axis = 0; axis < kAxisCount; ++axis) {
            text += line("INS_TCAL" + imu + "_GYR" + std::to_string(power) + "_" +
                             kAxisLetters[static_cast<std::size_t>(axis)],
                         cubic.coefficientsDps(power, axis) / kDegreesPerRadian * kUnitsPerRadian);
        }
    }
    return text;
}

std::string anchorLines(const CubicRefit &cubic, const std::string &imu, double anchorC,
                        const std::array<bool, 3> &compensated)
{
    // The first gyro's offset carries no number.
    const std::string offset = imu == "1" ? "INS_GYROFFS_" : "INS_GYR" + imu + "OFFS_";
    std::string text = line("INS_GYR" + imu + "_CALTEMP", anchorC);
    const Eigen::Vector3d tde = cubic.tdeDps(anchorC);
    for (std::size_t axis = 0; axis < kAxisLetters.size(); ++axis) {
        if (compensated[axis])
            text +=
                line(offset + kAxisLetters[axis], tde[static_cast<Eigen::Index>(axis)] / kDegreesPerRadian);
    }
    return text;
}

} // namespace

Result<Exported> exportForArduPilot(const TrainedModel &model, const ExportOptions &options,
                                    const AxisSelection &selection)
{
    const int number = options.gyro.value_or(1);
    if (number < 1 || number > kLastImu) {
        return Error{Errc::InvalidOption,
                     "ArduPilot has temperature parameters for IMUs 1 to 3 under these names, none for IMU " +
                         std::to_string(number) + "; choose one of these."};
    }
    if (const Status status = checkTabulable(model); !status)
        return status.error();
    const double low = std::max(model.lowestTemperatureC, kLowestC);
    const double high = std::min(model.highestTemperatureC, kHighestC);
    if (!(high - low >= kSmallestSpanC)) {
        return Error{Errc::ModelNotUsableHere,
                     "Model " + model.name + " was trained from " + forReading(model.lowestTemperatureC, 1) +
                         " to " + forReading(model.highestTemperatureC, 1) +
                         " \u00b0C, but ArduPilot needs at least 10 \u00b0C between \u221270 and 80 \u00b0C; "
                         "record a wider run."};
    }

    const std::string imu = std::to_string(number);
    const CubicRefit cubic = refitCubic(model, selection.compensated, kReferenceC, low, high);
    std::vector<std::string> notes{lossSentence(cubic, model.name, selection.compensated)};
    if (low > model.lowestTemperatureC || high < model.highestTemperatureC) {
        notes.push_back("ArduPilot takes temperatures from \u221270 to 80 \u00b0C only: outside " +
                        forReading(low, 1) + " to " + forReading(high, 1) +
                        " \u00b0C the edge value is held although the model was trained there.");
    }

    std::vector<std::string> header{
        "Temperature compensation of one IMU's gyro for ArduPilot (INS_TCAL), in 1e-6 rad/s and deg C"};
    for (std::string &text : provenanceLines(provenanceOf(model), selection.compensated))
        header.push_back(std::move(text));
    header.insert(header.end(), notes.begin(), notes.end());

    const double anchorC = std::clamp(model.referenceTemperatureC, low, high);
    const std::string tcal = "INS_TCAL" + imu;
    Exported exported;
    exported.text = commented(header, "# ") + tcal + "_ENABLE 1\n" + line(tcal + "_TMIN", low) +
                    line(tcal + "_TMAX", high) + coefficientLines(cubic, imu) +
                    anchorLines(cubic, imu, anchorC, selection.compensated);
    exported.notes = selection.notes;
    exported.notes.insert(exported.notes.end(), notes.begin(), notes.end());
    return exported;
}

} // namespace driftbench
