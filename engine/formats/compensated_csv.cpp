#include "engine/formats/compensated_csv.h"

#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "engine/formats/csv_scanner.h"
#include "engine/formats/csv_writer.h"
#include "engine/formats/log_reader.h"
#include "engine/formats/sidecar.h"

#include <array>
#include <cassert>

namespace driftbench {

namespace {

constexpr std::array<std::string_view, 3> kNewColumns{"comp_x_dps", "comp_y_dps", "comp_z_dps"};

Error stopped(const std::filesystem::path &out)
{
    return {Errc::Cancelled, out.string() + " was not written: the work was stopped."};
}

void appendNewColumns(std::string &header, char separator)
{
    for (const std::string_view name : kNewColumns) {
        header += separator;
        header += name;
    }
}

std::string_view lineEndOf(std::string_view line)
{
    if (line.ends_with("\r\n"))
        return "\r\n";
    return line.ends_with('\n') ? "\n" : "";
}

// Rows of a CSV, gathered until there are enough of them to ask for their TDE at once.
class RowBatch
{
public:
    explicit RowBatch(char separator) : m_separator(separator) {}

    bool full() const { return m_samples.size() >= kSamples || m_text.size() >= kTextBytes; }

    void add(const CsvRow &row)
    {
        m_text += row.text;
        m_rows.push_back({row.text.size(), row.kind == CsvRowKind::Sample});
        if (row.kind == CsvRowKind::Sample)
            m_samples.push_back(row.values);
    }

    std::int64_t samples() const { return static_cast<std::int64_t>(m_samples.size()); }

    // Writes the rows with their new columns and forgets them.
    Status write(AtomicFile &file, const TdeOfTemperature &tde)
    {
        Eigen::VectorXd temperatureC(samples());
        for (std::size_t i = 0; i < m_samples.size(); ++i)
            temperatureC[static_cast<Eigen::Index>(i)] = m_samples[i][1];
        const Eigen::MatrixX3d tdeDps = tde(temperatureC);
        assert(tdeDps.rows() == temperatureC.size());
        Eigen::Index sample = 0;
        std::string_view rest = m_text;
        std::string line;
        for (const Row &row : m_rows) {
            const std::string_view text = rest.substr(0, row.bytes);
            rest.remove_prefix(row.bytes);
            line = text;
            if (row.isSample)
                appendRates(line, lineEndOf(text), sample++, tdeDps);
            if (Status written = file.write(line); !written)
                return written;
        }
        m_text.clear();
        m_rows.clear();
        m_samples.clear();
        return {};
    }

private:
    struct Row
    {
        std::size_t bytes;
        bool isSample;
    };

    static constexpr std::size_t kSamples = 8192;
    static constexpr std::size_t kTextBytes = std::size_t{1} << 22;

    void appendRates(std::string &line, std::string_view lineEnd, Eigen::Index sample,
                     const Eigen::MatrixX3d &tdeDps) const
    {
        line.resize(line.size() - lineEnd.size());
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const double measuredDps =
                m_samples[static_cast<std::size_t>(sample)][static_cast<std::size_t>(axis) + 2];
            line += m_separator;
            appendNumber(line, measuredDps - tdeDps(sample, axis));
        }
        line += lineEnd;
    }

    char m_separator;
    std::string m_text;
    std::vector<Row> m_rows;
    std::vector<std::array<double, kCsvQuantityCount>> m_samples;
};

Result<std::string> newPreamble(const CsvScanner &scanner, const std::filesystem::path &in)
{
    const CsvLayout &layout = scanner.layout();
    std::string preamble = scanner.preamble();
    if (layout.headerLine.empty() || isNumeric(layout.headerLine, layout.separator))
        return preamble;
    for (const std::string_view name : splitFields(layout.headerLine, layout.separator)) {
        if (lowered(unquoted(name)) == kNewColumns[0])
            return Error{Errc::InvalidOption, in.string() +
                                                  " has a column comp_x_dps already: apply the model to "
                                                  "the log as it was recorded."};
    }
    const auto header = preamble.rfind(layout.headerLine);
    std::string names;
    appendNewColumns(names, layout.separator);
    preamble.insert(header + layout.headerLine.size(), names);
    return preamble;
}

Result<CompensatedCsv> fromCsv(const std::filesystem::path &in, const std::filesystem::path &out,
                               const ReadOptions &options, const TdeOfTemperature &tde,
                               const ProgressHook &hook)
{
    auto scanner = CsvScanner::open(in, options.csv);
    if (!scanner)
        return scanner.error();
    auto preamble = newPreamble(*scanner, in);
    if (!preamble)
        return preamble.error();
    auto file = AtomicFile::create(out);
    if (!file)
        return file.error();
    CompensatedCsv result;
    RowBatch batch(scanner->layout().separator);
    Status written = file->write(*preamble);
    CsvRow row;
    while (written && scanner->next(row)) {
        batch.add(row);
        result.samples += row.kind == CsvRowKind::Sample ? 1 : 0;
        if (!batch.full())
            continue;
        written = batch.write(*file, tde);
        if (report(hook, "compensating", scanner->fractionRead()) == Flow::Stop)
            return stopped(out);
    }
    if (!scanner->status())
        return scanner->status().error();
    if (written)
        written = batch.write(*file, tde);
    if (written)
        written = file->commit();
    if (!written)
        return written.error();
    result.info.source = in.string();
    result.info.format = "csv";
    result.info.sensor = scanner->sensor();
    result.info.simulated = scanner->simulated();
    result.info.warnings = scanner->warnings();
    readSidecar(in, result.info);
    return result;
}

std::string defaultRows(const SampleBlock &block, const Eigen::MatrixX3d &tdeDps)
{
    std::string rows;
    for (Eigen::Index i = 0; i < block.size(); ++i) {
        appendNumber(rows, block.timeS[i]);
        rows += ',';
        appendNumber(rows, block.temperatureC[i]);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            rows += ',';
            appendNumber(rows, block.rateDps(i, axis));
        }
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            rows += ',';
            appendNumber(rows, block.rateDps(i, axis) - tdeDps(i, axis));
        }
        rows += '\n';
    }
    return rows;
}

Result<CompensatedCsv> fromOther(const std::filesystem::path &in, const std::filesystem::path &out,
                                 const ReadOptions &options, const TdeOfTemperature &tde,
                                 const ProgressHook &hook)
{
    auto file = AtomicFile::create(out);
    if (!file)
        return file.error();
    std::string header(kCsvHeader);
    appendNewColumns(header, ',');
    Status written = file->write(header + '\n');
    CompensatedCsv result;
    const BlockSink sink = [&](const SampleBlock &block) {
        if (written)
            written = file->write(defaultRows(block, tde(block.temperatureC)));
        result.samples += block.size();
        return written ? Flow::Continue : Flow::Stop;
    };
    auto info = readLogBlocks(in, options, sink, hook);
    if (!written)
        return written.error();
    if (!info)
        return info.error();
    if (Status committed = file->commit(); !committed)
        return committed.error();
    result.info = std::move(*info);
    return result;
}

} // namespace

Result<CompensatedCsv> writeCompensatedCsv(const std::filesystem::path &in, const std::filesystem::path &out,
                                           const ReadOptions &options, const TdeOfTemperature &tde,
                                           const ProgressHook &hook)
{
    const auto format = detectFormat(in);
    if (!format)
        return format.error();
    return *format == LogFormat::Csv ? fromCsv(in, out, options, tde, hook)
                                     : fromOther(in, out, options, tde, hook);
}

} // namespace driftbench
