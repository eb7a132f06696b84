// A compensation table into a native gyro bridge, or out of use again, off the thread that owns it. A cancel
// leaves the device with the table that it had.
#pragma once

#include "app/session/job.h"
#include "app/session/session_records.h"
#include "device/bridge/bridge_client.h"
#include "device/table_upload.h"
#include "engine/exports/device_image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace driftbench {

// A client with all that it needs to live.
using OpenClient = std::function<Result<std::shared_ptr<BridgeClient>>()>;

struct UploadOutcome
{
    TableUploadReport report;
    BridgeInfo device;
};

// What a session keeps of an upload that uploadTable did not refuse; the model and how the device is called
// here are the caller's to add.
UploadRecord uploadRecord(const UploadOutcome &outcome, DeviceTableKind kind, std::string sentence);

// What a device says of its tables.
struct DeviceTables
{
    BridgeInfo device;
    BridgeStatus status;
    std::optional<std::vector<std::uint8_t>> image; // the table in use; nothing: none is
};

class UploadJob final : public Job
{
    Q_OBJECT

public:
    explicit UploadJob(QObject *parent = nullptr) : Job(parent) {}
    ~UploadJob() override { cancelAndWait(); }

    // open is called on the thread of the job.
    bool upload(OpenClient open, std::vector<std::uint8_t> image, const TableUploadOptions &options = {});
    bool rollBack(OpenClient open);
    bool readBack(OpenClient open); // the table in use
    bool look(OpenClient open);     // info, banks, and the table in use

signals:
    void uploaded(const driftbench::Result<driftbench::UploadOutcome> &outcome);
    void rolledBack(const driftbench::Result<driftbench::TableRollbackReport> &outcome);
    void readFinished(const driftbench::Result<std::optional<std::vector<std::uint8_t>>> &image);
    void looked(const driftbench::Result<driftbench::DeviceTables> &tables);
};

} // namespace driftbench
