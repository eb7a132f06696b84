#include "app/session/upload_job.h"

namespace driftbench {

UploadRecord uploadRecord(const UploadOutcome &outcome, DeviceTableKind kind, std::string sentence)
{
    const TableUploadReport &report = outcome.report;
    UploadRecord made;
    made.sensor = outcome.device.sensor;
    made.kind = kind == DeviceTableKind::FixedPoint ? "fixed" : "float";
    made.bank = report.bank;
    made.generation = report.generation;
    made.bytes = report.bytes;
    made.crc32 = report.crc;
    made.verified = true; // else there were no report
    made.activated = report.activated;
    made.outcome = std::move(sentence);
    return made;
}

bool UploadJob::upload(OpenClient open, std::vector<std::uint8_t> image, const TableUploadOptions &options)
{
    const auto task = [open = std::move(open), image = std::move(image),
                       options](const ProgressHook &hook) -> Result<UploadOutcome> {
        const auto client = open();
        if (!client)
            return client.error();
        auto report = uploadTable(**client, image, options, hook);
        if (!report)
            return report.error();
        return UploadOutcome{*std::move(report), (*client)->info()};
    };
    return run([this, task](const ProgressHook &hook) -> Deliver {
        return [this, outcome = task(hook)] { emit uploaded(outcome); };
    });
}

bool UploadJob::rollBack(OpenClient open)
{
    return run([this, open = std::move(open)](const ProgressHook & /*hook*/) -> Deliver {
        const auto client = open();
        if (!client)
            return [this, error = client.error()] { emit rolledBack(Result<TableRollbackReport>(error)); };
        return [this, outcome = rollBackTable(**client)] { emit rolledBack(outcome); };
    });
}

bool UploadJob::readBack(OpenClient open)
{
    using Image = std::optional<std::vector<std::uint8_t>>;
    return run([this, open = std::move(open)](const ProgressHook &hook) -> Deliver {
        const auto client = open();
        if (!client)
            return [this, error = client.error()] { emit readFinished(Result<Image>(error)); };
        return [this, image = readTable(**client, std::nullopt, hook)] { emit readFinished(image); };
    });
}

static Result<DeviceTables> tablesOf(BridgeClient &client, const ProgressHook &hook)
{
    const auto status = client.status();
    if (!status)
        return status.error();
    auto image = readTable(client, std::nullopt, hook);
    if (!image)
        return image.error();
    return DeviceTables{client.info(), *status, *std::move(image)};
}

bool UploadJob::look(OpenClient open)
{
    return run([this, open = std::move(open)](const ProgressHook &hook) -> Deliver {
        const auto client = open();
        if (!client)
            return [this, error = client.error()] { emit looked(Result<DeviceTables>(error)); };
        return [this, tables = tablesOf(**client, hook)] { emit looked(tables); };
    });
}

} // namespace driftbench
