// A simulated board and the source that reads it.
#pragma once

#include "device/bridge/bridge_source.h"
#include "support/simulated_device.h"

#include <memory>

namespace driftbench::test {

struct BridgeLink
{
    std::shared_ptr<SimulatedBoard> board;
    std::unique_ptr<BridgeSource> source;
};

inline BridgeLink linkTo(const SimulatedBoardOptions &options, const BridgeSourceOptions &sourceOptions)
{
    BridgeLink made{*SimulatedBoard::create(options), nullptr};
    made.source = *BridgeSource::open(*SimulatedBridge::open(made.board), made.board->clock(), sourceOptions);
    return made;
}

inline BridgeSourceOptions atRate(double rateHz)
{
    BridgeSourceOptions options;
    options.rateHz = rateHz;
    return options;
}

} // namespace driftbench::test
