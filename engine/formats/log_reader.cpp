#include "engine/formats/log_reader.h"

#include "engine/formats/csv_reader.h"
#include "engine/formats/dataflash_reader.h"
#include "engine/formats/file_window.h"
#include "engine/formats/log_instance_choice.h"
#include "engine/formats/ulog_reader.h"

#include <algorithm>

namespace driftbench {

namespace {

// How much of the file must look like text.
constexpr std::size_t kBytesLookedAt = 65536;

bool isText(std::string_view bytes)
{
    const auto isControl = [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x20 && (code < '\t' || code > '\r');
    };
    // A log that lost power may end in zero bytes: the beginning decides.
    constexpr std::size_t kBeginning = 512;
    const std::string_view beginning = bytes.substr(0, kBeginning);
    return std::none_of(beginning.begin(), beginning.end(), isControl);
}

bool isUtf16(std::string_view bytes)
{
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

Result<std::vector<LogInstance>> listCsv(const std::filesystem::path &path, const CsvOptions &options,
                                         const ProgressHook &hook)
{
    LogInstance only;
    const BlockSink sink = [&](const SampleBlock &block) {
        for (Eigen::Index i = 0; i < block.size(); ++i)
            note(only, block.timeS[i], block.temperatureC[i]);
        return Flow::Continue;
    };
    auto info = readCsvBlocks(path, options, sink, hook);
    if (!info)
        return info.error();
    only.sensor = info->sensor;
    return std::vector{only};
}

} // namespace

std::string_view logFormatName(LogFormat format)
{
    switch (format) {
    case LogFormat::Csv:
        return "csv";
    case LogFormat::ULog:
        return "ulog";
    case LogFormat::DataFlash:
        return "dataflash";
    }
    return "";
}

Result<LogFormat> detectFormat(const std::filesystem::path &path)
{
    auto window = FileWindow::open(path, kBytesLookedAt);
    if (!window)
        return window.error();
    window->fill(kBytesLookedAt);
    if (!window->status())
        return window->status().error();
    const std::string_view bytes = window->bytes();
    if (looksLikeULog(bytes))
        return LogFormat::ULog;
    if (isUtf16(bytes))
        return Error{Errc::UnknownFormat, path.string() + " is text in UTF-16: save it as UTF-8."};
    if (isText(bytes))
        return LogFormat::Csv;
    if (looksLikeDataFlash(bytes))
        return LogFormat::DataFlash;
    return Error{Errc::UnknownFormat, path.string() +
                                          " is neither a table in text (CSV, TSV) nor a PX4 ULog nor an "
                                          "ArduPilot DataFlash log: choose another file."};
}

Result<std::vector<LogInstance>> listInstances(const std::filesystem::path &path, const ReadOptions &options,
                                               const ProgressHook &hook)
{
    const auto format = detectFormat(path);
    if (!format)
        return format.error();
    switch (*format) {
    case LogFormat::Csv:
        return listCsv(path, options.csv, hook);
    case LogFormat::ULog:
        return listULog(path, hook);
    case LogFormat::DataFlash:
        break;
    }
    return listDataFlash(path, hook);
}

Result<RecordingInfo> readLogBlocks(const std::filesystem::path &path, const ReadOptions &options,
                                    const BlockSink &sink, const ProgressHook &hook)
{
    const auto format = detectFormat(path);
    if (!format)
        return format.error();
    switch (*format) {
    case LogFormat::Csv:
        if (options.instance.value_or(0) != 0) {
            return Error{Errc::NoSuchInstance, path.string() +
                                                   " is a table with one gyro, number 0: leave out "
                                                   "--instance, or name other columns."};
        }
        return readCsvBlocks(path, options.csv, sink, hook);
    case LogFormat::ULog:
        return readULogBlocks(path, options.instance, sink, hook);
    case LogFormat::DataFlash:
        break;
    }
    return readDataFlashBlocks(path, options.instance, sink, hook);
}

Result<Recording> readLog(const std::filesystem::path &path, const ReadOptions &options,
                          const ProgressHook &hook)
{
    RecordingCollector collector;
    const BlockSink sink = [&](const SampleBlock &block) {
        collector.collect(block);
        return Flow::Continue;
    };
    auto info = readLogBlocks(path, options, sink, hook);
    if (!info)
        return info.error();
    return collector.take(std::move(*info));
}

} // namespace driftbench
