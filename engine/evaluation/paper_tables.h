// Tables 1 to 6 of the paper as they are printed, and whether their arithmetic holds.
//
// A printed figure whose last digit is worth u stands for any value within u/2 of it. The columns after the
// MSDs follow from them:
//   Q = MSD after / MSD before                                                          (Eqs. 32, 34)
//   |Qb - Qa| / Qa = |1 - MSDb / MSDa|, in %; the MSD before cancels
// A cell agrees exactly if the printed MSDs give it as it stands; within rounding if some values that are
// printed as these MSDs give one that is printed as this cell; else not.
//
// Units: MSD in dps^2, Q none, improvements in %.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

struct RoundingRange
{
    double lowest = 0.0;
    double highest = 0.0;
};

// A figure with the digits that are printed: "9.5552", "3.5555e-2".
class PrintedFigure
{
public:
    explicit PrintedFigure(std::string_view text);

    std::string_view text() const { return m_text; }
    double value() const { return m_value; }
    double lastDigitWorth() const { return m_lastDigitWorth; }
    RoundingRange range() const; // of what is printed so

    // Another value with as many decimals, and a power of ten if this has one.
    std::string inThisForm(double value) const;

private:
    std::string_view m_text;
    int m_decimals = 0; // of the mantissa
    bool m_hasExponent = false;
    double m_value = 0.0;
    double m_lastDigitWorth = 0.0;
};

// Whose MSD.
enum class PaperRole
{
    Before,
    Conventional1, // least squares on dT
    Conventional2, // BP network on dT, dT^2
    Novel          // RBF network on dT, dT^2, dT^1/2
};
inline constexpr std::size_t kPaperRoleCount = 4;
using MsdByRole = std::array<double, kPaperRoleCount>; // dps^2; NaN for a role that a table leaves out

enum class PaperColumnKind
{
    Msd,
    Ratio,      // Q
    Improvement // of one model on another
};

struct PaperColumn
{
    std::string_view name; // "MSD1", "Q3", "|Q4-Q3|/Q3"
    PaperColumnKind kind = PaperColumnKind::Msd;
    PaperRole role = PaperRole::Before;
    PaperRole against = PaperRole::Before; // Improvement only

    std::string_view unit() const; // "dps^2", "", "%"
    // What the MSDs make of this column; an improvement keeps its sign: positive where role is the better.
    double of(const MsdByRole &msds) const;
};

struct PrintedRow
{
    int run = 0; // of the experiment, from 0
    int axis = 0;
    std::span<const std::string_view> figures; // by column

    PrintedFigure figure(std::size_t column) const { return PrintedFigure(figures[column]); }
};

struct PaperTable
{
    int number = 0;
    std::span<const PaperColumn> columns;
    std::vector<PrintedRow> rows;

    MsdByRole msds(const PrintedRow &row) const; // as printed
};

inline constexpr int kPaperTableCount = 6;
// number: 1 to 6.
PaperTable paperTable(int number);

enum class PrintedAgreement
{
    Exact,
    WithinRounding,
    No
};
std::string_view agreementName(PrintedAgreement agreement); // "exact", "within rounding", "no"

struct PaperCheck
{
    int table = 0;
    PrintedRow row;
    PaperColumn column;
    PrintedFigure printed;
    double recomputed = 0.0; // from the printed MSDs as they stand
    RoundingRange possible;  // what the rounding of the MSDs allows
    PrintedAgreement agreement = PrintedAgreement::No;
};

// Every Q and improvement of the table, row by row.
std::vector<PaperCheck> checkPaperTable(const PaperTable &table);

// The improvements of a row say the same thing twice: (1 - p5) = (1 - p4)(1 - p54) for those of two models on
// a third and on each other. Whether they agree among themselves, within their own rounding; false where a
// row has fewer than three, with nothing to agree.
bool improvementsAgreeAmongThemselves(const PaperTable &table, const PrintedRow &row);

} // namespace driftbench
