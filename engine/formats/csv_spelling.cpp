#include "engine/formats/csv_spelling.h"

#include "engine/base/text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace driftbench {

namespace {

using Words = std::span<const std::string_view>;

constexpr auto kTime = std::to_array<std::string_view>({"time", "timestamp", "t", "elapsed", "stamp"});
constexpr auto kTemperature = std::to_array<std::string_view>({"temperature", "temp", "tmp"});
constexpr auto kGyro = std::to_array<std::string_view>(
    {"gyroscope", "gyro", "gyr", "g", "rate", "rates", "w", "omega", "angular", "ang", "velocity", "vel"});
constexpr auto kAxis = std::to_array<std::string_view>({"x", "y", "z"});
constexpr auto kNeutral =
    std::to_array<std::string_view>({"imu", "sensor", "die", "mems", "out", "output", "data", "log"});
constexpr auto kOther = std::to_array<std::string_view>(
    {"a",    "acc",         "accel", "acceleration", "accelerometer", "m",      "mag",   "magnetometer",
     "comp", "compensated", "ref",   "reference",    "bias",          "offset", "error", "err",
     "std",  "tde",         "baro",  "pressure",     "humidity"});
constexpr auto kUnit = std::to_array<std::string_view>(
    {"s",      "sec",          "secs",        "second", "seconds", "ms",           "msec",
     "millis", "milliseconds", "us",          "usec",   "micros",  "microseconds", "ns",
     "nsec",   "nanos",        "nanoseconds", "dps",    "degps",   "degs",         "deg",
     "rad",    "rads",         "radps",       "mdps",   "mdeg",    "mdegs",        "mdegps",
     "lsb",    "counts",       "count",       "raw",    "c",       "degc",         "celsius",
     "k",      "degk",         "kelvin",      "f",      "degf",    "fahrenheit"});

bool contains(Words words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool isKnown(std::string_view word)
{
    return contains(kTime, word) || contains(kTemperature, word) || contains(kGyro, word) ||
           contains(kAxis, word) || contains(kNeutral, word) || contains(kOther, word) ||
           contains(kUnit, word);
}

// Cuts letters into known words, the longest first; false if that can't be done.
bool cut(std::string_view letters, std::vector<std::string> &words)
{
    constexpr std::size_t kLongestWord = 16;
    if (letters.empty())
        return true;
    for (std::size_t length = std::min(letters.size(), kLongestWord); length > 0; --length) {
        if (!isKnown(letters.substr(0, length)))
            continue;
        words.emplace_back(letters.substr(0, length));
        if (cut(letters.substr(length), words))
            return true;
        words.pop_back();
    }
    return false;
}

// Lower case, with the degree and micro signs as letters.
std::string plainName(std::string_view name)
{
    const std::string low = lowered(name);
    std::string plain;
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::string_view two = std::string_view(low).substr(i, 2);
        const bool degree = two == "\u00b0";
        const bool micro = two == "\u00b5" || two == "\u03bc";
        if (degree || micro) {
            plain += degree ? " deg" : " u";
            ++i;
        } else {
            plain += low[i];
        }
    }
    return plain;
}

bool isLetter(char c)
{
    return c >= 'a' && c <= 'z';
}

std::vector<std::string> wordsOf(std::string_view plain, int &unknownWords)
{
    constexpr std::size_t kLongestName = 64;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < plain.size();) {
        std::size_t end = i;
        while (end < plain.size() && isLetter(plain[end]))
            ++end;
        if (end > i && (end - i > kLongestName || !cut(plain.substr(i, end - i), words)))
            ++unknownWords;
        i = std::max(end, i + 1);
    }
    return words;
}

// "gyro_rad[0]": an index in brackets is an axis.
int indexedAxis(std::string_view plain)
{
    const auto open = plain.find('[');
    if (open == std::string_view::npos || open + 2 >= plain.size() || plain[open + 2] != ']')
        return -1;
    const int index = plain[open + 1] - '0';
    return index >= 0 && index <= 2 ? index : -1;
}

std::optional<RateUnit> rateUnitOf(const std::vector<std::string> &words)
{
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (const auto unit = rateUnitNamed(words[i] + words[i + 1]); unit && words[i + 1][0] == 's')
            return unit;
    }
    std::optional<RateUnit> found;
    for (const std::string &word : words) {
        // "raw_gyro_x_dps" is in dps; "raw" is a unit only where nothing else is.
        if (const auto unit = rateUnitNamed(word); unit && (!found || word != "raw"))
            found = unit;
    }
    return found;
}

std::optional<TemperatureUnit> temperatureUnitOf(const std::vector<std::string> &words)
{
    for (const std::string &word : words) {
        if (const auto unit = temperatureUnitNamed(word))
            return unit;
    }
    return std::nullopt;
}

std::optional<TimeUnit> timeUnitOf(const std::vector<std::string> &words)
{
    for (const std::string &word : words) {
        if (const auto unit = timeUnitNamed(word))
            return unit;
    }
    return std::nullopt;
}

} // namespace

ColumnSpelling readSpelling(std::string_view name)
{
    name = trimmed(name);
    const std::string plain = plainName(name);
    ColumnSpelling spelling;
    spelling.onlyOneLetter = name.size() == 1;
    spelling.upperCase = !name.empty() && name[0] >= 'A' && name[0] <= 'Z';
    spelling.axis = indexedAxis(plain);
    const std::vector<std::string> words = wordsOf(plain, spelling.unknownWords);
    for (const std::string &word : words) {
        spelling.time |= contains(kTime, word);
        spelling.stamp |= word == "timestamp" || word == "stamp";
        spelling.temperature |= contains(kTemperature, word);
        spelling.gyro |= contains(kGyro, word);
        spelling.otherQuantity |= contains(kOther, word);
        if (contains(kAxis, word))
            spelling.axis = word[0] - 'x';
    }
    spelling.timeUnit = timeUnitOf(words);
    spelling.rateUnit = rateUnitOf(words);
    spelling.temperatureUnit = temperatureUnitOf(words);
    return spelling;
}

int ColumnSpelling::fit(CsvQuantity quantity) const
{
    constexpr int kPerfect = 10;
    constexpr int kByUnit = 6;
    constexpr int kByLetter = 4;
    if (otherQuantity)
        return 0;
    const auto lessUnknown = [this](int score) { return std::max(1, score - unknownWords); };
    switch (quantity) {
    case CsvQuantity::Time:
        if (axis >= 0 || temperature || gyro)
            return 0;
        if (time)
            return onlyOneLetter ? (upperCase ? kByLetter - 1 : kByLetter) : lessUnknown(kPerfect);
        return timeUnit && unknownWords == 0 && !onlyOneLetter ? kByUnit - 1 : 0;
    case CsvQuantity::Temperature:
        if (temperature && axis < 0)
            return lessUnknown(kPerfect);
        return time && onlyOneLetter && upperCase ? kByLetter : 0;
    case CsvQuantity::RateX:
    case CsvQuantity::RateY:
    case CsvQuantity::RateZ:
        if (axis != static_cast<int>(quantity) - static_cast<int>(CsvQuantity::RateX) || temperature || time)
            return 0;
        if (gyro)
            return lessUnknown(kPerfect);
        if (rateUnit)
            return lessUnknown(kByUnit);
        return onlyOneLetter ? kByLetter : 0;
    }
    return 0;
}

} // namespace driftbench
