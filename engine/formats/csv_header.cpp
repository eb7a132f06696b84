#include "engine/formats/csv_header.h"

#include "engine/base/text.h"
#include "engine/formats/csv_spelling.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace driftbench {

namespace {

constexpr std::array<std::string_view, kCsvQuantityCount> kQuantityNames{
    "the time", "the temperature", "the rate about x", "the rate about y", "the rate about z"};
constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

CsvQuantity quantityAt(std::size_t index)
{
    return static_cast<CsvQuantity>(index);
}

std::string listed(const std::vector<std::string_view> &names)
{
    constexpr std::size_t kMostListed = 30;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i)
        text += (i == 0 ? "" : ", ") + std::string(unquoted(names[i]).substr(0, 60));
    return names.size() > kMostListed ? text + ", ..." : text;
}

// A column given by option: by its name in any case, or by its number from 1.
std::size_t givenColumn(const std::string &wanted, const std::vector<std::string_view> &names,
                        std::size_t columnCount)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (lowered(unquoted(names[i])) == lowered(trimmed(wanted)))
            return i;
    }
    const auto number = parseNumber(wanted);
    if (!number || std::floor(*number) != *number || *number < 1 ||
        *number > static_cast<double>(columnCount))
        return kNowhere;
    return static_cast<std::size_t>(*number) - 1;
}

class ColumnFinder
{
public:
    ColumnFinder(const std::vector<std::string_view> &names, const std::string &file)
        : m_names(names), m_file(file)
    {
        for (const std::string_view name : names)
            m_spellings.push_back(readSpelling(unquoted(name)));
    }

    void use(std::size_t column) { m_used.push_back(column); }

    // The unused column whose name fits best; says so where another fits as well.
    std::size_t best(CsvQuantity quantity, std::vector<std::string> &warnings)
    {
        std::size_t found = kNowhere;
        std::size_t rival = kNowhere;
        int bestFit = 0;
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            const int fit = isUsed(i) ? 0 : m_spellings[i].fit(quantity);
            if (fit > bestFit) {
                found = i;
                rival = kNowhere;
                bestFit = fit;
            } else if (fit > 0 && fit == bestFit && rival == kNowhere) {
                rival = i;
            }
        }
        if (rival != kNowhere) {
            warnings.push_back(m_file + " has several columns that could be " +
                               std::string(kQuantityNames[static_cast<std::size_t>(quantity)]) + "; " +
                               std::string(unquoted(m_names[found])) + " was taken, not " +
                               std::string(unquoted(m_names[rival])) + ".");
        }
        return found;
    }

private:
    bool isUsed(std::size_t column) const
    {
        return std::find(m_used.begin(), m_used.end(), column) != m_used.end();
    }

    const std::vector<std::string_view> &m_names;
    const std::string &m_file;
    std::vector<ColumnSpelling> m_spellings;
    std::vector<std::size_t> m_used;
};

Error missingColumn(CsvQuantity quantity, const std::string &wanted,
                    const std::vector<std::string_view> &names, std::size_t columnCount,
                    const std::string &file)
{
    const std::string what(kQuantityNames[static_cast<std::size_t>(quantity)]);
    if (names.empty() && wanted.empty())
        return {Errc::MissingColumn, file + " has no header line that names its " +
                                         std::to_string(columnCount) + " columns: give the column of " +
                                         what + " by its number."};
    const std::string there = names.empty() ? std::to_string(columnCount) + " columns without names"
                                            : "the columns " + listed(names);
    if (!wanted.empty())
        return {Errc::MissingColumn, file + " has no column \"" + wanted + "\" for " + what + "; it has " +
                                         there + ": name one of them."};
    return {Errc::MissingColumn, file + " has no column that is spelled like " + what + "; it has " + there +
                                     ": name the right one."};
}

// Two time stamps of the rows that follow, if they are whole numbers.
std::optional<double> wholeStep(std::string_view following, std::size_t field, char separator)
{
    std::vector<double> stamps;
    while (stamps.size() < 2 && !following.empty()) {
        const auto lineEnd = std::min(following.find('\n'), following.size());
        const std::string_view line = following.substr(0, lineEnd);
        following.remove_prefix(std::min(lineEnd + 1, following.size()));
        const auto fields = splitFields(line, separator);
        if (trimmed(line).empty() || isComment(line) || fields.size() <= field)
            continue;
        const auto stamp = parseNumber(unquoted(fields[field]));
        if (!stamp || std::floor(*stamp) != *stamp || fields[field].find('.') != std::string_view::npos)
            return std::nullopt;
        stamps.push_back(*stamp);
    }
    return stamps.size() == 2 ? std::optional(stamps[1] - stamps[0]) : std::nullopt;
}

TimeUnit timeUnitFor(CsvLayout &layout, const ColumnSpelling &spelling, const CsvOptions &options,
                     std::string_view following, const std::string &file)
{
    constexpr double kStepOfCounter = 1000.0; // no log steps by 1000 s
    const auto stated = options.timeUnit ? options.timeUnit : spelling.timeUnit;
    layout.timeUnitStated = stated.has_value();
    if (stated)
        return *stated;
    const auto step = wholeStep(following, layout.fields[0], layout.separator);
    if (!spelling.stamp || !step || *step < kStepOfCounter)
        return TimeUnit::Seconds;
    layout.warnings.push_back(
        file + " does not state the unit of " + layout.names[0] +
        "; its whole numbers were taken as microseconds: state the unit of time if they "
        "are not.");
    return TimeUnit::Microseconds;
}

Result<UnitScale> rateScaleFor(const std::string &name, const ColumnSpelling &spelling,
                               const CsvOptions &options, const std::string &file)
{
    const RateUnit unit = options.rateUnit.value_or(spelling.rateUnit.value_or(RateUnit::DegreesPerSecond));
    if (unit == RateUnit::Counts && !(options.sensitivityMdpsPerCount.value_or(0.0) > 0.0)) {
        return Error{Errc::InvalidOption, file + " holds counts in the column " + name +
                                              ": state the sensitivity in mdps per count, or the unit."};
    }
    return toDps(unit, options.sensitivityMdpsPerCount.value_or(0.0));
}

Status setUnits(CsvLayout &layout, std::string_view following, const CsvOptions &options,
                const std::string &file)
{
    const ColumnSpelling time = readSpelling(layout.names[0]);
    const ColumnSpelling temperature = readSpelling(layout.names[1]);
    layout.scales[0] = toSeconds(timeUnitFor(layout, time, options, following, file));
    layout.scales[1] = toCelsius(
        options.temperatureUnit.value_or(temperature.temperatureUnit.value_or(TemperatureUnit::Celsius)));
    layout.rateUnitStated = true;
    for (std::size_t i = 2; i < kCsvQuantityCount; ++i) {
        const ColumnSpelling rate = readSpelling(layout.names[i]);
        layout.rateUnitStated = layout.rateUnitStated && (options.rateUnit || rate.rateUnit);
        auto scale = rateScaleFor(layout.names[i], rate, options, file);
        if (!scale)
            return scale.error();
        layout.scales[i] = *scale;
    }
    return {};
}

Status findColumns(CsvLayout &layout, const std::vector<std::string_view> &names, std::size_t columnCount,
                   const CsvOptions &options, const std::string &file)
{
    ColumnFinder finder(names, file);
    layout.fields.fill(kNowhere);
    for (std::size_t i = 0; i < kCsvQuantityCount; ++i) {
        if (options.columns[i].empty())
            continue;
        layout.fields[i] = givenColumn(options.columns[i], names, columnCount);
        finder.use(layout.fields[i]);
        if (layout.fields[i] == kNowhere)
            return missingColumn(quantityAt(i), options.columns[i], names, columnCount, file);
    }
    for (std::size_t i = 0; i < kCsvQuantityCount; ++i) {
        if (layout.fields[i] == kNowhere) {
            layout.fields[i] = finder.best(quantityAt(i), layout.warnings);
            finder.use(layout.fields[i]);
        }
        if (layout.fields[i] == kNowhere)
            return missingColumn(quantityAt(i), "", names, columnCount, file);
        layout.names[i] = names.empty() ? "column " + std::to_string(layout.fields[i] + 1)
                                        : std::string(unquoted(names[layout.fields[i]]));
    }
    return {};
}

} // namespace

std::vector<std::string_view> splitFields(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == separator && !quoted) {
            fields.push_back(line.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    fields.push_back(line.substr(begin));
    return fields;
}

std::string_view unquoted(std::string_view field)
{
    field = trimmed(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
        field = trimmed(field.substr(1, field.size() - 2));
    return field;
}

bool isComment(std::string_view line)
{
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

char guessSeparator(std::string_view line)
{
    char best = ',';
    std::size_t most = 0;
    for (const char separator : {'\t', ';', ','}) {
        const std::size_t fields = splitFields(line, separator).size();
        if (fields > most) {
            most = fields;
            best = separator;
        }
    }
    return best;
}

bool isNumeric(std::string_view line, char separator)
{
    const auto fields = splitFields(line, separator);
    return std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
        return unquoted(field).empty() || parseNumber(unquoted(field)).has_value();
    });
}

Result<CsvLayout> makeCsvLayout(std::string_view headerLine, std::size_t columnCount,
                                std::string_view following, char separator, const CsvOptions &options,
                                const std::string &file)
{
    CsvLayout layout;
    layout.separator = separator;
    layout.headerLine = headerLine;
    std::vector<std::string_view> names;
    if (!headerLine.empty())
        names = splitFields(headerLine, separator);
    if (Status found = findColumns(layout, names, columnCount, options, file); !found)
        return found.error();
    if (Status set = setUnits(layout, following, options, file); !set)
        return set.error();
    return layout;
}

} // namespace driftbench
