// The firmware on its flash, and what a host sends it, for tests of single reports.
#pragma once

#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>

namespace driftbench::test {

inline constexpr std::uint32_t kBankBytes = 4096;

struct FirmwareBench
{
    RamFlash flash{kBankBytes};
    FirmwareDevice device{flash};
    Random random{20261241};
};

// The result code of a report that the host sets, if the status says the same of it.
inline int result(FirmwareDevice &device, const Report &report)
{
    const int given = device.set(report);
    const DeviceStatus status = device.status();
    return status.result == given && status.command == report[0] ? given : -1;
}

inline Report verify(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_VERIFY, transaction);
}

inline Report commit(std::uint16_t transaction)
{
    return transactionReport(BRIDGE_REPORT_COMMIT, transaction);
}

inline Report beginFor(const Bytes &image, std::uint16_t transaction)
{
    return beginReport(transaction, static_cast<std::uint32_t>(image.size()), deviceImageCrc(image));
}

inline Report activate(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ACTIVATE, generation);
}

inline Report rollback(std::uint32_t generation)
{
    return generationReport(BRIDGE_REPORT_ROLLBACK, generation);
}

} // namespace driftbench::test

#define EXPECT(report, code) QCOMPARE(result(bench.device, report), int(BRIDGE_RESULT_##code))
