#include "engine/formats/csv_reader.h"

#include "engine/formats/csv_scanner.h"
#include "engine/formats/sidecar.h"
#include "engine/formats/unit_plausibility.h"

#include <iterator>

namespace driftbench {

namespace {

Error nothingRead(const std::string &file, bool damaged)
{
    if (damaged)
        return {Errc::DamagedLog,
                file + " is damaged from its first row on and holds no samples: copy it again."};
    return {Errc::TooFewSamples, file + " has a header but no samples: record it again."};
}

RecordingInfo infoOf(const CsvScanner &scanner, const std::filesystem::path &path)
{
    RecordingInfo info;
    info.source = path.string();
    info.format = "csv";
    info.sensor = scanner.sensor();
    info.simulated = scanner.simulated();
    info.warnings = scanner.warnings();
    readSidecar(path, info);
    return info;
}

} // namespace

Result<RecordingInfo> readCsvBlocks(const std::filesystem::path &path, const CsvOptions &options,
                                    const BlockSink &sink, const ProgressHook &hook)
{
    auto scanner = CsvScanner::open(path, options);
    if (!scanner)
        return scanner.error();
    UnitPlausibility plausibility;
    BlockBuffer buffer([&](const SampleBlock &block) {
        plausibility.add(block);
        if (report(hook, "reading", scanner->fractionRead()) == Flow::Stop)
            return Flow::Stop;
        return sink(block);
    });
    Flow flow = Flow::Continue;
    CsvRow row;
    while (flow == Flow::Continue && scanner->next(row)) {
        if (row.kind == CsvRowKind::Sample) {
            const auto &[timeS, temperatureC, xDps, yDps, zDps] = row.values;
            flow = buffer.push(timeS, temperatureC, {xDps, yDps, zDps});
        }
    }
    if (!scanner->status())
        return scanner->status().error();
    if (flow == Flow::Stop || buffer.flush() == Flow::Stop)
        return Error{Errc::Cancelled, "Reading " + path.string() + " was stopped."};
    RecordingInfo info = infoOf(*scanner, path);
    if (buffer.samples() == 0)
        return nothingRead(path.string(), !scanner->warnings().empty());
    std::vector<std::string> implausible =
        plausibility.warnings(path.string(), scanner->layout().rateUnitStated);
    info.warnings.insert(info.warnings.end(), std::make_move_iterator(implausible.begin()),
                         std::make_move_iterator(implausible.end()));
    return info;
}

} // namespace driftbench
