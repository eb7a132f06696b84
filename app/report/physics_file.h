// What physics.json of `driftbench-cli physics --out` says, as far as its figures show it. Capacitances in
// fF, lengths in um, temperatures in degrees Celsius.
//
// Errors: FileUnreadable, ModelDamaged (not JSON, a field is missing or of another kind, or
// columns differ in length).
#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace driftbench {

using Column = std::vector<double>;

struct PhysicsQuantities
{
    std::string set;
    double unexplained = 0.0;
    double rmsFf = 0.0;
    Column residualFf; // at PhysicsFile::temperatureC
};

struct PhysicsGap
{
    double temperatureC = 0.0;
    Column gapUm; // at PhysicsFile::alongUm
};

struct PhysicsFile
{
    double straightAtC = 0.0;
    double displacementUm = 0.0;
    double scaleFactorFfPerDps = 0.0;
    double contactC = 0.0; // NaN: never
    bool endsAtContact = false;
    Column temperatureC;
    double restChangeFf = 0.0;
    Column changeFf;
    Column errorFf;
    std::vector<PhysicsQuantities> quantities;
    Column alongUm;
    std::vector<PhysicsGap> gaps;
};

inline constexpr const char *kPhysicsFileName = "physics.json";

Result<PhysicsFile> readPhysicsFile(const std::filesystem::path &file);

} // namespace driftbench
