#include "app/report/physics_file.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <limits>

namespace driftbench {

using nlohmann::json;

static double numberOrNan(const json &value)
{
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

static PhysicsFile physicsOf(const json &object)
{
    PhysicsFile physics;
    physics.straightAtC = object.at("combs").at("straight_at_C").get<double>();
    physics.displacementUm = object.at("displacement_um").get<double>();
    physics.scaleFactorFfPerDps = object.at("scale_factor_fF_per_dps").get<double>();
    physics.contactC = numberOrNan(object.at("contact_C"));
    physics.endsAtContact = object.at("ends_at_contact").get<bool>();
    const json &curve = object.at("curve");
    physics.temperatureC = curve.at("temperature_C").get<Column>();
    physics.restChangeFf = curve.at("rest_change_fF").get<double>();
    physics.changeFf = curve.at("change_fF").get<Column>();
    physics.errorFf = curve.at("error_fF").get<Column>();
    for (const json &each : object.at("quantities"))
        physics.quantities.push_back({each.at("set").get<std::string>(), each.at("unexplained").get<double>(),
                                      each.at("rms_fF").get<double>(), each.at("residual_fF").get<Column>()});
    physics.alongUm = object.at("gap").at("x_um").get<Column>();
    for (const json &each : object.at("gap").at("profiles"))
        physics.gaps.push_back({each.at("temperature_C").get<double>(), each.at("gap_um").get<Column>()});
    return physics;
}

static bool columnsFit(const PhysicsFile &physics)
{
    const std::size_t rows = physics.temperatureC.size();
    bool fit = rows > 0 && physics.changeFf.size() == rows && physics.errorFf.size() == rows;
    for (const PhysicsQuantities &each : physics.quantities)
        fit = fit && each.residualFf.size() == rows;
    for (const PhysicsGap &each : physics.gaps)
        fit = fit && each.gapUm.size() == physics.alongUm.size();
    return fit;
}

Result<PhysicsFile> readPhysicsFile(const std::filesystem::path &file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return Error{Errc::FileUnreadable,
                     file.string() + " can't be opened; run `driftbench-cli physics --out` again."};
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    try {
        PhysicsFile physics = physicsOf(json::parse(text));
        if (columnsFit(physics))
            return physics;
        return Error{Errc::ModelDamaged, file.string() + " has columns of different lengths; run "
                                                         "`driftbench-cli physics --out` again."};
    } catch (const json::exception &problem) {
        return Error{Errc::ModelDamaged, file.string() + " is damaged (" + problem.what() +
                                             "); run `driftbench-cli physics --out` again."};
    }
}

} // namespace driftbench
