#include "engine/formats/ulog_parser.h"

#include "engine/formats/little_endian.h"

#include <utility>

namespace driftbench {

namespace {

constexpr std::string_view kMagic{"ULog\x01\x12\x35", 7};
constexpr std::string_view kSyncMagic{"\x2F\x73\x13\x20\x25\x0C\xBB\x12", 8};
constexpr std::size_t kHeaderBytes = 16;
constexpr std::size_t kMessageHeader = 3;
constexpr std::size_t kWindowBytes = std::size_t{1} << 19;
constexpr std::size_t kFlagBytes = 40;
constexpr int kMessagesInChain = 3;

// Types that begin with the length of a key, and where that length stands.
bool hasSoundKey(std::string_view payload, std::size_t at)
{
    return payload.size() > at && static_cast<unsigned char>(payload[at]) + at < payload.size();
}

} // namespace

bool looksLikeULog(std::string_view beginning)
{
    return beginning.starts_with(kMagic);
}

Result<ULogParser> ULogParser::open(const std::filesystem::path &path)
{
    auto window = FileWindow::open(path, kWindowBytes);
    if (!window)
        return window.error();
    ULogParser parser(std::move(*window));
    if (Status read = parser.readHeader(path); !read)
        return read.error();
    return parser;
}

Status ULogParser::readHeader(const std::filesystem::path &path)
{
    if (!m_window.fill(kHeaderBytes) || !looksLikeULog(m_window.bytes()))
        return Error{Errc::UnknownFormat,
                     path.string() + " does not begin like a ULog: choose another file."};
    m_window.consume(kHeaderBytes);
    constexpr std::size_t kBytes = kMessageHeader + kFlagBytes;
    if (!m_window.fill(kBytes) || m_window.bytes()[2] != 'B' || messageBytes(0) < kBytes)
        return {};
    const std::string_view flags = m_window.bytes().substr(kMessageHeader);
    constexpr char kAppended = 1;
    bool unknown = (flags[8] & ~kAppended) != 0;
    for (std::size_t i = 9; i < 16; ++i)
        unknown |= flags[i] != 0;
    if (unknown) {
        return Error{Errc::UnknownFormat, path.string() +
                                              " uses features of ULog that are not known here (byte 27): "
                                              "use a newer version of this program."};
    }
    for (std::size_t i = 0; i < m_appendedAt.size(); ++i)
        m_appendedAt[i] = (flags[8] & kAppended) != 0 ? littleEndian<std::uint64_t>(flags, 16 + 8 * i) : 0;
    return {};
}

double ULogParser::fractionRead() const
{
    return static_cast<double>(m_window.offset()) / static_cast<double>(m_window.fileBytes());
}

std::size_t ULogParser::messageBytes(std::size_t at) const
{
    return kMessageHeader + littleEndian<std::uint16_t>(m_window.bytes(), at);
}

ULogParser::Sense ULogParser::senseOfData(std::string_view payload) const
{
    if (payload.size() < 2)
        return Sense::None;
    const auto found = m_subscriptions.find(littleEndian<std::uint16_t>(payload, 0));
    if (found == m_subscriptions.end())
        return Sense::Unknown;
    const ULogFormat &format = *found->second.format;
    const std::size_t bytes = payload.size() - 2;
    return bytes == format.bytes || bytes == format.bytes - format.trailingPadding ? Sense::Good
                                                                                   : Sense::Unknown;
}

ULogParser::Sense ULogParser::senseAt(std::size_t at)
{
    if (!m_window.fill(at + kMessageHeader))
        return Sense::None;
    const char type = m_window.bytes()[at + 2];
    if (std::string_view("BFIMPQARDLCSO").find(type) == std::string_view::npos && (type < 'A' || type > 'Z'))
        return Sense::None;
    const std::size_t bytes = messageBytes(at);
    if (!m_window.fill(at + bytes))
        return Sense::None;
    const std::string_view payload = m_window.bytes().substr(at + kMessageHeader, bytes - kMessageHeader);
    const auto goodIf = [](bool condition) { return condition ? Sense::Good : Sense::None; };
    switch (type) {
    case 'D':
        return senseOfData(payload);
    case 'S':
        return goodIf(payload == kSyncMagic);
    case 'F':
        return goodIf(payload.size() >= 3 && payload.find(':') != std::string_view::npos);
    case 'A':
        return goodIf(payload.size() > 3);
    case 'R':
    case 'O':
        return goodIf(payload.size() == 2);
    case 'I':
    case 'P':
        return goodIf(hasSoundKey(payload, 0));
    case 'M':
    case 'Q':
        return goodIf(hasSoundKey(payload, 1));
    case 'L':
        return goodIf(payload.size() >= 9);
    case 'C':
        return goodIf(payload.size() >= 11);
    case 'B':
        return goodIf(payload.size() >= kFlagBytes);
    default:
        return Sense::Unknown;
    }
}

// An unknown message is one only if something known, or the end of the file, follows it.
bool ULogParser::makesSense()
{
    const Sense sense = senseAt(0);
    if (sense != Sense::Unknown)
        return sense == Sense::Good;
    const std::size_t bytes = messageBytes(0);
    return !m_window.fill(bytes + 1) || senseAt(bytes) == Sense::Good;
}

bool ULogParser::chainAt(std::size_t at)
{
    for (int i = 0; i < kMessagesInChain; ++i) {
        if (i > 0 && !m_window.fill(at + 1))
            return true;
        if (senseAt(at) != Sense::Good)
            return false;
        at += messageBytes(at);
    }
    return true;
}

void ULogParser::resynchronise()
{
    const std::uint64_t from = m_window.offset();
    m_window.consume(1);
    while (m_window.fill(kMessageHeader) && !chainAt(0))
        m_window.consume(1);
    if (m_window.bytes().size() < kMessageHeader) {
        m_window.consume(m_window.bytes().size());
        m_damage.toTheEnd = true;
    }
    m_damage.add(from, m_window.offset() - from);
}

// The logger appends where the file ended; a message that was being written then is cut there.
bool ULogParser::skipToAppendedData()
{
    for (const std::uint64_t appended : m_appendedAt) {
        const std::uint64_t at = m_window.offset();
        if (appended > at && appended < at + messageBytes(0) &&
            m_window.fill(static_cast<std::size_t>(appended - at) + 1)) {
            m_window.consume(static_cast<std::size_t>(appended - at));
            return true;
        }
    }
    return false;
}

bool ULogParser::next(ULogMessage &message)
{
    m_window.consume(std::exchange(m_toConsume, 0));
    while (m_window.fill(1)) {
        if (m_window.fill(kMessageHeader) && skipToAppendedData())
            continue;
        if (!makesSense()) {
            resynchronise();
            continue;
        }
        m_toConsume = messageBytes(0);
        const std::string_view bytes = m_window.bytes();
        take(bytes[2], bytes.substr(kMessageHeader, m_toConsume - kMessageHeader), message);
        return true;
    }
    return false;
}

void ULogParser::take(char type, std::string_view payload, ULogMessage &message)
{
    message = {type, payload, nullptr};
    if (type == 'F') {
        m_schema.define(payload);
    } else if (type == 'A') {
        subscribe(payload);
    } else if (type == 'D') {
        message.payload.remove_prefix(2);
        if (senseOfData(payload) == Sense::Good)
            message.subscription = &m_subscriptions.find(littleEndian<std::uint16_t>(payload, 0))->second;
    }
}

// Bounded, so that no file can make us keep more than it should.
std::shared_ptr<const ULogFormat> ULogParser::formatOf(std::string_view topic)
{
    constexpr std::size_t kMostTopics = 4096;
    constexpr std::size_t kMostFields = 100000;
    if (const auto known = m_topics.find(topic); known != m_topics.end())
        return known->second;
    if (m_topics.size() == kMostTopics)
        return nullptr;
    auto format = m_schema.format(topic);
    std::shared_ptr<const ULogFormat> shared;
    if (format && m_topicFields + format->fields.size() <= kMostFields) {
        m_topicFields += format->fields.size();
        shared = std::make_shared<const ULogFormat>(std::move(*format));
    }
    m_topics.emplace(topic, shared);
    return shared;
}

void ULogParser::subscribe(std::string_view payload)
{
    const auto id = littleEndian<std::uint16_t>(payload, 1);
    const std::string_view topic = payload.substr(3);
    auto format = formatOf(topic);
    if (!format)
        return;
    ULogSubscription subscription{std::string(topic), static_cast<unsigned char>(payload[0]),
                                  std::move(format)};
    m_subscriptions.insert_or_assign(id, std::move(subscription));
}

} // namespace driftbench
