// The one way from a choice (source_choice.h) to the source itself, for every program.
//
//   const auto choice = parseSourceChoice("i2c:mcp2221a/l3gd20h+tmp117");
//   auto opened = openSource(*choice);
//   opened->source->run(sink, stop);
//
// What the source needs (board, clock) lives in what is returned. A native bridge that is unplugged while it
// streams is waited for, by its serial number, and the run goes on behind a gap (bridge_source.h); all others
// end with DeviceUnplugged.
//
// Errors: those of the drivers; DeviceNotFound, DeviceHeldByKernel and InvalidOption as device_match.h says;
// InvalidOption for an option that the source does not have.
#pragma once

#include "device/bridge/bridge_client.h"
#include "device/hid_access.h"
#include "device/sample_source.h"
#include "device/simulated_board.h"
#include "device/source_choice.h"

#include <memory>

namespace driftbench {

struct OpenedSource
{
    std::shared_ptr<SimulatedBoard> board; // of the simulated bridge
    std::unique_ptr<HostClock> ownClock{}; // unless the board or a test has it
    HidIdentity identity{};                // of the device that is in use; empty: a file
    std::unique_ptr<SampleSource> source{};
    BridgeClient *bridge = nullptr; // of native bridges, inside the source; not while it runs
    bool isRealTime = false;        // its time passes by itself, whether samples come or not
};

Result<OpenedSource> openSource(const SourceChoice &choice,
                                const HidAccess &access = hidDevicesOfThisComputer());

// The native bridge alone, real or simulated, for its settings and tables.
struct OpenedBridge
{
    std::shared_ptr<SimulatedBoard> board;
    std::unique_ptr<HostClock> ownClock;
    std::unique_ptr<BridgeClient> client;
};

// Also InvalidOption for a choice that is no native bridge.
Result<OpenedBridge> openBridge(const SourceChoice &choice,
                                const HidAccess &access = hidDevicesOfThisComputer());

} // namespace driftbench
