#include "engine/formats/dataflash_parser.h"

#include "engine/formats/little_endian.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace driftbench {

namespace {

constexpr std::string_view kStart{"\xA3\x95", 2};
constexpr std::size_t kHeaderBytes = 3;
constexpr std::uint8_t kFormatType = 128;
constexpr std::size_t kFormatBytes = 86;
constexpr std::size_t kNameAt = 2;
constexpr std::size_t kNameBytes = 4;
constexpr std::size_t kLettersAt = 6;
constexpr std::size_t kLettersBytes = 16;
constexpr std::size_t kLabelsAt = 22;
constexpr std::size_t kLabelsBytes = 64;
constexpr int kMessagesInChain = 3;

std::size_t fieldBytes(char letter)
{
    switch (letter) {
    case 'b':
    case 'B':
    case 'M':
        return 1;
    case 'h':
    case 'H':
    case 'c':
    case 'C':
    case 'g':
        return 2;
    case 'i':
    case 'I':
    case 'e':
    case 'E':
    case 'L':
    case 'f':
    case 'n':
        return 4;
    case 'd':
    case 'q':
    case 'Q':
        return 8;
    case 'N':
        return 16;
    case 'Z':
    case 'a':
        return 64;
    default:
        return 0;
    }
}

// Text of at most `bytes`, ended by a zero byte if it is shorter.
std::string_view textAt(std::string_view payload, std::size_t at, std::size_t bytes)
{
    const std::string_view text = payload.substr(at, bytes);
    return text.substr(0, text.find('\0'));
}

DataFlashFormat formatOfFormats()
{
    return {
        "FMT",
        kFormatBytes,
        {{"Type", 'B', 0}, {"Length", 'B', 1}, {"Name", 'n', 2}, {"Format", 'N', 6}, {"Columns", 'Z', 22}}};
}

} // namespace

bool looksLikeDataFlash(std::string_view beginning)
{
    const std::string_view format("\xA3\x95\x80", kHeaderBytes);
    return beginning.starts_with(format) || beginning.find(std::string(format) + "\x80\x59"
                                                                                 "FMT") != beginning.npos;
}

const DataFlashField *DataFlashFormat::find(std::string_view field) const
{
    for (const DataFlashField &one : fields) {
        if (one.name == field)
            return &one;
    }
    return nullptr;
}

std::optional<double> dataFlashNumber(std::string_view payload, const DataFlashField &field)
{
    constexpr double kHundredths = 100.0;
    constexpr double kDegreesE7 = 1e7;
    const std::size_t at = field.offset;
    switch (field.type) {
    case 'b':
        return littleEndian<std::int8_t>(payload, at);
    case 'B':
    case 'M':
        return littleEndian<std::uint8_t>(payload, at);
    case 'h':
        return littleEndian<std::int16_t>(payload, at);
    case 'H':
        return littleEndian<std::uint16_t>(payload, at);
    case 'c':
        return littleEndian<std::int16_t>(payload, at) / kHundredths;
    case 'C':
        return littleEndian<std::uint16_t>(payload, at) / kHundredths;
    case 'i':
        return littleEndian<std::int32_t>(payload, at);
    case 'I':
        return littleEndian<std::uint32_t>(payload, at);
    case 'e':
        return littleEndian<std::int32_t>(payload, at) / kHundredths;
    case 'E':
        return littleEndian<std::uint32_t>(payload, at) / kHundredths;
    case 'L':
        return littleEndian<std::int32_t>(payload, at) / kDegreesE7;
    case 'q':
        return static_cast<double>(littleEndian<std::int64_t>(payload, at));
    case 'Q':
        return static_cast<double>(littleEndian<std::uint64_t>(payload, at));
    case 'f':
        return static_cast<double>(littleEndian<float>(payload, at));
    case 'd':
        return littleEndian<double>(payload, at);
    default:
        return std::nullopt;
    }
}

std::string dataFlashText(std::string_view payload, const DataFlashField &field)
{
    return std::string(textAt(payload, field.offset, fieldBytes(field.type)));
}

DataFlashParser::DataFlashParser(FileWindow window) : m_window(std::move(window))
{
    m_formats[kFormatType] = formatOfFormats();
}

Result<DataFlashParser> DataFlashParser::open(const std::filesystem::path &path)
{
    auto window = FileWindow::open(path);
    if (!window)
        return window.error();
    return DataFlashParser(std::move(*window));
}

double DataFlashParser::fractionRead() const
{
    return static_cast<double>(m_window.offset()) / static_cast<double>(m_window.fileBytes());
}

std::size_t DataFlashParser::knownMessageAt(std::size_t at)
{
    if (!m_window.fill(at + kHeaderBytes) || m_window.bytes().substr(at, kStart.size()) != kStart)
        return 0;
    const auto type = static_cast<std::uint8_t>(m_window.bytes()[at + kStart.size()]);
    if (!m_formats[type])
        return 0;
    const std::size_t bytes = kHeaderBytes + m_formats[type]->bytes;
    return m_window.fill(at + bytes) ? bytes : 0;
}

bool DataFlashParser::chainAt(std::size_t at)
{
    for (int i = 0; i < kMessagesInChain; ++i) {
        if (i > 0 && !m_window.fill(at + 1))
            return true;
        const std::size_t bytes = knownMessageAt(at);
        if (bytes == 0)
            return false;
        at += bytes;
    }
    return true;
}

void DataFlashParser::resynchronise()
{
    const std::uint64_t from = m_window.offset();
    m_window.consume(1);
    while (m_window.fill(kHeaderBytes) && !chainAt(0)) {
        const auto start = m_window.bytes().find(kStart[0], 1);
        m_window.consume(start == std::string_view::npos ? m_window.bytes().size() : start);
    }
    if (m_window.bytes().size() < kHeaderBytes) {
        m_window.consume(m_window.bytes().size());
        m_damage.toTheEnd = true;
    }
    m_damage.add(from, m_window.offset() - from);
}

bool DataFlashParser::next(DataFlashMessage &message)
{
    m_window.consume(std::exchange(m_toConsume, 0));
    while (m_window.fill(1)) {
        const std::size_t bytes = knownMessageAt(0);
        const std::string_view payload = m_window.bytes().substr(
            std::min(kHeaderBytes, m_window.bytes().size()), bytes - std::min(bytes, kHeaderBytes));
        const auto type = bytes == 0 ? 0 : static_cast<std::uint8_t>(m_window.bytes()[kStart.size()]);
        if (bytes == 0 || (type == kFormatType && !define(payload))) {
            resynchronise();
            continue;
        }
        m_toConsume = bytes;
        message = {&*m_formats[type], payload};
        return true;
    }
    return false;
}

// The first definition of a type counts: loggers repeat it unchanged. False if it contradicts itself.
bool DataFlashParser::define(std::string_view payload)
{
    const auto type = static_cast<std::uint8_t>(payload[0]);
    const auto length = static_cast<std::uint8_t>(payload[1]);
    if (m_formats[type])
        return true;
    DataFlashFormat format;
    format.name = textAt(payload, kNameAt, kNameBytes);
    std::string_view labels = textAt(payload, kLabelsAt, kLabelsBytes);
    for (const char letter : textAt(payload, kLettersAt, kLettersBytes)) {
        if (fieldBytes(letter) == 0)
            return false;
        const auto end = std::min(labels.find(','), labels.size());
        format.fields.push_back({std::string(labels.substr(0, end)), letter, format.bytes});
        format.bytes += fieldBytes(letter);
        labels.remove_prefix(std::min(end + 1, labels.size()));
    }
    if (format.name.empty() || length != format.bytes + kHeaderBytes)
        return false;
    m_formats[type] = std::move(format);
    return true;
}

} // namespace driftbench
