// Small writers of ULog and DataFlash, for the cases that no real log at hand has. They follow the published
// descriptions of the formats and share no code with the readers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace driftbench::test {

inline void writeBytes(const std::filesystem::path &path, std::string_view bytes)
{
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string readBytes(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

template <class Number>
std::string bytesOf(Number number)
{
    return {reinterpret_cast<const char *>(&number), sizeof(number)};
}

class ULogEncoder
{
public:
    explicit ULogEncoder(bool withFlags = true, std::uint64_t appendedAt = 0)
    {
        m_bytes = std::string("ULog\x01\x12\x35\x01", 8) + bytesOf(std::uint64_t{1000});
        if (!withFlags)
            return;
        std::string flags(16, '\0');
        flags[8] = appendedAt != 0 ? 1 : 0;
        message('B', flags + bytesOf(appendedAt) + std::string(16, '\0'));
    }

    void message(char type, const std::string &payload)
    {
        m_bytes += bytesOf(static_cast<std::uint16_t>(payload.size())) + type + payload;
    }
    void format(const std::string &definition) { message('F', definition); }
    void subscribe(std::uint8_t multiId, std::uint16_t id, const std::string &topic)
    {
        message('A', bytesOf(multiId) + bytesOf(id) + topic);
    }
    void data(std::uint16_t id, const std::string &fields) { message('D', bytesOf(id) + fields); }
    void parameter(const std::string &name, std::int32_t value)
    {
        const std::string key = "int32_t " + name;
        message('P', static_cast<char>(key.size()) + key + bytesOf(value));
    }
    void raw(const std::string &bytes) { m_bytes += bytes; }

    const std::string &bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

class DataFlashEncoder
{
public:
    DataFlashEncoder() { format(128, "FMT", 86, "BBnNZ", "Type,Length,Name,Format,Columns"); }

    // bytes: of the payload
    void format(std::uint8_t type, const std::string &name, std::size_t bytes, const std::string &letters,
                const std::string &labels)
    {
        message(128, std::string(1, static_cast<char>(type)) + static_cast<char>(bytes + 3) +
                         padded(name, 4) + padded(letters, 16) + padded(labels, 64));
    }
    void message(std::uint8_t type, const std::string &payload)
    {
        m_bytes += std::string("\xA3\x95", 2) + static_cast<char>(type) + payload;
    }
    void raw(const std::string &bytes) { m_bytes += bytes; }

    static std::string padded(std::string text, std::size_t bytes)
    {
        text.resize(bytes, '\0');
        return text;
    }

    const std::string &bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

} // namespace driftbench::test
