#include "engine/formats/csv_writer.h"

#include <array>
#include <charconv>

namespace driftbench {

void appendNumber(std::string &text, double value, std::optional<int> decimals)
{
    std::array<char, 400> buffer{}; // the longest double in fixed notation has 309 digits before the point
    constexpr int kMostDecimals = 60;
    char *const begin = buffer.data();
    char *const end = begin + buffer.size();
    const auto [behind, code] = decimals ? std::to_chars(begin, end, value, std::chars_format::fixed,
                                                         std::min(*decimals, kMostDecimals))
                                         : std::to_chars(begin, end, value);
    text.append(begin, behind);
}

Result<CsvWriter> CsvWriter::create(const std::filesystem::path &path, CsvDecimals decimals,
                                    const std::vector<std::string> &commentLines)
{
    auto file = AtomicFile::create(path);
    if (!file)
        return file.error();
    CsvWriter writer(std::move(*file), decimals);
    std::string head;
    for (const std::string &line : commentLines)
        head += "# " + line + '\n';
    head += kCsvHeader;
    head += '\n';
    if (Status written = writer.m_file.write(head); !written)
        return written.error();
    return writer;
}

Status CsvWriter::write(const SampleBlock &block)
{
    return writeRows(block.timeS, block.temperatureC, block.rateDps);
}

Status CsvWriter::write(const Recording &recording)
{
    return writeRows(recording.timeS, recording.temperatureC, recording.rateDps);
}

Status CsvWriter::writeRows(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                            const Eigen::MatrixX3d &rateDps)
{
    std::string row;
    for (Eigen::Index i = 0; i < timeS.size(); ++i) {
        row.clear();
        appendNumber(row, timeS[i], m_decimals.time);
        row += ',';
        appendNumber(row, temperatureC[i], m_decimals.temperature);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            row += ',';
            appendNumber(row, rateDps(i, axis), m_decimals.rate);
        }
        row += '\n';
        if (Status written = m_file.write(row); !written)
            return written;
    }
    return {};
}

Status writeCsv(const std::filesystem::path &path, const Recording &recording, CsvDecimals decimals)
{
    auto writer = CsvWriter::create(path, decimals);
    if (!writer)
        return writer.error();
    if (Status written = writer->write(recording); !written)
        return written;
    return writer->commit();
}

} // namespace driftbench
