// The messages of an ArduPilot DataFlash log (binary), one after another.
//
// Every message begins with A3 95 and its type. Messages of type 128 (FMT) define the others: type, length
// with the header, name, one letter per field for its type, names of the fields. All little-endian. Source:
// the ArduPilot developer guide, "Logging", and the letters in LogStructure.h.
//
// Where no known message begins, the parser looks for the next place where one does that another one, or the
// end, follows; what lies between is noted as damage.
#pragma once

#include "engine/base/result.h"
#include "engine/formats/file_window.h"
#include "engine/formats/log_damage.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

struct DataFlashField
{
    std::string name;
    char type = 0;          // the letter
    std::size_t offset = 0; // in the payload
};

struct DataFlashFormat
{
    std::string name;
    std::size_t bytes = 0; // of the payload
    std::vector<DataFlashField> fields;

    const DataFlashField *find(std::string_view field) const;
};

struct DataFlashMessage
{
    const DataFlashFormat *format = nullptr;
    std::string_view payload; // valid until the next call
};

bool looksLikeDataFlash(std::string_view beginning);

// A field as a number with its scale applied (letters c, C, e, E are hundredths); nothing for text and
// arrays.
std::optional<double> dataFlashNumber(std::string_view payload, const DataFlashField &field);
std::string dataFlashText(std::string_view payload, const DataFlashField &field); // letters n, N, Z

class DataFlashParser
{
public:
    static Result<DataFlashParser> open(const std::filesystem::path &path);

    bool next(DataFlashMessage &message); // false at the end, or where the disk fails
    const Status &status() const { return m_window.status(); }
    const LogDamage &damage() const { return m_damage; }
    double fractionRead() const;

private:
    explicit DataFlashParser(FileWindow window);

    std::size_t knownMessageAt(std::size_t at); // its bytes with the header; 0 if none is there
    bool chainAt(std::size_t at);
    void resynchronise();
    bool define(std::string_view payload);

    FileWindow m_window;
    std::array<std::optional<DataFlashFormat>, 256> m_formats;
    LogDamage m_damage;
    std::size_t m_toConsume = 0; // the message handed out last
};

} // namespace driftbench
