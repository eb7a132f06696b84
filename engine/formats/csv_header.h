// Where in the rows of a table the five quantities stand, and in which units: from the options and, where
// they are silent, from the spelling of the header.
//
// Errors: MissingColumn (names the columns that are there), InvalidOption (counts without a sensitivity).
#pragma once

#include "engine/base/result.h"
#include "engine/formats/read_options.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

struct CsvLayout
{
    char separator = ',';
    std::string headerLine;                              // as it stands, no line end; empty: none
    std::array<std::size_t, kCsvQuantityCount> fields{}; // per quantity, counted from 0
    std::array<std::string, kCsvQuantityCount> names;    // of those columns; "column 3" without a header
    std::array<UnitScale, kCsvQuantityCount> scales;     // to s, degrees Celsius and dps
    bool rateUnitStated = false;                         // by header or option
    bool timeUnitStated = false;
    std::vector<std::string> warnings;
};

// Fields of a line without its end; a separator inside double quotes does not separate.
std::vector<std::string_view> splitFields(std::string_view line, char separator);
// Without white space and double quotes at both ends.
std::string_view unquoted(std::string_view field);

bool isComment(std::string_view line); // begins with #, % or //

// Of the separators a table may have, the one this line has most of.
char guessSeparator(std::string_view line);

// Whether every field that is not empty is a number.
bool isNumeric(std::string_view line, char separator);

// headerLine is empty where the table has none; `columnCount` is then that of the first row. following: text
// of some rows, by which a time stamp without unit is judged. file: for messages.
Result<CsvLayout> makeCsvLayout(std::string_view headerLine, std::size_t columnCount,
                                std::string_view following, char separator, const CsvOptions &options,
                                const std::string &file);

} // namespace driftbench
