#include "engine/models/json_fields.h"

#include <cmath>

namespace driftbench {

namespace {

const Json &nothing()
{
    static const Json null;
    return null;
}

} // namespace

Json toJson(const Eigen::VectorXd &values)
{
    Json list = Json::array();
    for (const double value : values)
        list.push_back(value);
    return list;
}

Json toJson(const Eigen::MatrixXd &matrix)
{
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        rows.push_back(toJson(Eigen::VectorXd(matrix.row(row).transpose())));
    return rows;
}

FieldReader::FieldReader(const Json &object, std::string path, std::string &problem)
    : m_object(object), m_path(std::move(path)), m_problem(problem)
{
}

std::string FieldReader::pathOf(const std::string &key) const
{
    return m_path.empty() ? key : m_path + "." + key;
}

void FieldReader::fail(const std::string &key, const std::string &clause) const
{
    if (m_problem.empty())
        m_problem = pathOf(key) + " " + clause;
}

const Json &FieldReader::at(const std::string &key) const
{
    if (m_object.is_object()) {
        const auto found = m_object.find(key);
        if (found != m_object.end())
            return *found;
    }
    fail(key, "is missing");
    return nothing();
}

FieldReader FieldReader::child(const std::string &key) const
{
    const Json &value = at(key);
    if (!value.is_object())
        fail(key, "is not an object");
    return {value, pathOf(key), m_problem};
}

bool FieldReader::isNull(const std::string &key) const
{
    const auto found = m_object.find(key);
    return found != m_object.end() && found->is_null();
}

double FieldReader::number(const std::string &key) const
{
    return element(at(key), key, Gaps::Forbidden);
}

double FieldReader::positive(const std::string &key) const
{
    const double value = number(key);
    if (!(value > 0.0))
        fail(key, "is not above 0");
    return value;
}

int FieldReader::count(const std::string &key, int most) const
{
    const Json &value = at(key);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > static_cast<std::uint64_t>(most)) {
        fail(key, "is not a whole number from 0 to " + std::to_string(most));
        return 0;
    }
    return static_cast<int>(value.get<std::uint64_t>());
}

std::uint64_t FieldReader::unsignedWhole(const std::string &key) const
{
    const Json &value = at(key);
    if (value.is_number_unsigned())
        return value.get<std::uint64_t>();
    fail(key, "is not a whole number");
    return 0;
}

bool FieldReader::flag(const std::string &key) const
{
    const Json &value = at(key);
    if (value.is_boolean())
        return value.get<bool>();
    fail(key, "is not true or false");
    return false;
}

std::string FieldReader::text(const std::string &key) const
{
    const Json &value = at(key);
    if (value.is_string())
        return value.get<std::string>();
    fail(key, "is not a text");
    return {};
}

void FieldReader::expectText(const std::string &key, const std::string &wanted) const
{
    if (text(key) != wanted)
        fail(key, "is not \"" + wanted + "\"");
}

std::vector<std::string> FieldReader::texts(const std::string &key) const
{
    std::vector<std::string> list;
    const Json &value = at(key);
    if (!value.is_array())
        fail(key, "is not a list");
    for (const Json &each : value) {
        if (each.is_string())
            list.push_back(each.get<std::string>());
        else
            fail(key, "holds something that is not a text");
    }
    return list;
}

std::map<std::string, double> FieldReader::namedNumbers(const std::string &key) const
{
    std::map<std::string, double> numbers;
    const Json &value = at(key);
    if (!value.is_object()) {
        fail(key, "is not an object");
        return numbers;
    }
    for (const auto &[name, each] : value.items())
        numbers[name] = element(each, key + "." + name, Gaps::AsNaN);
    return numbers;
}

double FieldReader::element(const Json &value, const std::string &key, Gaps gaps) const
{
    if (value.is_null() && gaps == Gaps::AsNaN)
        return std::numeric_limits<double>::quiet_NaN();
    if (value.is_number() && std::isfinite(value.get<double>()))
        return value.get<double>();
    fail(key, "is not a finite number");
    return 0.0;
}

Eigen::VectorXd FieldReader::vector(const std::string &key, Eigen::Index size) const
{
    const Json &list = at(key);
    const auto found = static_cast<Eigen::Index>(list.size());
    if (!list.is_array() || (size != kAnySize && found != size) || found > kMostRows) {
        fail(key, size == kAnySize ? "is not a list of at most " + std::to_string(kMostRows) + " numbers"
                                   : "is not a list of " + std::to_string(size) + " numbers");
        return Eigen::VectorXd::Zero(size == kAnySize ? 0 : size);
    }
    Eigen::VectorXd values(found);
    for (Eigen::Index i = 0; i < found; ++i)
        values[i] = element(list[static_cast<std::size_t>(i)], key, Gaps::Forbidden);
    return values;
}

Eigen::MatrixXd FieldReader::matrix(const std::string &key, Eigen::Index rows, Eigen::Index columns,
                                    Gaps gaps) const
{
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(rows, columns);
    const Json &list = at(key);
    const std::string shape = std::to_string(rows) + " rows of " + std::to_string(columns) + " numbers";
    if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != rows) {
        fail(key, "is not " + shape);
        return values;
    }
    for (Eigen::Index row = 0; row < rows; ++row) {
        const Json &line = list[static_cast<std::size_t>(row)];
        if (!line.is_array() || static_cast<Eigen::Index>(line.size()) != columns) {
            fail(key, "is not " + shape);
            return values;
        }
        for (Eigen::Index column = 0; column < columns; ++column)
            values(row, column) = element(line[static_cast<std::size_t>(column)], key, gaps);
    }
    return values;
}

void FieldReader::objects(const std::string &key, std::size_t size,
                          const std::function<void(std::size_t, const FieldReader &)> &read) const
{
    const Json &list = at(key);
    if (!list.is_array() || list.size() != size) {
        fail(key, "is not a list of " + std::to_string(size));
        return;
    }
    for (std::size_t i = 0; i < size; ++i)
        read(i, FieldReader(list[i], pathOf(key) + "[" + std::to_string(i) + "]", m_problem));
}

} // namespace driftbench
