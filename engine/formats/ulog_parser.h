// The messages of a PX4 ULog file, one after another.
//
// Header of 16 bytes (magic "ULog" 01 12 35, version, start time in microseconds), then messages of a 16-bit
// size, a type letter and that many bytes: definitions (B F I M P Q), subscriptions (A R) and data (D L C S
// O). All little-endian. Data appended after a crash are found through the offsets in the B message. Source:
// the ULog file format in the PX4 developer guide.
//
// Where a message makes no sense the parser looks for the next place from which three messages in a row do,
// and notes what lies between as damage.
#pragma once

#include "engine/base/result.h"
#include "engine/formats/file_window.h"
#include "engine/formats/log_damage.h"
#include "engine/formats/ulog_schema.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace driftbench {

struct ULogSubscription
{
    std::string topic;
    int multiId = 0;
    std::shared_ptr<const ULogFormat> format;
};

struct ULogMessage
{
    char type = 0;
    std::string_view payload;                       // valid until the next call; of D: without the id
    const ULogSubscription *subscription = nullptr; // of D; null if it is not known
};

bool looksLikeULog(std::string_view beginning);

class ULogParser
{
public:
    // UnknownFormat if the file is no ULog or uses features that must be understood and are not.
    static Result<ULogParser> open(const std::filesystem::path &path);

    bool next(ULogMessage &message); // false at the end, or where the disk fails
    const Status &status() const { return m_window.status(); }
    const LogDamage &damage() const { return m_damage; }
    double fractionRead() const;

private:
    enum class Sense
    {
        Good,
        Unknown, // a message of a kind or a subscription that is not known
        None
    };

    explicit ULogParser(FileWindow window) : m_window(std::move(window)) {}

    Status readHeader(const std::filesystem::path &path);
    std::size_t messageBytes(std::size_t at) const; // with its header
    Sense senseAt(std::size_t at);
    Sense senseOfData(std::string_view payload) const;
    bool makesSense();
    bool chainAt(std::size_t at);
    void resynchronise();
    bool skipToAppendedData();
    void take(char type, std::string_view payload, ULogMessage &message);
    void subscribe(std::string_view payload);
    std::shared_ptr<const ULogFormat> formatOf(std::string_view topic);

    FileWindow m_window;
    ULogSchema m_schema;
    std::map<std::string, std::shared_ptr<const ULogFormat>, std::less<>> m_topics; // null: not usable
    std::size_t m_topicFields = 0;                                                  // in all of them
    std::unordered_map<std::uint16_t, ULogSubscription> m_subscriptions;
    std::array<std::uint64_t, 3> m_appendedAt{};
    LogDamage m_damage;
    std::size_t m_toConsume = 0; // the message handed out last
};

} // namespace driftbench
