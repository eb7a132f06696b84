// The formats that a ULog defines for its messages, flattened to fields at fixed places.
//
// A definition reads "sensor_gyro:uint64_t timestamp;float x;float[3] v;other_format nested;". Source: the
// ULog file format in the PX4 developer guide, section "Format Message".
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class ULogType
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float,
    Double,
    Bool,
    Char
};

struct ULogField
{
    std::string name; // of a nested field: "outer.inner", in arrays of formats "outer[1].inner"
    ULogType type = ULogType::UInt8;
    std::size_t offset = 0; // in the message's data
    std::size_t count = 1;  // of an array
};

struct ULogFormat
{
    std::vector<ULogField> fields;
    std::size_t bytes = 0;
    std::size_t trailingPadding = 0; // not written by the logger

    const ULogField *find(std::string_view name) const;
};

class ULogSchema
{
public:
    bool define(std::string_view definition); // false if it makes no sense; the first of a name counts

    // Nothing if the format, or one that it nests, is not defined or larger than a message can be.
    std::optional<ULogFormat> format(std::string_view name) const;

private:
    struct Member
    {
        std::string type;
        std::string name;
        std::size_t count = 1;
        bool isArray = false;
    };
    bool flatten(const std::string &name, const std::string &prefix, int depth, ULogFormat &into) const;
    bool flattenMember(const Member &member, const std::string &prefix, int depth, ULogFormat &into) const;

    std::map<std::string, std::vector<Member>, std::less<>> m_formats;
};

std::optional<ULogType> ulogTypeNamed(std::string_view name);
std::size_t ulogTypeBytes(ULogType type);

// Element `index` of the field as a double; nothing if the data end before it.
std::optional<double> ulogNumber(std::string_view data, const ULogField &field, std::size_t index = 0);

} // namespace driftbench
