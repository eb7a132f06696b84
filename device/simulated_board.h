// A native gyro bridge with its gyro in a temperature chamber, simulated: the reference firmware
// (device/firmware) over the engine's GyroSimulator, two banks of flash, a clock of its own, and faults on
// demand. It outlives what is connected to it (SimulatedBridge): the flash keeps its tables over unplugging
// and loss of power, and, in a file, from one program run to the next.
//
// The gyro: its counts are the simulated rates over the sensitivity of the configured range (one, two and
// eight times that of the simulation, with the same multiples of its full scale), rounded and clamped to
// int16. The external thermometer is the logged temperature; the one on the die follows it behind the
// package's lag. Sample i of a run lies at i / (sampling rate) after the run's start, on the device's clock
// clockErrorPpm faster than the host's.
//
// The chamber starts its profile with the first stream; a stream that is stopped and started again is the
// next run of the campaign, one that is interrupted goes on. At the end of the profile the device stops
// streaming.
//
// Time is simulated: clock() gives it to the host side. With a speed it runs so many times as fast as the
// host's clock, without one only as fast as samples are read.
//
// Thread-safe as a whole: one thread may stream while another asks for the status or injects a fault.
#pragma once

#include "device/bridge/bridge_protocol.h"
#include "device/hid_transport.h"
#include "device/host_clock.h"
#include "device/ram_flash.h"
#include "device/simulated_faults.h"
#include "engine/physics/simulation_options.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace driftbench {

struct SimulatedBoardOptions
{
    SimulationOptions simulation; // the configuration replaces its sampling rate
    double speed = 1.0;           // times real time; 0: as fast as it is read
    double clockErrorPpm = 0.0;   // of the device's clock
    std::uint32_t powerUpClockUs = 0;
    bool externalThermometer = true;
    double lowestRateHz = 1.0;
    double highestRateHz = 10000.0;
    std::uint32_t ringReports = 64; // between the firmware and USB
    std::uint32_t bankBytes = 65536;
    std::filesystem::path flashFile{}; // empty: the tables go with the board
    int firstRun = 0;                  // of the campaign; each stream after the first is one more
};

class SimulatedBoard
{
public:
    // InvalidOption; FileUnreadable or InvalidOption for a flash file that can't be used.
    static Result<std::shared_ptr<SimulatedBoard>> create(SimulatedBoardOptions options);
    ~SimulatedBoard();
    SimulatedBoard(const SimulatedBoard &) = delete;
    SimulatedBoard &operator=(const SimulatedBoard &) = delete;

    const HidIdentity &identity() const;
    HostClock &clock(); // the host's, in simulated time

    // Faults on demand, under the board's lock: board.inject([](SimulatedFaults &f) { f.loseReports(3, 2);
    // }).
    void inject(const std::function<void(SimulatedFaults &)> &fault);
    void cutPowerAt(int flashOperation, PowerCut how, std::uint64_t seed); // as RamFlash counts them
    int flashOperations() const;                                           // so far

    void unplug();
    // Powers it up again after it has been away (in simulated time; with a speed that passes by itself).
    void plugIn(double awayS = 0.0);
    bool pluggedIn() const;

    std::uint32_t droppedInside() const; // samples since power-up, as the firmware counts them

private:
    friend class SimulatedBridge;
    struct State;

    explicit SimulatedBoard(std::unique_ptr<State> state);

    // What a connection does; session: that of connect(), over once the board was unplugged.
    Result<int> connect();
    Result<std::size_t> read(int session, std::span<std::uint8_t> report, double timeoutS);
    Result<std::size_t> get(int session, std::span<std::uint8_t> report);
    Status set(int session, std::span<const std::uint8_t> report);

    std::unique_ptr<State> m_state;
};

} // namespace driftbench
