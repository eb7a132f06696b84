#include "engine/exports/c_header_export.h"

#include "engine/base/text.h"
#include "engine/compensation/fixed_point_table.h"
#include "engine/exports/export_text.h"

#include <algorithm>

namespace driftbench {

namespace {

constexpr std::size_t kLongestSymbol = 48;

constexpr std::string_view kLicence = R"( * SPDX-License-Identifier: MIT
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy of this software and
 * associated documentation files (the "Software"), to deal in the Software without restriction, including
 * without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to the
 * following conditions:
 *
 * The above copyright notice and this permission notice shall be included in all copies or substantial
 * portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT
 * LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO
 * EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER
 * IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR
 * THE USE OR OTHER DEALINGS IN THE SOFTWARE.
)";

// @ stands for the prefix, $ for the prefix in capitals.
constexpr std::string_view kFloatFunctions = R"(
/* Temperature drift error of the three axes in dps. Outside the table the end value is held; a temperature
 * that is not finite gives NaN. */
static inline void @_tde_dps(float temperature_c, float tde[3])
{
    const float last_position = (float)($_KNOTS - 1);
    const float last_cell = last_position - 1.0f;
    const float position = (temperature_c - $_FIRST_C) * $_CELLS_PER_C;
    const float above = position > 0.0f ? position : 0.0f;
    const float held = above < last_position ? above : last_position;
    const int32_t cell = (int32_t)(held < last_cell ? held : last_cell);
    /* position - position is 0, or NaN where the temperature is not finite. */
    const float fraction = (held - (float)cell) + (position - position);
    int axis;
    for (axis = 0; axis < 3; ++axis) {
        const float low = @_knots_dps[cell][axis];
        const float slope = @_knots_dps[cell + 1][axis] - low;
        tde[axis] = low + fraction * slope;
    }
}

/* Rates free of the drift, in dps; the two arrays may be the same. */
static inline void @_compensate(float temperature_c, const float rate_dps[3], float compensated_dps[3])
{
    float tde[3];
    int axis;
    @_tde_dps(temperature_c, tde);
    for (axis = 0; axis < 3; ++axis)
        compensated_dps[axis] = rate_dps[axis] - tde[axis];
}
)";

constexpr std::string_view kFixedFunction = R"(
/* The same in integers: temperature in millidegrees Celsius, drift error in units of 2^-$_FRACTION_BITS dps. */
static inline void @_tde_q(int32_t temperature_milli_c, int32_t tde[3])
{
    const int32_t above = temperature_milli_c > $_FIRST_MILLI_C ? temperature_milli_c : $_FIRST_MILLI_C;
    const int32_t held = above < $_LAST_MILLI_C ? above : $_LAST_MILLI_C;
    const uint64_t position = ((uint64_t)(held - $_FIRST_MILLI_C) * $_RECIPROCAL) >> $_SHIFT;
    const uint64_t floored = position >> 16;
    const uint64_t cell = floored < $_KNOTS - 2 ? floored : $_KNOTS - 2;
    const int64_t fraction = (int64_t)(position - (cell << 16));
    int axis;
    for (axis = 0; axis < 3; ++axis) {
        const int32_t low = @_knots_q[cell][axis];
        const int64_t slope = (int64_t)@_knots_q[cell + 1][axis] - low;
        /* Rounded to the nearest; 2^49 is added so that no negative number is shifted. */
        const uint64_t raised = (uint64_t)(slope * fraction + 32768 + INT64_C(562949953421312));
        tde[axis] = (int32_t)(low + ((int64_t)(raised >> 16) - INT64_C(8589934592)));
    }
}
)";

bool isIdentifier(const std::string &symbol)
{
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !symbol.empty() && symbol.size() <= kLongestSymbol && letter(symbol[0]) &&
           std::all_of(symbol.begin(), symbol.end(), allowed);
}

std::string inCapitals(std::string text)
{
    for (char &c : text) {
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    }
    return text;
}

std::string named(std::string_view pattern, const std::string &symbol)
{
    const std::string capitals = inCapitals(symbol);
    std::string text;
    for (const char c : pattern) {
        if (c == '@')
            text += symbol;
        else if (c == '$')
            text += capitals;
        else
            text += c;
    }
    return text;
}

std::string floatLiteral(double value)
{
    std::string text = shortestFloat(static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text + "f";
}

std::string openingComment(const CompensationTable &table, const FixedPointTable &fixed)
{
    std::vector<std::string> lines{
        "Temperature drift compensation of one gyro: compensated rate = rate - tde(T)."};
    for (std::string &line : provenanceLines(table.provenance, table.compensated))
        lines.push_back(std::move(line));
    lines.push_back("interpolation error against the model: below " +
                    shortest(table.interpolationErrorBoundDps) + " dps");
    lines.push_back("fixed point against the table: below " + shortest(fixed.errorBoundDps) +
                    " dps at whole millidegrees; rounding to them adds up to " +
                    shortest(fixed.temperatureRoundingDps) + " dps");
    return "/*\n" + commented(lines, " * ") + " *\n * Copyright (c) the Driftbench authors\n" +
           std::string(kLicence) + " */\n";
}

std::string constants(const CompensationTable &table, const FixedPointTable &fixed, const std::string &symbol)
{
    const auto define = [&](std::string_view name, const std::string &value) {
        return named("#define $_", symbol) + std::string(name) + " " + value + "\n";
    };
    return define("KNOTS", std::to_string(table.size())) +
           define("FIRST_C", "(" + floatLiteral(table.firstTemperatureC()) + ")") +
           define("CELLS_PER_C", floatLiteral(1.0 / table.stepC())) +
           define("FIRST_MILLI_C", "(" + std::to_string(fixed.firstMilliC) + ")") +
           define("LAST_MILLI_C", "(" + std::to_string(fixed.lastMilliC) + ")") +
           define("RECIPROCAL", std::to_string(fixed.reciprocal) + "u") +
           define("SHIFT", std::to_string(fixed.shift)) +
           define("FRACTION_BITS", "(" + std::to_string(fixed.fractionBits) + ")");
}

std::string knots(const CompensationTable &table, const FixedPointTable &fixed, const std::string &symbol)
{
    std::string text = named("\nstatic const float @_knots_dps[$_KNOTS][3] = {\n", symbol);
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        text += "    {" + floatLiteral(table.tdeDps(i, 0)) + ", " + floatLiteral(table.tdeDps(i, 1)) + ", " +
                floatLiteral(table.tdeDps(i, 2)) + "},\n";
    }
    text += named("};\n\nstatic const int32_t @_knots_q[$_KNOTS][3] = {\n", symbol);
    for (const auto &value : fixed.values) {
        text += "    {" + std::to_string(value[0]) + ", " + std::to_string(value[1]) + ", " +
                std::to_string(value[2]) + "},\n";
    }
    return text + "};\n";
}

} // namespace

Result<std::string> tableToCHeader(const CompensationTable &table, const std::string &symbol)
{
    if (!isIdentifier(symbol)) {
        return Error{Errc::InvalidOption, "\"" + symbol +
                                              "\" can't name a C function; choose a name of up to " +
                                              std::to_string(kLongestSymbol) +
                                              " letters, digits and underscores that begins with a letter."};
    }
    const FixedPointTable fixed = makeFixedPointTable(table);
    return openingComment(table, fixed) +
           named("#ifndef $_COMPENSATION_H\n#define $_COMPENSATION_H\n\n#include <stdint.h>\n\n", symbol) +
           constants(table, fixed, symbol) + knots(table, fixed, symbol) + named(kFloatFunctions, symbol) +
           named(kFixedFunction, symbol) + named("\n#endif /* $_COMPENSATION_H */\n", symbol);
}

} // namespace driftbench
