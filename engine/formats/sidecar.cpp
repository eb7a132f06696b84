#include "engine/formats/sidecar.h"

#include "engine/base/atomic_file.h"
#include "engine/formats/file_window.h"

#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

constexpr std::size_t kLargestSidecar = std::size_t{1} << 20;

std::string textAt(const nlohmann::json &object, const char *key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void take(std::string &field, std::string value)
{
    if (!value.empty())
        field = std::move(value);
}

} // namespace

std::filesystem::path sidecarPath(const std::filesystem::path &log)
{
    return log.string() + ".meta.json";
}

void readSidecar(const std::filesystem::path &log, RecordingInfo &info)
{
    const std::filesystem::path path = sidecarPath(log);
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        return;
    auto window = FileWindow::open(path);
    nlohmann::json meta;
    if (window && !window->fill(kLargestSidecar))
        meta = nlohmann::json::parse(window->bytes(), nullptr, false);
    if (!meta.is_object()) {
        info.warnings.push_back(path.string() + " is no readable JSON object and was left out.");
        return;
    }
    if (const auto sensor = meta.find("sensor"); sensor != meta.end() && sensor->is_object()) {
        take(info.sensor.model, textAt(*sensor, "model"));
        take(info.sensor.serial, textAt(*sensor, "serial"));
    }
    if (const auto simulated = meta.find("simulated"); simulated != meta.end() && simulated->is_boolean())
        info.simulated = simulated->get<bool>();
}

std::string sidecarText(const RecordingInfo &info, const std::optional<Eigen::Vector3d> &referenceRateDps)
{
    nlohmann::ordered_json meta;
    meta["sensor"]["model"] = info.sensor.model;
    meta["sensor"]["serial"] = info.sensor.serial;
    meta["simulated"] = info.simulated;
    if (referenceRateDps)
        meta["reference_rate_dps"] = {referenceRateDps->x(), referenceRateDps->y(), referenceRateDps->z()};
    // Invalid UTF-8 in a name must not throw: it is replaced.
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    return meta.dump(2, ' ', false, kReplace) + '\n';
}

Status writeSidecar(const std::filesystem::path &log, const RecordingInfo &info)
{
    return writeFileAtomically(sidecarPath(log), sidecarText(info));
}

} // namespace driftbench
