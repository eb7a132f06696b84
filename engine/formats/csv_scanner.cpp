#include "engine/formats/csv_scanner.h"

#include "engine/base/text.h"
#include "engine/formats/decimal.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace driftbench {

namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Text of a file as a message may show it.
std::string shown(std::string_view text)
{
    std::string clean(trimmed(text).substr(0, 40));
    std::replace_if(
        clean.begin(), clean.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return clean;
}

bool isMissingValue(std::string_view field)
{
    const std::string low = lowered(field);
    return low.empty() || low == "na" || low == "n/a" || low == "null" || low == "none";
}

} // namespace

CsvScanner::CsvScanner(FileWindow window, std::string file)
    : m_window(std::move(window)), m_file(std::move(file))
{
}

Result<CsvScanner> CsvScanner::open(const std::filesystem::path &path, const CsvOptions &options)
{
    auto window = FileWindow::open(path);
    if (!window)
        return window.error();
    CsvScanner scanner(std::move(*window), path.string());
    if (Status read = scanner.readPreamble(options); !read)
        return read.error();
    return scanner;
}

Status CsvScanner::readPreamble(const CsvOptions &options)
{
    m_window.fill(kByteOrderMark.size());
    if (m_window.bytes().starts_with(kByteOrderMark)) {
        m_preamble = kByteOrderMark;
        m_window.consume(kByteOrderMark.size());
    }
    std::string lastComment;
    while (fillLine()) {
        const std::string_view line(m_at, static_cast<std::size_t>(m_linesEnd - m_at));
        const std::string_view first = line.substr(0, line.find('\n') + 1);
        if (!trimmed(first).empty() && !isComment(first)) {
            auto layout = layoutFrom(first, lastComment, options);
            if (!layout)
                return layout.error();
            m_layout = std::move(*layout);
            prepareFastWay();
            return {};
        }
        if (isComment(first)) {
            readComment(first);
            lastComment = first;
        }
        m_preamble += first;
        m_at += first.size();
        ++m_line;
    }
    if (!m_status)
        return m_status;
    return Error{Errc::TooFewSamples,
                 m_file + " holds no rows, only comments and blank lines: record it again."};
}

// "# sensor_serial: SIM-0001"
void CsvScanner::readComment(std::string_view line)
{
    line = trimmed(line);
    line.remove_prefix(std::min(line.find_first_not_of("#%/ \t"), line.size()));
    const auto mark = line.find_first_of(":=");
    if (mark == std::string_view::npos)
        return;
    const std::string key = lowered(trimmed(line.substr(0, mark)));
    const std::string value(trimmed(line.substr(mark + 1)));
    if (key == "sensor_model")
        m_sensor.model = value;
    else if (key == "sensor_serial")
        m_sensor.serial = value;
    else if (key == "simulated")
        m_simulated = lowered(value) == "true";
}

Result<CsvLayout> CsvScanner::layoutFrom(std::string_view firstRow, std::string_view lastComment,
                                         const CsvOptions &options)
{
    const char separator = options.separator.value_or(guessSeparator(firstRow));
    const std::size_t columnCount = splitFields(firstRow, separator).size();
    const std::string_view following(m_at, static_cast<std::size_t>(m_linesEnd - m_at));
    if (!isNumeric(firstRow, separator)) {
        const std::string header(firstRow.substr(0, firstRow.find_first_of("\r\n")));
        m_preamble += firstRow;
        m_at += firstRow.size();
        ++m_line;
        return makeCsvLayout(header, columnCount, following.substr(firstRow.size()), separator, options,
                             m_file);
    }
    // Some programs write the header as a comment.
    std::string_view header = trimmed(lastComment);
    header.remove_prefix(std::min(header.find_first_not_of("#%/ \t"), header.size()));
    if (splitFields(header, separator).size() == columnCount) {
        auto layout = makeCsvLayout(header, columnCount, following, separator, options, m_file);
        if (layout)
            return layout;
    }
    return makeCsvLayout("", columnCount, following, separator, options, m_file);
}

void CsvScanner::prepareFastWay()
{
    const std::size_t last = *std::max_element(m_layout.fields.begin(), m_layout.fields.end());
    m_slots.assign(last + 1, -1);
    for (std::size_t quantity = 0; quantity < kCsvQuantityCount; ++quantity) {
        m_sharedColumn |= m_slots[m_layout.fields[quantity]] >= 0;
        m_slots[m_layout.fields[quantity]] = static_cast<int>(quantity);
        m_scaled |= !m_layout.scales[quantity].isIdentity();
    }
}

bool CsvScanner::fillLine()
{
    if (m_at != m_linesEnd)
        return true;
    if (m_inLastLine)
        return false;
    const char *const windowBegin = m_window.bytes().data();
    if (m_at != nullptr)
        m_window.consume(static_cast<std::size_t>(m_at - windowBegin));
    std::size_t lineEnd = std::string_view::npos;
    for (std::size_t wanted = FileWindow::kDefaultBytes; lineEnd == std::string_view::npos; wanted *= 2) {
        const bool more = m_window.fill(wanted);
        lineEnd = m_window.bytes().rfind('\n');
        if (!more)
            break;
        if (wanted > kLongestLine && lineEnd == std::string_view::npos) {
            m_status = Error{Errc::UnknownFormat, m_file + " has a line of over a megabyte at byte " +
                                                      std::to_string(m_window.offset()) +
                                                      ": it is no table of numbers; choose another file."};
            return false;
        }
    }
    const std::string_view bytes = m_window.bytes();
    if (lineEnd != std::string_view::npos) {
        m_at = bytes.data();
        m_linesEnd = m_at + lineEnd + 1;
        return true;
    }
    if (!m_window.status())
        m_status = m_window.status();
    if (!m_status || bytes.empty())
        return false;
    m_lastLine.assign(bytes.begin(), bytes.end());
    m_lastLine.push_back('\n');
    m_inLastLine = true;
    m_at = m_lastLine.data();
    m_linesEnd = m_at + m_lastLine.size();
    return true;
}

const char *CsvScanner::scanFast(const char *at, std::array<double, kCsvQuantityCount> &values) const
{
    if (m_sharedColumn || *at == '#' || *at == '%' || *at == '/')
        return nullptr;
    const char separator = m_layout.separator;
    for (std::size_t field = 0;; ++field) {
        const int slot = m_slots[field];
        if (slot >= 0) {
            while (*at == ' ')
                ++at;
            at = scanDecimal(at, m_linesEnd, values[static_cast<std::size_t>(slot)]);
            if (at == nullptr)
                return nullptr;
        } else {
            for (; *at != separator && *at != '\n'; ++at) {
                if (*at == '"' || *at == '\0')
                    return nullptr;
            }
        }
        if (field + 1 == m_slots.size())
            break;
        if (*at != separator)
            return nullptr;
        ++at;
    }
    if (*at == '\n')
        return at + 1;
    if (*at == '\r' && at[1] == '\n')
        return at + 2;
    if (*at != separator)
        return nullptr;
    return static_cast<const char *>(std::memchr(at, '\n', static_cast<std::size_t>(m_linesEnd - at))) + 1;
}

bool CsvScanner::next(CsvRow &row)
{
    if (!m_status || !fillLine())
        return false;
    ++m_line;
    if (const char *const behind = scanFast(m_at, row.values)) {
        row.kind = CsvRowKind::Sample;
        row.text = {m_at, static_cast<std::size_t>(behind - m_at)};
    } else {
        const auto *const lineEnd =
            static_cast<const char *>(std::memchr(m_at, '\n', static_cast<std::size_t>(m_linesEnd - m_at)));
        row.text = {m_at, static_cast<std::size_t>(lineEnd + 1 - m_at)};
        readCarefully({m_at, static_cast<std::size_t>(lineEnd - m_at)}, row);
    }
    if (row.kind == CsvRowKind::Sample && m_scaled) {
        for (std::size_t i = 0; i < kCsvQuantityCount; ++i)
            row.values[i] = m_layout.scales[i](row.values[i]);
    }
    m_at += row.text.size();
    if (m_inLastLine)
        row.text.remove_suffix(1);
    return m_status.ok();
}

void CsvScanner::readCarefully(std::string_view line, CsvRow &row)
{
    row.kind = CsvRowKind::Other;
    const std::string_view text = trimmed(line);
    if (text.empty() || isComment(text))
        return;
    if (!m_layout.headerLine.empty() && text == trimmed(m_layout.headerLine)) {
        ++m_repeatedHeaders;
        return;
    }
    if (readFields(line, row))
        row.kind = CsvRowKind::Sample;
}

bool CsvScanner::readFields(std::string_view line, CsvRow &row)
{
    const auto fields = splitFields(line, m_layout.separator);
    if (fields.size() < m_slots.size() || line.find('\0') != std::string_view::npos) {
        m_inLastLine ? noteCut(row) : noteDamage(row);
        return false;
    }
    for (std::size_t quantity = 0; quantity < kCsvQuantityCount; ++quantity) {
        const std::size_t field = m_layout.fields[quantity];
        const std::string_view text = unquoted(fields[field]);
        const auto number = parseNumber(text);
        row.values[quantity] = number.value_or(std::numeric_limits<double>::quiet_NaN());
        if (number || isMissingValue(text))
            continue;
        if (m_inLastLine) {
            noteCut(row);
            return false;
        }
        const bool decimalComma = text.find(',') != std::string_view::npos;
        m_status = Error{
            Errc::NotANumber,
            m_file + ", line " + std::to_string(m_line) + ", column " + std::to_string(field + 1) + " (" +
                m_layout.names[quantity] + "): \"" + shown(text) + "\" is not a number; " +
                (decimalComma ? "write numbers with a decimal point." : "correct or delete this line.")};
        return false;
    }
    return true;
}

std::uint64_t CsvScanner::offsetOfLine() const
{
    const char *const begin = m_inLastLine ? m_lastLine.data() : m_window.bytes().data();
    return m_window.offset() + static_cast<std::uint64_t>(m_at - begin);
}

void CsvScanner::noteDamage(CsvRow &row)
{
    row.kind = CsvRowKind::Damaged;
    if (m_damagedRows++ == 0) {
        m_firstDamageLine = m_line;
        m_firstDamageOffset = offsetOfLine();
    }
}

void CsvScanner::noteCut(CsvRow &row)
{
    row.kind = CsvRowKind::Damaged;
    m_cut = true;
    m_cutOffset = offsetOfLine();
}

std::vector<std::string> CsvScanner::warnings() const
{
    std::vector<std::string> all = m_layout.warnings;
    if (m_damagedRows > 0) {
        all.push_back(m_file + " is damaged at line " + std::to_string(m_firstDamageLine) + " (byte " +
                      std::to_string(m_firstDamageOffset) + "): " + std::to_string(m_damagedRows) +
                      " rows with too few columns or with zero bytes were left out.");
    }
    if (m_cut) {
        all.push_back(m_file + " was cut off in line " + std::to_string(m_line) + " (byte " +
                      std::to_string(m_cutOffset) + "): the rows before it were read.");
    }
    if (m_repeatedHeaders > 0) {
        all.push_back(m_file + " repeats its header " + std::to_string(m_repeatedHeaders) +
                      " times: it was probably joined from several logs.");
    }
    return all;
}

double CsvScanner::fractionRead() const
{
    return static_cast<double>(m_window.offset()) / static_cast<double>(m_window.fileBytes());
}

} // namespace driftbench
