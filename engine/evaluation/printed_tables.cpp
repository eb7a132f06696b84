// The figures of the paper's tables, digit by digit.
#include "engine/base/axes.h"
#include "engine/evaluation/paper_tables.h"

#include <cassert>

namespace driftbench {

namespace {

using enum PaperColumnKind;
using enum PaperRole;
using Text = std::string_view;

constexpr int kRuns = 5;

constexpr std::array<PaperColumn, 6> kColumnsAtRest{{
    {"MSD1", Msd, Before},
    {"MSD2", Msd, Conventional2},
    {"MSD3", Msd, Novel},
    {"Q1", Ratio, Conventional2},
    {"Q2", Ratio, Novel},
    {"|Q2-Q1|/Q1", Improvement, Novel, Conventional2},
}};

constexpr std::array<PaperColumn, 10> kColumnsOnThreeAxes{{
    {"MSD1", Msd, Before},
    {"MSD4", Msd, Conventional1},
    {"MSD5", Msd, Conventional2},
    {"MSD6", Msd, Novel},
    {"Q3", Ratio, Conventional1},
    {"Q4", Ratio, Conventional2},
    {"Q5", Ratio, Novel},
    {"|Q4-Q3|/Q3", Improvement, Conventional2, Conventional1},
    {"|Q5-Q3|/Q3", Improvement, Novel, Conventional1},
    {"|Q5-Q4|/Q4", Improvement, Novel, Conventional2},
}};

// A row a run.
constexpr std::array<std::array<Text, kColumnsAtRest.size()>, kRuns> kAtRest{{
    {"9.5552", "3.5555e-2", "3.2172e-2", "3.7210e-3", "3.3670e-3", "9.51"},
    {"9.5579", "3.5957e-2", "3.1756e-2", "3.7620e-3", "3.3224e-3", "11.68"},
    {"9.5567", "3.4492e-2", "3.1616e-2", "3.6092e-3", "3.3083e-3", "8.34"},
    {"9.5590", "3.5734e-2", "3.1339e-2", "3.7383e-3", "3.2784e-3", "12.30"},
    {"9.5507", "3.5442e-2", "3.1660e-2", "3.7109e-3", "3.3150e-3", "10.67"},
}};

// A table a run, a row an axis.
using AxisRows = std::array<std::array<Text, kColumnsOnThreeAxes.size()>, kAxisCount>;
// clang-format off
constexpr std::array<AxisRows, kRuns> kOnThreeAxes{{
    {{{"4.7794", "0.0216", "0.0214", "0.0193", "4.519e-3", "4.478e-3", "4.038e-3", "0.93", "10.65", "9.81"},
      {"8.5768", "0.0280", "0.0233", "0.0214", "3.265e-3", "2.717e-3", "2.495e-3", "16.79", "23.57", "8.15"},
      {"0.7258", "0.0270", "0.0220", "0.0210", "3.720e-2", "3.031e-2", "2.893e-2", "18.52", "22.22", "4.55"}}},
    {{{"3.8545", "0.0194", "0.0192", "0.0184", "5.033e-3", "4.981e-3", "4.774e-3", "1.03", "5.15", "4.17"},
      {"6.8265", "0.0256", "0.0219", "0.0208", "3.750e-3", "3.208e-3", "3.047e-3", "14.53", "18.75", "5.02"},
      {"0.6582", "0.0271", "0.0211", "0.0202", "4.117e-2", "3.206e-2", "3.069e-2", "22.14", "25.46", "4.27"}}},
    {{{"4.7779", "0.0210", "0.0202", "0.0190", "4.395e-3", "4.227e-3", "3.976e-3", "3.81", "9.52", "5.94"},
      {"8.5962", "0.0289", "0.0240", "0.0221", "3.362e-3", "2.792e-3", "2.571e-3", "16.96", "23.53", "7.92"},
      {"0.7286", "0.0280", "0.0227", "0.0214", "3.843e-2", "3.116e-2", "2.937e-2", "24.91", "26.35", "1.92"}}},
    {{{"3.8575", "0.0200", "0.0199", "0.0189", "5.185e-3", "5.159e-3", "4.900e-3", "0.51", "5.50", "5.03"},
      {"6.8208", "0.0256", "0.0221", "0.0211", "3.753e-3", "3.240e-3", "3.094e-3", "13.67", "17.58", "4.52"},
      {"0.6538", "0.0273", "0.0207", "0.0200", "4.176e-2", "3.166e-2", "3.059e-2", "24.18", "26.74", "3.38"}}},
    {{{"3.8538", "0.0198", "0.0193", "0.0189", "5.138e-3", "5.008e-3", "4.904e-3", "2.53", "4.55", "2.07"},
      {"6.8339", "0.0256", "0.0217", "0.0212", "3.746e-3", "3.175e-3", "3.102e-3", "15.23", "17.19", "2.30"},
      {"0.6588", "0.0274", "0.0209", "0.0203", "4.159e-2", "3.172e-2", "3.081e-2", "23.72", "25.91", "2.87"}}},
}};
// clang-format on

PaperTable tableAtRest()
{
    PaperTable table{1, kColumnsAtRest, {}};
    for (int run = 0; run < kRuns; ++run)
        table.rows.push_back({run, 0, kAtRest[static_cast<std::size_t>(run)]});
    return table;
}

PaperTable tableOnThreeAxes(int number)
{
    const int run = number - 2;
    PaperTable table{number, kColumnsOnThreeAxes, {}};
    for (int axis = 0; axis < kAxisCount; ++axis)
        table.rows.push_back(
            {run, axis, kOnThreeAxes[static_cast<std::size_t>(run)][static_cast<std::size_t>(axis)]});
    return table;
}

} // namespace

PaperTable paperTable(int number)
{
    assert(number >= 1 && number <= kPaperTableCount);
    return number == 1 ? tableAtRest() : tableOnThreeAxes(number);
}

} // namespace driftbench
