// Datasheet figures of gyros and chambers, as far as the test plan and the simulator need them.
//
// Sources: L3GD20H and I3G4250D, STMicroelectronics' datasheets ("mechanical characteristics"); chamber
// SET-Z-021, section 2.2.1 of the paper (air at 0 C in a cube of 0.6 m).
#pragma once

#include "engine/base/result.h"

#include <array>
#include <string>
#include <string_view>

namespace driftbench {

struct SensorDatasheet
{
    std::string model;
    double sensitivityMdps = 0.0;          // of one count at rangeDps
    double rangeDps = 0.0;                 // the full scale that is used
    double zeroRateChangeMdpsPerC = 0.0;   // "zero-rate level change vs. temperature", at the range below
    double zeroRateChangeRangeDps = 0.0;   // full scale at which the datasheet states it
    double sensitivityChangePercent = 0.0; // "sensitivity change vs. temperature"
    double noiseDensityDpsPerRootHz = 0.0; // "rate noise density"
    double lowestC = 0.0;                  // operating temperature range
    double highestC = 0.0;
};

struct ChamberDatasheet
{
    std::string model;
    double edgeM = 0.0;                // inner edge of the cube
    double specificHeatJPerKgK = 0.0;  // of the air
    double densityKgPerM3 = 0.0;       // of the air
    double conductivityWPerMK = 0.0;   // of the air
    double thermometerAccuracyC = 0.0; // +-, of the thermometer beside the gyro
};

inline constexpr std::array<std::string_view, 2> kSensorNames{"I3G4250D", "L3GD20H"};
inline constexpr std::array<std::string_view, 1> kChamberNames{"SET-Z-021"};

// By name, upper or lower case. Errc::InvalidOption with the names that there are.
Result<SensorDatasheet> namedSensor(std::string_view model);
Result<ChamberDatasheet> namedChamber(std::string_view model);

// Errc::InvalidOption with the first figure that can't be: what it is and what it must be.
Status checkDatasheet(const SensorDatasheet &sensor);
Status checkDatasheet(const ChamberDatasheet &chamber);

} // namespace driftbench
