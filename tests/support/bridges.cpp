#include "support/bridges.h"

#include "device/i2c/cp2112.h"
#include "device/i2c/ft260.h"
#include "device/i2c/mcp2221a.h"
#include "support/cp2112_model.h"
#include "support/ft260_model.h"
#include "support/mcp2221a_model.h"

namespace driftbench::test {

namespace {

template <class Driver>
Result<std::unique_ptr<I2cBus>> openAs(std::unique_ptr<HidTransport> chip, int kHz)
{
    Result<std::unique_ptr<Driver>> bus = Driver::open(std::move(chip), kHz);
    if (!bus)
        return bus.error();
    return std::unique_ptr<I2cBus>(std::move(*bus));
}

} // namespace

std::unique_ptr<HidTransport> makeChip(const std::string &name, Bridge &bridge)
{
    std::unique_ptr<HidModel> chip;
    if (name == "MCP2221A")
        chip = std::make_unique<Mcp2221aModel>(bridge.clock, bridge.wires);
    else if (name == "CP2112")
        chip = std::make_unique<Cp2112Model>(bridge.clock, bridge.wires);
    else
        chip = std::make_unique<Ft260Model>(bridge.clock, bridge.wires);
    bridge.chip = chip.get();
    return chip;
}

Result<std::unique_ptr<I2cBus>> openBus(const std::string &name, std::unique_ptr<HidTransport> chip, int kHz)
{
    if (name == "MCP2221A")
        return openAs<Mcp2221a>(std::move(chip), kHz);
    if (name == "CP2112")
        return openAs<Cp2112>(std::move(chip), kHz);
    return openAs<Ft260>(std::move(chip), kHz);
}

std::unique_ptr<Bridge> makeBridge(const std::string &name, int kHz)
{
    auto bridge = std::make_unique<Bridge>();
    Result<std::unique_ptr<I2cBus>> bus = openBus(name, makeChip(name, *bridge), kHz);
    if (!bus)
        return nullptr;
    bridge->bus = std::move(*bus);
    return bridge;
}

} // namespace driftbench::test
