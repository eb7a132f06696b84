#include "device/simulated_board_state.h"

#include "device/simulated_flash_file.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kShortestSleepS = 0.001;

bridge_identity identityOf(const SimulatedBoardOptions &options)
{
    bridge_identity identity{};
    identity.firmware[0] = 1;
    identity.capabilities = BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT;
    if (options.ringReports >= 2)
        identity.capabilities |= BRIDGE_CAN_PAIR;
    if (options.externalThermometer)
        identity.capabilities |= BRIDGE_CAN_EXTERNAL;
    const SensorIdentity &sensor = options.simulation.sensor;
    std::copy(sensor.model.begin(), sensor.model.end(), identity.model);
    std::copy(sensor.serial.begin(), sensor.serial.end(), identity.serial);
    identity.min_rate_mhz = static_cast<std::uint32_t>(std::lround(options.lowestRateHz * 1000.0));
    identity.max_rate_mhz = static_cast<std::uint32_t>(std::lround(options.highestRateHz * 1000.0));
    identity.ranges = static_cast<std::uint8_t>(kSimulatedRangeFactors.size());
    const GyroOptions &gyro = options.simulation.gyro;
    for (std::size_t i = 0; i < kSimulatedRangeFactors.size(); ++i) {
        identity.range[i] = {static_cast<std::uint16_t>(
                                 std::min(65535.0, std::round(gyro.rangeDps * kSimulatedRangeFactors[i]))),
                             static_cast<std::uint16_t>(
                                 std::lround(gyro.sensitivityMdps * 100.0 * kSimulatedRangeFactors[i]))};
    }
    return identity;
}

} // namespace

Error SimulatedBoard::State::gone()
{
    return {Errc::DeviceUnplugged, "The simulated bridge was unplugged; plug it in again."};
}

SimulatedBoard::State::State(SimulatedBoardOptions given)
    : options(std::move(given))
    , clock(options.speed)
    , gyro(options.simulation, options.externalThermometer, options.firstRun)
    , flash(options.bankBytes)
    , identity(identityOf(options))
    , ring(std::make_unique<bridge_report[]>(options.ringReports))
{
    const std::string &serial = options.simulation.sensor.serial;
    hid = {BRIDGE_VENDOR_ID,
           BRIDGE_PRODUCT_ID,
           "Driftbench",
           "Simulated gyro bridge",
           serial,
           "simulated:" + serial,
           0};
}

void SimulatedBoard::State::powerUp()
{
    flash.powerUp();
    powerUpS = clock.nowS();
    bridge_device_start(&device, &identity, flash.flash(), ring.get(), options.ringReports);
    plugged = true;
}

void SimulatedBoard::State::unplug()
{
    plugged = false;
    ++session;
    gyro.interrupt();
    faults.endStall();
}

bool SimulatedBoard::State::isExchangeGone(int of)
{
    if (!isGone(of) && faults.nextExchangeUnplugs())
        unplug();
    return isGone(of);
}

std::uint32_t SimulatedBoard::State::deviceClockUs(double timeS) const
{
    const double elapsedUs = (timeS - powerUpS) * (1e6 + options.clockErrorPpm);
    return options.powerUpClockUs + static_cast<std::uint32_t>(std::llround(elapsedUs));
}

// Into the firmware; after the last one of the run the device stops by itself.
void SimulatedBoard::State::takeSample()
{
    SimulatedGyro::Sample next = gyro.take();
    next.sample.time_us = deviceClockUs(next.dueS);
    bridge_device_lost(&device, next.lostBefore);
    bridge_device_sample(&device, &next.sample);
    if (!gyro.dueS()) {
        bridge_stream_flush(&device.stream);
        device.config.stream = 0;
        gyro.stop();
    }
}

void SimulatedBoard::State::takeSamplesUntil(double timeS)
{
    for (auto dueS = gyro.dueS(); streams() && dueS && *dueS <= timeS; dueS = gyro.dueS())
        takeSample();
}

// What reaches the host of what waits in the firmware's ring.
std::optional<BridgeReport> SimulatedBoard::State::nextReport()
{
    while (device.stream.waiting > 0) {
        if (faults.nextReportUnplugs())
            unplug();
        if (!plugged || faults.isStalled(clock.nowS()))
            return std::nullopt;
        BridgeReport report;
        bridge_device_take(&device, report.data());
        if (faults.passes(report))
            return report;
    }
    return std::nullopt;
}

// Lets time pass until the next sample or the deadline; gives how long to sleep for that, 0 if it has passed.
double SimulatedBoard::State::waitForSampleS(double deadlineS)
{
    const auto dueS = gyro.dueS();
    const bool comes = dueS && *dueS <= deadlineS && !faults.isStalled(clock.nowS());
    if (!clock.runsByItself()) {
        clock.advanceTo(comes ? *dueS : deadlineS);
        return 0.0;
    }
    const double leftS = (deadlineS - clock.nowS()) / clock.speed();
    const double untilDueS = comes ? (*dueS - clock.nowS()) / clock.speed() : kShortestSleepS;
    return std::max(0.0, std::min(leftS, std::max(untilDueS, kShortestSleepS)));
}

void SimulatedBoard::State::startOrStopGyro(bool streamedBefore)
{
    if (streams() == streamedBefore)
        return;
    if (!streams()) {
        gyro.stop();
        return;
    }
    const bridge_range &range = identity.range[device.config.range];
    if (!gyro.start(device.config.rate_mhz, {range.full_scale_dps, range.sensitivity}, clock.nowS())) {
        device.config.stream = 0;
        device.result = BRIDGE_RESULT_BAD_VALUE;
    }
}

Status SimulatedBoard::State::afterSet(std::uint8_t command, int operationsBefore)
{
    if (!flash.hasPower())
        unplug();
    // Chunks are many; what they wrote is saved with the next command, or when the board goes.
    const bool wrote = flash.operations() != operationsBefore;
    if (wrote && command != BRIDGE_REPORT_CHUNK && !options.flashFile.empty()) {
        if (Status saved = saveFlash(flash, options.flashFile); !saved)
            return saved;
    }
    if (!plugged)
        return gone();
    if (device.result != BRIDGE_RESULT_OK && faults.stallsRefusedSets())
        return Error{Errc::DeviceRefused,
                     "The simulated bridge stalled report " + std::to_string(command) + "; read its status."};
    return {};
}

} // namespace driftbench
