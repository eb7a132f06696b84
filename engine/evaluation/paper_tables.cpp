#include "engine/evaluation/paper_tables.h"

#include "engine/base/text.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

constexpr double kPercent = 100.0;
// Of the last digit: decides for agreement where a value lies on the edge but for the arithmetic of doubles.
constexpr double kEdge = 1e-9;

std::size_t indexOf(PaperRole role)
{
    return static_cast<std::size_t>(role);
}

bool overlap(const RoundingRange &a, const RoundingRange &b, double slack)
{
    return a.lowest <= b.highest + slack && b.lowest <= a.highest + slack;
}

// |x| for x in the range.
RoundingRange absolute(const RoundingRange &range)
{
    if (range.lowest >= 0.0)
        return range;
    if (range.highest <= 0.0)
        return {-range.highest, -range.lowest};
    return {0.0, std::max(-range.lowest, range.highest)};
}

RoundingRange quotient(const RoundingRange &over, const RoundingRange &under)
{
    return {over.lowest / under.highest, over.highest / under.lowest};
}

std::size_t msdColumn(const PaperTable &table, PaperRole role)
{
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (table.columns[c].kind == PaperColumnKind::Msd && table.columns[c].role == role)
            return c;
    }
    assert(false && "a column of a role that the table leaves out");
    return 0;
}

// From the figures of two MSD columns.
RoundingRange possibleRange(const PaperTable &table, const PrintedRow &row, const PaperColumn &column)
{
    const PaperRole under = column.kind == PaperColumnKind::Ratio ? PaperRole::Before : column.against;
    const RoundingRange ratio = quotient(row.figure(msdColumn(table, column.role)).range(),
                                         row.figure(msdColumn(table, under)).range());
    if (column.kind == PaperColumnKind::Ratio)
        return ratio;
    return absolute({kPercent * (1.0 - ratio.highest), kPercent * (1.0 - ratio.lowest)});
}

PrintedAgreement agreementOf(const PrintedFigure &printed, double recomputed, const RoundingRange &possible)
{
    const double slack = kEdge * printed.lastDigitWorth();
    if (overlap({recomputed, recomputed}, printed.range(), slack))
        return PrintedAgreement::Exact;
    return overlap(possible, printed.range(), slack) ? PrintedAgreement::WithinRounding
                                                     : PrintedAgreement::No;
}

} // namespace

PrintedFigure::PrintedFigure(std::string_view text) : m_text(text)
{
    const std::size_t exponentAt = std::min(text.find('e'), text.size());
    const std::size_t pointAt = std::min(text.find('.'), exponentAt);
    m_hasExponent = exponentAt < text.size();
    m_decimals = pointAt < exponentAt ? static_cast<int>(exponentAt - pointAt) - 1 : 0;
    const auto value = parseNumber(text);
    const auto exponent = m_hasExponent ? parseNumber(text.substr(exponentAt + 1)) : 0.0;
    assert(value && exponent);
    m_value = *value;
    m_lastDigitWorth = std::pow(10.0, *exponent - m_decimals);
}

RoundingRange PrintedFigure::range() const
{
    return {m_value - 0.5 * m_lastDigitWorth, m_value + 0.5 * m_lastDigitWorth};
}

std::string PrintedFigure::inThisForm(double value) const
{
    if (!m_hasExponent || value == 0.0 || !std::isfinite(value))
        return fixed(value, m_decimals);
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    std::string mantissa = fixed(value / std::pow(10.0, exponent), m_decimals);
    // 9.99996 becomes 10.0000
    if (std::abs(*parseNumber(mantissa)) >= 10.0)
        mantissa = fixed(value / std::pow(10.0, ++exponent), m_decimals);
    return mantissa + "e" + std::to_string(exponent);
}

std::string_view PaperColumn::unit() const
{
    switch (kind) {
    case PaperColumnKind::Msd:
        return "dps^2";
    case PaperColumnKind::Ratio:
        return "";
    case PaperColumnKind::Improvement:
        return "%";
    }
    return "";
}

double PaperColumn::of(const MsdByRole &msds) const
{
    const double msd = msds[indexOf(role)];
    switch (kind) {
    case PaperColumnKind::Msd:
        return msd;
    case PaperColumnKind::Ratio:
        return msd / msds[indexOf(PaperRole::Before)];
    case PaperColumnKind::Improvement:
        return kPercent * (1.0 - msd / msds[indexOf(against)]);
    }
    return msd;
}

MsdByRole PaperTable::msds(const PrintedRow &row) const
{
    MsdByRole msds;
    msds.fill(std::nan(""));
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (columns[c].kind == PaperColumnKind::Msd)
            msds[indexOf(columns[c].role)] = row.figure(c).value();
    }
    return msds;
}

std::string_view agreementName(PrintedAgreement agreement)
{
    switch (agreement) {
    case PrintedAgreement::Exact:
        return "exact";
    case PrintedAgreement::WithinRounding:
        return "within rounding";
    case PrintedAgreement::No:
        return "no";
    }
    return "";
}

std::vector<PaperCheck> checkPaperTable(const PaperTable &table)
{
    std::vector<PaperCheck> checks;
    for (const PrintedRow &row : table.rows) {
        const MsdByRole msds = table.msds(row);
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const PaperColumn &column = table.columns[c];
            if (column.kind == PaperColumnKind::Msd)
                continue;
            PaperCheck check{table.number, row, column, row.figure(c), std::abs(column.of(msds)), {}, {}};
            check.possible = possibleRange(table, row, column);
            check.agreement = agreementOf(check.printed, check.recomputed, check.possible);
            checks.push_back(check);
        }
    }
    return checks;
}

bool improvementsAgreeAmongThemselves(const PaperTable &table, const PrintedRow &row)
{
    // 1 - p: of Conventional 2 and of Novel on Conventional 1, then of Novel on Conventional 2.
    std::vector<RoundingRange> kept;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (table.columns[c].kind != PaperColumnKind::Improvement)
            continue;
        const RoundingRange percent = row.figure(c).range();
        kept.push_back({1.0 - percent.highest / kPercent, 1.0 - percent.lowest / kPercent});
    }
    if (kept.size() < 3)
        return false;
    const RoundingRange product{kept[0].lowest * kept[2].lowest, kept[0].highest * kept[2].highest};
    return overlap(product, kept[1], kEdge);
}

} // namespace driftbench
