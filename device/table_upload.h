// A compensation table on its way into a native gyro bridge, and back out of it: written into the spare bank,
// verified by the device's own CRC, committed, read back, compared, activated. The table in use stays in use
// until the moment of activation; whatever is cut off before it leaves the device with the old one. The bank
// is read back once it is committed, because only then does the status tell which one it is.
//
// Errors, beside those of the transport: WrongSensor where image and device name different sensors,
// ModelDamaged for bytes that are no image, DeviceRefused where the device can't take this kind or length,
// TableMismatch where what was read back differs, Cancelled if the hook says Stop (the old table is in use).
#pragma once

#include "device/bridge/bridge_client.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace driftbench {

struct TableUploadOptions
{
    bool activate = true; // else the bank is left committed, to be activated later
};

// What was on the device before and after: the two banks and which is in use.
struct TableUploadReport
{
    BridgeStatus before;
    BridgeStatus after;
    std::uint8_t bank = 0; // that holds the new table
    std::uint32_t generation = 0;
    std::uint32_t bytes = 0;
    std::uint32_t crc = 0;
    bool activated = false;
};

Result<TableUploadReport> uploadTable(BridgeClient &client, std::span<const std::uint8_t> image,
                                      const TableUploadOptions &options = {}, const ProgressHook &hook = {});

struct TableRollbackReport
{
    BridgeStatus before;
    BridgeStatus after;
};

// Revokes the table in use; the one before it takes over if the other bank still holds it. DeviceRefused
// where no table is in use.
Result<TableRollbackReport> rollBackTable(BridgeClient &client);

// The image in use, or that of a bank. Nothing where the bank is empty or no table is in use.
Result<std::optional<std::vector<std::uint8_t>>> readTable(BridgeClient &client,
                                                           std::optional<std::uint8_t> bank = std::nullopt,
                                                           const ProgressHook &hook = {});

} // namespace driftbench
