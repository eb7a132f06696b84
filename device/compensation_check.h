// Whether a native gyro bridge takes its table off as the host would: the device streams each report twice,
// as compensated and, in its twin, as measured (BRIDGE_CAN_PAIR), and the host compensates the twin by itself
// (engine/exports/device_compensation.h):
//
//   deviation = device's counts - (raw counts - table's counts at the report's temperature), clamped to int16
//
// Both compute the same integers or the same float32, so the only deviation that passes is 0, whatever the
// gyro does meanwhile; there is no noise to be averaged. What is compared is one temperature, the present
// one, in the configured range: that the whole table is on the device, its CRC and the read-back say.
//
// Reports of which the twin is lost, and what an earlier stream left behind, are not compared. The
// configuration that the device had before is set again, whatever came of it.
//
// Errors: those of the client; DeviceRefused where the device can't pair; DamagedReport where it states a
// range that it does not have; Cancelled if the hook says Stop.
#pragma once

#include "device/bridge/bridge_client.h"
#include "engine/base/progress.h"
#include "engine/exports/device_image.h"

#include <cstdint>

namespace driftbench {

struct CompensationCheckOptions
{
    int samples = 210;         // to compare
    double rateHz = 1000.0;    // or the nearest one that the device has
    double longestWaitS = 2.0; // beyond the time that the samples take
};

struct CompensationCheck
{
    int wanted = 0;
    int samples = 0;       // compared
    int rawSamples = 0;    // that came without compensation: the table's thermometer is not read
    int differing = 0;     // samples, on any axis
    int worstCounts = 0;   // largest deviation of an axis
    double worstDps = 0.0; // the same
    double lowestC = 0.0;  // temperatures of what was compared
    double highestC = 0.0;

    bool passed() const { return samples >= wanted && differing == 0; }
};

// image: of the table in use. The device must not be in the middle of an upload.
Result<CompensationCheck> checkCompensation(BridgeClient &client, const DeviceImage &image,
                                            const CompensationCheckOptions &options = {},
                                            const ProgressHook &hook = {});

} // namespace driftbench
