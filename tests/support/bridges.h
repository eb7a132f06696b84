// The three USB bridges by name, each as its driver on its model, on a bus with simulated time.
#pragma once

#include "device/i2c/i2c_bus.h"
#include "support/hid_model.h"
#include "support/i2c_bus_model.h"

#include <array>
#include <memory>
#include <string>

namespace driftbench::test {

inline constexpr std::array kBridgeNames{"MCP2221A", "CP2112", "FT260"};

struct Bridge
{
    SimulatedClock clock{0.0, 1000.0}; // from somewhere: nobody may take the zero for granted
    I2cBusModel wires;
    HidModel *chip = nullptr; // owned by the driver
    std::unique_ptr<I2cBus> bus;
};

// The model is chosen by name; its driver is not opened yet.
std::unique_ptr<HidTransport> makeChip(const std::string &name, Bridge &bridge);
Result<std::unique_ptr<I2cBus>> openBus(const std::string &name, std::unique_ptr<HidTransport> chip, int kHz);

// Opened; nothing if opening failed.
std::unique_ptr<Bridge> makeBridge(const std::string &name, int kHz = 400);

} // namespace driftbench::test
