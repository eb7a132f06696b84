#include "device/simulated_board.h"

#include "device/simulated_clock.h"
#include "device/simulated_faults.h"
#include "device/simulated_flash_file.h"
#include "device/simulated_gyro.h"

#include "device/firmware/bridge_device.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace driftbench {

namespace {

constexpr std::array kRangeFactors{1, 2, 8}; // as the gyros of the datasheets have them
constexpr double kShortestSleepS = 0.001;

Error invalid(std::string message)
{
    return {Errc::InvalidOption, std::move(message)};
}

Status check(const SimulatedBoardOptions &options)
{
    const GyroOptions &gyro = options.simulation.gyro;
    const double finestCount = gyro.sensitivityMdps * 100.0;
    if (!(finestCount >= 1.0) || finestCount * kRangeFactors.back() > 65535.0)
        return invalid("The simulated bridge needs a sensitivity of 0.01 to 81 mdps a count; " +
                       std::to_string(gyro.sensitivityMdps) + " was given.");
    if (!(options.speed >= 0.0) || !std::isfinite(options.speed))
        return invalid("The speed of the simulated bridge must be 0 or more.");
    if (!(options.lowestRateHz >= 0.001) || !(options.highestRateHz >= options.lowestRateHz) ||
        !(options.highestRateHz <= 1e6))
        return invalid("The sampling rates of the simulated bridge must lie between 0.001 and 1000000 Hz.");
    if (options.ringReports < 1 || options.bankBytes % BRIDGE_FLASH_UNIT != 0 || options.bankBytes < 1024)
        return invalid("The simulated bridge needs a ring of 1 report or more and banks of 1024 bytes or "
                       "more, a multiple of 8.");
    const SensorIdentity &sensor = options.simulation.sensor;
    if (sensor.model.size() > BRIDGE_MODEL_SIZE || sensor.serial.size() > BRIDGE_SERIAL_SIZE)
        return invalid("The simulated bridge can name a model of 12 letters and a serial number of 16; \"" +
                       sensor.text() + "\" is longer.");
    return checkOptions(options.simulation);
}

bridge_identity identityOf(const SimulatedBoardOptions &options)
{
    bridge_identity identity{};
    identity.firmware[0] = 1;
    identity.capabilities = BRIDGE_CAN_FIXED | BRIDGE_CAN_FLOAT;
    if (options.externalThermometer)
        identity.capabilities |= BRIDGE_CAN_EXTERNAL;
    const SensorIdentity &sensor = options.simulation.sensor;
    std::copy(sensor.model.begin(), sensor.model.end(), identity.model);
    std::copy(sensor.serial.begin(), sensor.serial.end(), identity.serial);
    identity.min_rate_mhz = static_cast<std::uint32_t>(std::lround(options.lowestRateHz * 1000.0));
    identity.max_rate_mhz = static_cast<std::uint32_t>(std::lround(options.highestRateHz * 1000.0));
    identity.ranges = static_cast<std::uint8_t>(kRangeFactors.size());
    const GyroOptions &gyro = options.simulation.gyro;
    for (std::size_t i = 0; i < kRangeFactors.size(); ++i) {
        identity.range[i] = {
            static_cast<std::uint16_t>(std::min(65535.0, std::round(gyro.rangeDps * kRangeFactors[i]))),
            static_cast<std::uint16_t>(std::lround(gyro.sensitivityMdps * 100.0 * kRangeFactors[i]))};
    }
    return identity;
}

Error gone()
{
    return {Errc::DeviceUnplugged, "The simulated bridge was unplugged; plug it in again."};
}

} // namespace

struct SimulatedBoard::State
{
    explicit State(SimulatedBoardOptions given);
    void powerUp();
    void unplug();
    bool streams() const { return device.config.stream == 1; }
    bool isGone(int of) const { return !plugged || of != session; }
    bool isExchangeGone(int of);
    std::uint32_t deviceClockUs(double timeS) const;
    void takeSample();
    void takeSamplesUntil(double timeS);
    std::optional<BridgeReport> nextReport();
    double waitForSampleS(double deadlineS);
    void startOrStopGyro(bool streamedBefore);
    Status afterSet(std::uint8_t command, int operationsBefore);

    std::mutex mutex;
    SimulatedBoardOptions options;
    SimulatedClock clock;
    SimulatedGyro gyro;
    SimulatedFaults faults;
    RamFlash flash;
    HidIdentity hid;
    bridge_identity identity;
    std::unique_ptr<bridge_report[]> ring;
    bridge_device device{};
    bool plugged = true;
    int session = 0;
    double powerUpS = 0.0;
};

SimulatedBoard::State::State(SimulatedBoardOptions given)
    : options(std::move(given))
    , clock(options.speed)
    , gyro(options.simulation, options.externalThermometer)
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

SimulatedBoard::SimulatedBoard(std::unique_ptr<State> state) : m_state(std::move(state)) {}

SimulatedBoard::~SimulatedBoard()
{
    // What an upload that was never finished has left behind; nobody is there to be told if that fails.
    if (!m_state->options.flashFile.empty() && m_state->flash.operations() > 0)
        static_cast<void>(saveFlash(m_state->flash, m_state->options.flashFile));
}

Result<std::shared_ptr<SimulatedBoard>> SimulatedBoard::create(SimulatedBoardOptions options)
{
    if (const Status ok = check(options); !ok)
        return ok.error();
    auto state = std::make_unique<State>(std::move(options));
    if (!state->options.flashFile.empty()) {
        if (const Status loaded = loadFlash(state->flash, state->options.flashFile); !loaded)
            return loaded.error();
    }
    state->powerUp();
    return std::shared_ptr<SimulatedBoard>(new SimulatedBoard(std::move(state)));
}

const HidIdentity &SimulatedBoard::identity() const
{
    return m_state->hid;
}

HostClock &SimulatedBoard::clock()
{
    return m_state->clock;
}

Result<int> SimulatedBoard::connect()
{
    const std::lock_guard lock(m_state->mutex);
    if (!m_state->plugged)
        return Error{Errc::DeviceNotFound, "The simulated bridge is not plugged in; plug it in."};
    return m_state->session;
}

Result<std::size_t> SimulatedBoard::read(int session, std::span<std::uint8_t> report, double timeoutS)
{
    State &state = *m_state;
    const double speed = state.clock.runsByItself() ? state.clock.speed() : 1.0;
    std::unique_lock lock(state.mutex);
    const double deadlineS = state.clock.nowS() + timeoutS * speed;
    for (;;) {
        if (state.isGone(session))
            return gone();
        state.takeSamplesUntil(state.clock.nowS());
        if (const auto next = state.nextReport()) {
            const std::size_t length = std::min(report.size(), next->size());
            std::copy_n(next->begin(), length, report.begin());
            return length;
        }
        if (state.isGone(session))
            return gone();
        if (state.clock.nowS() >= deadlineS)
            return std::size_t{0};
        if (const double sleepS = state.waitForSampleS(deadlineS); sleepS > 0.0) {
            lock.unlock();
            SteadyClock().waitS(sleepS);
            lock.lock();
        }
    }
}

Result<std::size_t> SimulatedBoard::get(int session, std::span<std::uint8_t> report)
{
    State &state = *m_state;
    const std::lock_guard lock(state.mutex);
    if (state.isExchangeGone(session))
        return gone();
    state.takeSamplesUntil(state.clock.nowS());
    BridgeReport answer;
    if (report.empty() || !bridge_device_get(&state.device, report[0], answer.data()))
        return Error{Errc::DeviceRefused, "The simulated bridge has no such report; it can't be read."};
    state.faults.pretend(answer);
    const std::size_t length = std::min(report.size(), answer.size());
    std::copy_n(answer.begin(), length, report.begin());
    return length;
}

Status SimulatedBoard::set(int session, std::span<const std::uint8_t> report)
{
    State &state = *m_state;
    const std::lock_guard lock(state.mutex);
    if (state.isExchangeGone(session))
        return gone();
    state.takeSamplesUntil(state.clock.nowS());
    if (report.empty() || state.faults.ignoresSet())
        return {};
    const int operations = state.flash.operations();
    const bool streamed = state.streams();
    if (const auto refusal = state.faults.refusal(report[0])) {
        state.device.command = report[0];
        state.device.result = *refusal;
    } else {
        bridge_device_set(&state.device, report.data(), static_cast<std::uint32_t>(report.size()));
        state.startOrStopGyro(streamed);
    }
    return state.afterSet(report[0], operations);
}

void SimulatedBoard::inject(const std::function<void(SimulatedFaults &)> &fault)
{
    const std::lock_guard lock(m_state->mutex);
    fault(m_state->faults);
}

void SimulatedBoard::cutPowerAt(int flashOperation, PowerCut how, std::uint64_t seed)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->flash.cutPowerAt(flashOperation, how, seed);
}

int SimulatedBoard::flashOperations() const
{
    const std::lock_guard lock(m_state->mutex);
    return m_state->flash.operations();
}

void SimulatedBoard::unplug()
{
    const std::lock_guard lock(m_state->mutex);
    if (m_state->plugged)
        m_state->unplug();
}

void SimulatedBoard::plugIn(double awayS)
{
    const std::lock_guard lock(m_state->mutex);
    if (m_state->plugged)
        return;
    if (!m_state->clock.runsByItself())
        m_state->clock.waitS(awayS);
    m_state->powerUp();
}

bool SimulatedBoard::pluggedIn() const
{
    const std::lock_guard lock(m_state->mutex);
    return m_state->plugged;
}

std::uint32_t SimulatedBoard::droppedInside() const
{
    const std::lock_guard lock(m_state->mutex);
    return m_state->device.stream.dropped;
}

} // namespace driftbench
