#include "device/simulated_board.h"

#include "device/simulated_board_state.h"
#include "device/simulated_flash_file.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

Status check(const SimulatedBoardOptions &options)
{
    const GyroOptions &gyro = options.simulation.gyro;
    const double finestCount = gyro.sensitivityMdps * 100.0;
    if (!(finestCount >= 1.0) || finestCount * kSimulatedRangeFactors.back() > 65535.0)
        return invalidOption("The simulated bridge needs a sensitivity of 0.01 to 81 mdps a count; " +
                             std::to_string(gyro.sensitivityMdps) + " was given.");
    if (!(options.speed >= 0.0) || !std::isfinite(options.speed))
        return invalidOption("The speed of the simulated bridge must be 0 or more.");
    if (!(options.lowestRateHz >= 0.001) || !(options.highestRateHz >= options.lowestRateHz) ||
        !(options.highestRateHz <= 1e6))
        return invalidOption(
            "The sampling rates of the simulated bridge must lie between 0.001 and 1000000 Hz.");
    if (options.ringReports < 1 || options.bankBytes % BRIDGE_FLASH_UNIT != 0 || options.bankBytes < 1024)
        return invalidOption(
            "The simulated bridge needs a ring of 1 report or more and banks of 1024 bytes or "
            "more, a multiple of 8.");
    if (options.firstRun < 0)
        return invalidOption("The runs of the simulated bridge count from 0; " +
                             std::to_string(options.firstRun) + " was given.");
    const SensorIdentity &sensor = options.simulation.sensor;
    if (sensor.model.size() > BRIDGE_MODEL_SIZE || sensor.serial.size() > BRIDGE_SERIAL_SIZE)
        return invalidOption(
            "The simulated bridge can name a model of 12 letters and a serial number of 16; \"" +
            sensor.text() + "\" is longer.");
    return checkOptions(options.simulation);
}

} // namespace

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
            return State::gone();
        state.takeSamplesUntil(state.clock.nowS());
        if (const auto next = state.nextReport()) {
            const std::size_t length = std::min(report.size(), next->size());
            std::copy_n(next->begin(), length, report.begin());
            return length;
        }
        if (state.isGone(session))
            return State::gone();
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
        return State::gone();
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
        return State::gone();
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
