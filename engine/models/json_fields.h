// Reading the fields of a JSON object one by one: the first that is missing or of the wrong shape is
// remembered by its path, later ones give empty values, so that a reader can be written without asking after
// each field. Also how matrices are written. Used inside this folder only.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace driftbench {

using Json = nlohmann::ordered_json; // keeps the order of its keys

Json toJson(const Eigen::VectorXd &values);
Json toJson(const Eigen::MatrixXd &matrix); // a list of rows; NaN becomes null

class FieldReader
{
public:
    static constexpr Eigen::Index kAnySize = -1;
    // More rows than any model can have use for: a file that has them is not one of ours.
    static constexpr Eigen::Index kMostRows = 100000;

    enum class Gaps
    {
        Forbidden,
        AsNaN // null reads as NaN
    };

    // problem: receives a clause such as "parameters.widths is missing"; empty while all is well.
    FieldReader(const Json &object, std::string path, std::string &problem);

    FieldReader child(const std::string &key) const;
    bool isNull(const std::string &key) const; // also when missing: that is left to child() to report

    double number(const std::string &key) const;       // finite
    double positive(const std::string &key) const;     // finite, > 0
    int count(const std::string &key, int most) const; // 0 .. most
    std::uint64_t unsignedWhole(const std::string &key) const;
    bool flag(const std::string &key) const;
    std::string text(const std::string &key) const;
    void expectText(const std::string &key, const std::string &wanted) const;
    std::vector<std::string> texts(const std::string &key) const;
    std::map<std::string, double> namedNumbers(const std::string &key) const; // null reads as NaN
    Eigen::VectorXd vector(const std::string &key, Eigen::Index size = kAnySize) const;
    Eigen::MatrixXd matrix(const std::string &key, Eigen::Index rows, Eigen::Index columns,
                           Gaps gaps = Gaps::Forbidden) const;
    // Calls read(i, reader) for each of `size` objects in a list.
    void objects(const std::string &key, std::size_t size,
                 const std::function<void(std::size_t, const FieldReader &)> &read) const;

    void fail(const std::string &key, const std::string &clause) const;
    bool failed() const { return !m_problem.empty(); }

private:
    const Json &at(const std::string &key) const;
    std::string pathOf(const std::string &key) const;
    double element(const Json &value, const std::string &key, Gaps gaps) const;

    const Json &m_object;
    std::string m_path;
    std::string &m_problem;
};

} // namespace driftbench
