#include "engine/exports/table_csv.h"

#include "engine/base/axes.h"
#include "engine/base/text.h"
#include "engine/compensation/axis_selection.h"
#include "engine/exports/export_text.h"

#include <cmath>
#include <vector>

namespace driftbench {

namespace {

constexpr std::string_view kTitle = "# driftbench compensation table, version 1";
constexpr std::string_view kColumns = "temperature_C,tde_x_dps,tde_y_dps,tde_z_dps";
// Temperatures of the rows are derived from the ends; a row may be off by rounding only.
constexpr double kTemperatureToleranceC = 1e-6;

std::string entry(std::string_view key, const std::string &value)
{
    return "# " + std::string(key) + ": " + forComment(value) + "\n";
}

std::string axisKey(std::string_view key, std::size_t axis)
{
    return std::string(key) + "_" + std::string(kAxisNames[axis]);
}

std::string header(const CompensationTable &table)
{
    const TableProvenance &from = table.provenance;
    std::string text = std::string(kTitle) + "\n";
    if (from.simulated)
        text += "# SIMULATED, trained on simulated data: not for use in a device\n";
    text += entry("model", from.modelName) + entry("sensor_model", from.sensor.model) +
            entry("sensor_serial", from.sensor.serial) +
            entry("reference_temperature_C", shortest(from.referenceTemperatureC)) +
            entry("trained_lowest_C", shortest(from.lowestTemperatureC)) +
            entry("trained_highest_C", shortest(from.highestTemperatureC)) +
            entry("simulated", from.simulated ? "yes" : "no") + entry("judging", from.judging);
    for (const std::string &run : from.trainedOn)
        text += entry("trained_on", run);
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        text += entry(axisKey("compensated", axis), table.compensated[axis] ? "yes" : "no") +
                entry(axisKey("verdict", axis), verdictText(from.verdicts[axis])) +
                entry(axisKey("reason", axis), from.reasons[axis]);
    }
    text += entry("first_millidegree", std::to_string(table.firstMilliC)) +
            entry("last_millidegree", std::to_string(table.lastMilliC)) +
            entry("measured_interpolation_error_dps", shortest(table.measuredErrorDps)) +
            entry("interpolation_error_bound_dps", shortest(table.interpolationErrorBoundDps)) +
            "# Compensated rate = rate - tde; linear between rows, outside the end value is held.\n";
    return text;
}

class CsvReader
{
public:
    CsvReader(std::string_view text, const std::string &name) : m_rest(text), m_name(name) {}
    Result<CompensationTable> read();

private:
    bool nextLine();
    Status comment();
    Status axisEntry(std::string_view key, std::string_view value);
    Status row();
    Status number(std::string_view value, double &into) const;
    Status flag(std::string_view value, bool &into) const;
    Error damaged(const std::string &what) const
    {
        return {Errc::ModelDamaged,
                m_name + ", line " + std::to_string(m_line) + ": " + what + "; export the table again."};
    }

    std::string_view m_rest;
    std::string m_name;
    std::string_view m_text;
    int m_line = 0;
    CompensationTable m_table;
    double m_first = 0.0;
    double m_last = 0.0;
    std::vector<std::array<double, 4>> m_rows;
};

bool CsvReader::nextLine()
{
    if (m_rest.empty())
        return false;
    const std::size_t end = m_rest.find('\n');
    m_text = trimmed(m_rest.substr(0, end));
    m_rest = end == std::string_view::npos ? std::string_view() : m_rest.substr(end + 1);
    ++m_line;
    return true;
}

Status CsvReader::number(std::string_view value, double &into) const
{
    const auto parsed = parseNumber(value);
    if (!parsed || !std::isfinite(*parsed))
        return damaged("\"" + std::string(value) + "\" is no number");
    into = *parsed;
    return {};
}

Status CsvReader::flag(std::string_view value, bool &into) const
{
    if (value != "yes" && value != "no")
        return damaged("\"" + std::string(value) + "\" is neither yes nor no");
    into = value == "yes";
    return {};
}

Status CsvReader::axisEntry(std::string_view key, std::string_view value)
{
    TableProvenance &from = m_table.provenance;
    for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        if (key == axisKey("compensated", axis))
            return flag(value, m_table.compensated[axis]);
        if (key == axisKey("verdict", axis))
            from.verdicts[axis] = verdictFromName(value);
        if (key == axisKey("reason", axis))
            from.reasons[axis] = value;
    }
    return {};
}

Status CsvReader::comment()
{
    const std::size_t colon = m_text.find(':');
    if (colon == std::string_view::npos)
        return {};
    const std::string_view key = trimmed(m_text.substr(1, colon - 1));
    const std::string_view value = trimmed(m_text.substr(colon + 1));
    TableProvenance &from = m_table.provenance;
    if (key == "model")
        from.modelName = value;
    else if (key == "sensor_model")
        from.sensor.model = value;
    else if (key == "sensor_serial")
        from.sensor.serial = value;
    else if (key == "judging")
        from.judging = value;
    else if (key == "trained_on")
        from.trainedOn.emplace_back(value);
    else if (key == "simulated")
        return flag(value, from.simulated);
    else if (key == "reference_temperature_C")
        return number(value, from.referenceTemperatureC);
    else if (key == "trained_lowest_C")
        return number(value, from.lowestTemperatureC);
    else if (key == "trained_highest_C")
        return number(value, from.highestTemperatureC);
    else if (key == "first_millidegree")
        return number(value, m_first);
    else if (key == "last_millidegree")
        return number(value, m_last);
    else if (key == "measured_interpolation_error_dps")
        return number(value, m_table.measuredErrorDps);
    else if (key == "interpolation_error_bound_dps")
        return number(value, m_table.interpolationErrorBoundDps);
    return axisEntry(key, value);
}

Status CsvReader::row()
{
    std::array<double, 4> values{};
    std::string_view rest = m_text;
    for (std::size_t column = 0; column < values.size(); ++column) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (column + 1 == values.size()))
            return damaged("a row has four numbers");
        if (const Status status = number(rest.substr(0, comma), values[column]); !status)
            return status;
        if (comma != std::string_view::npos)
            rest.remove_prefix(comma + 1);
    }
    m_rows.push_back(values);
    return {};
}

Result<CompensationTable> CsvReader::read()
{
    if (!nextLine() || m_text != kTitle)
        return damaged("this is no compensation table of Driftbench");
    while (nextLine()) {
        Status status;
        if (m_text.starts_with('#'))
            status = comment();
        else if (!m_text.empty() && m_text != kColumns)
            status = row();
        if (!status)
            return status.error();
    }
    if (!(std::abs(m_first) < 1e9) || !(std::abs(m_last) < 1e9))
        return damaged("the ends of the table are no temperatures");
    m_table.firstMilliC = static_cast<std::int32_t>(m_first);
    m_table.lastMilliC = static_cast<std::int32_t>(m_last);
    m_table.tdeDps.resize(static_cast<Eigen::Index>(m_rows.size()), 3);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_table.tdeDps.row(static_cast<Eigen::Index>(i)) << m_rows[i][1], m_rows[i][2], m_rows[i][3];
    if (const Status status = checkReadTable(m_table, m_name); !status)
        return status.error();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (!(std::abs(m_rows[i][0] - m_table.temperatureC(static_cast<Eigen::Index>(i))) <
              kTemperatureToleranceC))
            return damaged("rows are missing or their temperatures are not equally spaced");
    }
    return m_table;
}

} // namespace

std::string tableToCsv(const CompensationTable &table)
{
    std::string text = header(table) + std::string(kColumns) + "\n";
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        text += shortest(table.temperatureC(i));
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            text += "," + shortest(table.tdeDps(i, axis));
        text += "\n";
    }
    return text;
}

Result<CompensationTable> tableFromCsv(std::string_view text, const std::string &name)
{
    return CsvReader(text, name).read();
}

Status checkReadTable(const CompensationTable &table, const std::string &name)
{
    if (table.size() >= 2 && table.size() <= TableOptions::kKnotLimit &&
        table.firstMilliC < table.lastMilliC &&
        std::int64_t{table.lastMilliC} - table.firstMilliC >= table.size() - 1 &&
        std::int64_t{table.lastMilliC} - table.firstMilliC <= TableOptions::kLargestSpanMilliC &&
        table.tdeDps.allFinite())
        return {};
    return Error{Errc::ModelDamaged, name + " holds no usable table (" + std::to_string(table.size()) +
                                         " rows from " + std::to_string(table.firstMilliC) + " to " +
                                         std::to_string(table.lastMilliC) +
                                         " millidegrees); export the table again."};
}

} // namespace driftbench
