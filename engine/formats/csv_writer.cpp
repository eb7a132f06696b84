#include "engine/formats/csv_writer.h"

#include <array>
#include <charconv>

namespace driftbench {

namespace {

// The longest double in fixed notation has 309 digits before the point.
constexpr std::size_t kLongestNumber = 400;
constexpr int kMostDecimals = 60;

char *formatNumber(char *to, double value, std::optional<int> decimals)
{
    char *const end = to + kLongestNumber;
    return decimals
               ? std::to_chars(to, end, value, std::chars_format::fixed, std::min(*decimals, kMostDecimals))
                     .ptr
               : std::to_chars(to, end, value).ptr;
}

} // namespace

void appendNumber(std::string &text, double value, std::optional<int> decimals)
{
    std::array<char, kLongestNumber> buffer; // what is used of it is written first
    text.append(buffer.data(), formatNumber(buffer.data(), value, decimals));
}

void appendCsvRows(std::string &text, const SampleBlock &block, Eigen::Index count, CsvDecimals decimals)
{
    for (Eigen::Index i = 0; i < count; ++i) {
        appendNumber(text, block.timeS[i], decimals.time);
        text += ',';
        appendNumber(text, block.temperatureC[i], decimals.temperature);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            text += ',';
            appendNumber(text, block.rateDps(i, axis), decimals.rate);
        }
        text += '\n';
    }
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

Status CsvWriter::write(const SampleBlock &block, Eigen::Index count)
{
    return writeRows(block.timeS, block.temperatureC, block.rateDps, count);
}

Status CsvWriter::write(const Recording &recording)
{
    return writeRows(recording.timeS, recording.temperatureC, recording.rateDps, recording.size());
}

Status CsvWriter::writeRows(const Eigen::VectorXd &timeS, const Eigen::VectorXd &temperatureC,
                            const Eigen::MatrixX3d &rateDps, Eigen::Index count)
{
    constexpr std::size_t kLongestRow = 5 * (kLongestNumber + 1);
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    std::vector<char> text(kChunk + kLongestRow);
    char *to = text.data();
    for (Eigen::Index i = 0; i < count; ++i) {
        to = formatNumber(to, timeS[i], m_decimals.time);
        *to++ = ',';
        to = formatNumber(to, temperatureC[i], m_decimals.temperature);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            *to++ = ',';
            to = formatNumber(to, rateDps(i, axis), m_decimals.rate);
        }
        *to++ = '\n';
        if (to < text.data() + kChunk)
            continue;
        if (Status written = m_file.write({text.data(), to}); !written)
            return written;
        to = text.data();
    }
    return m_file.write({text.data(), to});
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
