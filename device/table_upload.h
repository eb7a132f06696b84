// A compensation table on its way into a native gyro bridge, and back out of it: written into the spare bank,
// read back, compared, verified by the device's own CRC, committed, activated, and then watched at work: the
// device streams samples that it compensated, which the host compares with its own compensation of the same
// raw samples (compensation_check.h).
//
// The table in use stays in use until the moment of activation; whatever is cut off before it leaves the
// device with the old one. A table whose compensation differs, or of which too little could be compared, is
// rolled back at once: the report says so. Only a link that breaks between activation and the end of the
// comparison, or of the rollback that follows a failed one, may leave such a table in use, and the error says
// which of them it was. A device that can't pair is not compared, and
// the report says that as well.
//
// Errors, beside those of the transport: WrongSensor where image and device name different sensors,
// ModelDamaged for bytes that are no image, DeviceRefused where the device can't take this kind or length,
// TableMismatch where what was read back differs, Cancelled if the hook says Stop (the old table is in use:
// a new one that was active already is rolled back).
#pragma once

#include "device/bridge/bridge_client.h"
#include "device/compensation_check.h"
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
    bool check = true;    // the compensation, once the table is active
    CompensationCheckOptions checkOptions{};
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
    bool activated = false; // and still in use
    std::optional<CompensationCheck>
        check{};             // nothing: not asked for, not activated, or the device can't pair
    bool rolledBack = false; // because the check did not pass
};

// The hook's fraction once the table is written, once it is read back as well, once the device has verified
// it and once it is committed; the rest is its way into use.
inline constexpr double kUploadWritten = 0.45;
inline constexpr double kUploadReadBack = 0.9;
inline constexpr double kUploadVerified = 0.905;
inline constexpr double kUploadCommitted = 0.91;

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
