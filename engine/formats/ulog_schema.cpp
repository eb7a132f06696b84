#include "engine/formats/ulog_schema.h"

#include "engine/base/text.h"
#include "engine/formats/little_endian.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace driftbench {

namespace {

constexpr std::size_t kLargestMessage = 65535;
constexpr std::size_t kMostFields = 4096;
constexpr int kDeepestNesting = 8;
constexpr std::size_t kLongestName = 256;
constexpr std::size_t kMostFormats = 4096;

constexpr std::array<std::pair<std::string_view, ULogType>, 12> kTypes{{{"int8_t", ULogType::Int8},
                                                                        {"uint8_t", ULogType::UInt8},
                                                                        {"int16_t", ULogType::Int16},
                                                                        {"uint16_t", ULogType::UInt16},
                                                                        {"int32_t", ULogType::Int32},
                                                                        {"uint32_t", ULogType::UInt32},
                                                                        {"int64_t", ULogType::Int64},
                                                                        {"uint64_t", ULogType::UInt64},
                                                                        {"float", ULogType::Float},
                                                                        {"double", ULogType::Double},
                                                                        {"bool", ULogType::Bool},
                                                                        {"char", ULogType::Char}}};

double numberAt(std::string_view data, std::size_t offset, ULogType type)
{
    switch (type) {
    case ULogType::Int8:
        return littleEndian<std::int8_t>(data, offset);
    case ULogType::UInt8:
    case ULogType::Bool:
    case ULogType::Char:
        return littleEndian<std::uint8_t>(data, offset);
    case ULogType::Int16:
        return littleEndian<std::int16_t>(data, offset);
    case ULogType::UInt16:
        return littleEndian<std::uint16_t>(data, offset);
    case ULogType::Int32:
        return littleEndian<std::int32_t>(data, offset);
    case ULogType::UInt32:
        return littleEndian<std::uint32_t>(data, offset);
    case ULogType::Int64:
        return static_cast<double>(littleEndian<std::int64_t>(data, offset));
    case ULogType::UInt64:
        return static_cast<double>(littleEndian<std::uint64_t>(data, offset));
    case ULogType::Float:
        return static_cast<double>(littleEndian<float>(data, offset));
    case ULogType::Double:
        return littleEndian<double>(data, offset);
    }
    return 0.0;
}

} // namespace

std::optional<ULogType> ulogTypeNamed(std::string_view name)
{
    for (const auto &[spelling, type] : kTypes) {
        if (spelling == name)
            return type;
    }
    return std::nullopt;
}

std::size_t ulogTypeBytes(ULogType type)
{
    constexpr std::array<std::size_t, 12> kBytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 1, 1};
    return kBytes[static_cast<std::size_t>(type)];
}

std::optional<double> ulogNumber(std::string_view data, const ULogField &field, std::size_t index)
{
    const std::size_t offset = field.offset + index * ulogTypeBytes(field.type);
    if (index >= field.count || offset + ulogTypeBytes(field.type) > data.size())
        return std::nullopt;
    return numberAt(data, offset, field.type);
}

const ULogField *ULogFormat::find(std::string_view name) const
{
    for (const ULogField &field : fields) {
        if (field.name == name)
            return &field;
    }
    return nullptr;
}

bool ULogSchema::define(std::string_view definition)
{
    const auto colon = definition.find(':');
    if (colon == std::string_view::npos || colon == 0 || m_formats.size() == kMostFormats)
        return false;
    std::vector<Member> members;
    std::string_view rest = definition.substr(colon + 1);
    while (!rest.empty()) {
        const auto end = std::min(rest.find(';'), rest.size());
        const std::string_view text = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (text.empty())
            continue;
        const auto space = text.find(' ');
        if (space == std::string_view::npos || text.size() > kLongestName || members.size() == kMostFields)
            return false;
        Member member{std::string(text.substr(0, space)), std::string(trimmed(text.substr(space))), 1, false};
        if (const auto bracket = member.type.find('['); bracket != std::string::npos) {
            member.isArray = true;
            const char *const first = member.type.data() + bracket + 1;
            const auto [behind, code] =
                std::from_chars(first, member.type.data() + member.type.size(), member.count);
            if (code != std::errc() || *behind != ']' || member.count == 0 || member.count > kLargestMessage)
                return false;
            member.type.resize(bracket);
        }
        members.push_back(std::move(member));
    }
    return m_formats.emplace(definition.substr(0, colon), std::move(members)).second;
}

std::optional<ULogFormat> ULogSchema::format(std::string_view name) const
{
    ULogFormat flat;
    if (!flatten(std::string(name), "", 0, flat))
        return std::nullopt;
    return flat;
}

bool ULogSchema::flatten(const std::string &name, const std::string &prefix, int depth,
                         ULogFormat &into) const
{
    const auto found = m_formats.find(name);
    if (found == m_formats.end() || depth > kDeepestNesting)
        return false;
    for (const Member &member : found->second) {
        if (!flattenMember(member, prefix, depth, into))
            return false;
    }
    return true;
}

bool ULogSchema::flattenMember(const Member &member, const std::string &prefix, int depth,
                               ULogFormat &into) const
{
    if (const auto type = ulogTypeNamed(member.type)) {
        const std::size_t bytes = member.count * ulogTypeBytes(*type);
        into.fields.push_back({prefix + member.name, *type, into.bytes, member.count});
        into.bytes += bytes;
        into.trailingPadding = member.name.starts_with("_padding") ? bytes : 0;
        return into.bytes <= kLargestMessage && into.fields.size() <= kMostFields;
    }
    for (std::size_t i = 0; i < member.count; ++i) {
        const std::string index = member.isArray ? "[" + std::to_string(i) + "]" : std::string();
        const std::size_t before = into.bytes;
        if (!flatten(member.type, prefix + member.name + index + ".", depth + 1, into))
            return false;
        // A format without fields would let a large array of them run for ever at no size.
        if (into.bytes == before)
            return false;
    }
    into.trailingPadding = 0;
    return true;
}

} // namespace driftbench
