#include "app/cli/physics_text.h"

#include "app/cli/text_table.h"
#include "engine/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

using Json = nlohmann::ordered_json;
using RowFigure = double CombRow::*;

constexpr int kFigures = 6;

double largestOf(const std::vector<CombRow> &rows, RowFigure figure)
{
    double largest = 0.0;
    for (const CombRow &row : rows)
        largest = std::max(largest, std::abs(row.*figure));
    return largest;
}

// Three figures with an exponent: what is right for shares from 1 down to 1e-15.
std::string scientific(double value)
{
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 2);
    return {text.data(), end.ptr};
}

std::string headText(const PhysicsStudy &study)
{
    const auto &[material, geometry, straightAtC] = study.request.comb;
    const CombTransducer &transducer = study.request.transducer;
    std::string text =
        "Combs: a0 " + shortest(geometry.thicknessUm) + " µm thick, overlap b0 " +
        shortest(geometry.overlapLengthUm) + " µm x c0 " + shortest(geometry.overlapWidthUm) +
        " µm, gap d0 " + shortest(geometry.gapUm) + " µm, " + std::to_string(geometry.gapCount) +
        " gaps, relative permittivity " + shortest(geometry.relativePermittivity) + "\nMaterial: expansion " +
        shortest(material.expansionPerC) + " /°C, modulus " + shortest(material.elasticModulusGPa) +
        " GPa, Poisson ratio " + shortest(material.poissonRatio) +
        "; straight at T0 = " + shortest(straightAtC) + " °C\nDisplacement " +
        shortest(transducer.restDisplacementUm) + " µm, " + shortest(transducer.displacementUmPerDps) +
        " µm per dps: scale factor " + scientific(study.table.scaleFactorFfPerDps) + " fF/dps at T0\n";
    if (std::isfinite(study.table.contactC))
        text += "Contact of the combs at " + fixed(study.table.contactC, 3) + " °C\n";
    return text;
}

std::string rowsText(const PhysicsStudy &study, bool asPrinted)
{
    const std::vector<CombRow> &rows = study.table.rows;
    const double lengthUm = study.request.comb.geometry.overlapLengthUm;
    const int change = decimalsFor(largestOf(rows, &CombRow::changeFf), kFigures);
    const int error = decimalsFor(largestOf(rows, &CombRow::errorFf), kFigures - 1);
    const int rate = decimalsFor(largestOf(rows, &CombRow::rateDps), kFigures - 1);
    TextTable table;
    for (const char *title : {"T °C", "ΔT °C", "ΔC fF", "ΔC′ fF", "ΔE fF", "as rate dps"})
        table.addColumn(title, Align::Right);
    if (asPrinted) {
        table.addColumn("Eq. (10) printed fF µm", Align::Right);
        table.addColumn("printed / (b0 ΔC′)", Align::Right);
    }
    for (const CombRow &row : rows) {
        std::vector<std::string> cells{fixed(row.temperatureC, 2),      fixed(row.deltaTC, 2),
                                       fixed(row.restChangeFf, change), fixed(row.changeFf, change),
                                       fixed(row.errorFf, error),       fixed(row.rateDps, rate)};
        if (asPrinted) {
            const auto &printed = row.printedChangeFfUm;
            cells.push_back(printed ? fixed(*printed, change) : "-");
            cells.push_back(printed ? fixed(*printed / (lengthUm * row.changeFf), 9) : "-");
        }
        table.addRow(cells);
    }
    std::string text = "\n" + table.text();
    if (study.table.endsAtContact)
        text += "  The combs touch at " + fixed(study.table.contactC, 3) +
                " °C; the range beyond has no capacitance.\n";
    if (study.thinnestCombUm <= 0.0)
        text += "  At one end of the range Eq. (8) makes the combs thinner than nothing at their ends; it "
                "holds for "
                "small bending only.\n";
    if (asPrinted)
        text += "  Eq. (10) as printed has a length too many and half of the right prefactor; it has no "
                "value for ΔT <= 0.\n";
    return text;
}

std::string sensitivitiesText(const PhysicsStudy &study)
{
    TextTable table;
    table.addColumn("parameter", Align::Left);
    table.addColumn("", Align::Left);
    table.addColumn("value", Align::Right);
    table.addColumn("unit", Align::Left);
    table.addColumn("dΔE/dp fF per unit", Align::Right);
    table.addColumn("% of ΔE per %", Align::Right);
    for (const CombSensitivity &each : study.sensitivities) {
        table.addRow({std::string(each.symbol), std::string(each.name), shortest(each.value),
                      std::string(each.unit), scientific(each.slopeFfPerUnit),
                      std::isfinite(each.relative) ? fixed(each.relative, 4) : "-"});
    }
    return "\nSensitivity of ΔE at " + fixed(study.sensitivitiesAtC, 2) + " °C\n" + table.text() +
           "  E and nu have no part in it: the modulus cancels in Eq. (8), and a beam does not contract.\n";
}

std::string quantitiesText(const PhysicsStudy &study)
{
    if (study.quantities.empty())
        return "\n" + study.nothingToExplain + "\n";
    TextTable table;
    table.addColumn("quantities, with a constant", Align::Left);
    table.addColumn("R²", Align::Right);
    table.addColumn("unexplained", Align::Right);
    table.addColumn("rms left fF", Align::Right);
    table.addColumn("as rate dps", Align::Right);
    for (const TcqShare &share : study.quantities) {
        table.addRow({share.name, fixed(share.explained, 9), scientific(share.unexplained),
                      scientific(share.residualRms),
                      scientific(std::abs(share.residualRms / study.table.scaleFactorFfPerDps))});
    }
    const auto &paper = study.quantities;
    const double byRoot = paper[1].unexplained / paper[2].unexplained;
    const double byCube = paper[1].unexplained / paper[3].unexplained;
    return "\nWhat the temperature quantities explain of ΔE, " +
           fixed(study.curve.rows.front().temperatureC, 2) + " to " +
           fixed(study.curve.rows.back().temperatureC, 2) + " °C\n" + table.text() +
           "  √ΔT (signed) lowers what ΔT and ΔT² leave by a factor of " +
           fixed(byRoot, decimalsFor(byRoot, 2)) + ", ΔT³ by " + fixed(byCube, decimalsFor(byCube, 2)) +
           ": ΔE is analytic in ΔT.\n";
}

Json finite(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

Json numbers(const Eigen::VectorXd &values)
{
    return std::vector<double>(values.begin(), values.end());
}

Json column(const std::vector<CombRow> &rows, RowFigure figure)
{
    Json values = Json::array();
    for (const CombRow &row : rows)
        values.push_back(row.*figure);
    return values;
}

Json combsToJson(const CombParameters &comb)
{
    return {{"expansion_per_C", comb.material.expansionPerC},
            {"elastic_modulus_GPa", comb.material.elasticModulusGPa},
            {"poisson_ratio", comb.material.poissonRatio},
            {"thickness_um", comb.geometry.thicknessUm},
            {"overlap_length_um", comb.geometry.overlapLengthUm},
            {"overlap_width_um", comb.geometry.overlapWidthUm},
            {"gap_um", comb.geometry.gapUm},
            {"gap_count", comb.geometry.gapCount},
            {"relative_permittivity", comb.geometry.relativePermittivity},
            {"straight_at_C", comb.straightAtC}};
}

Json rowsToJson(const std::vector<CombRow> &rows)
{
    Json list = Json::array();
    for (const CombRow &row : rows) {
        list.push_back(
            {{"temperature_C", row.temperatureC},
             {"delta_T_C", row.deltaTC},
             {"rest_change_fF", row.restChangeFf},
             {"change_fF", row.changeFf},
             {"error_fF", row.errorFf},
             {"rate_dps", row.rateDps},
             {"printed_change_fF_um", row.printedChangeFfUm ? Json(*row.printedChangeFfUm) : Json()}});
    }
    return list;
}

Json sensitivitiesToJson(const PhysicsStudy &study)
{
    Json parameters = Json::array();
    for (const CombSensitivity &each : study.sensitivities) {
        parameters.push_back({{"symbol", std::string(each.symbol)},
                              {"name", std::string(each.name)},
                              {"unit", std::string(each.unit)},
                              {"value", each.value},
                              {"slope_fF_per_unit", each.slopeFfPerUnit},
                              {"relative", finite(each.relative)}});
    }
    return {{"temperature_C", study.sensitivitiesAtC}, {"parameters", parameters}};
}

Json quantitiesToJson(const std::vector<TcqShare> &quantities)
{
    Json list = Json::array();
    for (const TcqShare &share : quantities) {
        list.push_back({{"set", share.name},
                        {"terms", share.terms},
                        {"explained", share.explained},
                        {"unexplained", share.unexplained},
                        {"rms_fF", share.residualRms},
                        {"largest_fF", share.residualLargest},
                        {"residual_fF", numbers(share.residual)}});
    }
    return list;
}

Json gapToJson(const PhysicsStudy &study)
{
    Json profiles = Json::array();
    for (const GapProfile &profile : study.gaps)
        profiles.push_back({{"temperature_C", profile.temperatureC}, {"gap_um", numbers(profile.gapUm)}});
    return {{"x_um", numbers(study.alongUm)}, {"profiles", profiles}};
}

} // namespace

std::string physicsAsText(const PhysicsStudy &study, bool asPrinted)
{
    return headText(study) + rowsText(study, asPrinted) + sensitivitiesText(study) + quantitiesText(study);
}

std::string physicsAsCsv(const PhysicsStudy &study, bool asPrinted)
{
    std::string text = "temperature_C,delta_T_C,rest_change_fF,change_fF,error_fF,rate_dps";
    text += asPrinted ? ",printed_change_fF_um\n" : "\n";
    for (const CombRow &row : study.table.rows) {
        text += shortest(row.temperatureC) + "," + shortest(row.deltaTC) + "," + shortest(row.restChangeFf) +
                "," + shortest(row.changeFf) + "," + shortest(row.errorFf) + "," + shortest(row.rateDps);
        if (asPrinted)
            text += "," + (row.printedChangeFfUm ? shortest(*row.printedChangeFfUm) : std::string());
        text += "\n";
    }
    return text;
}

nlohmann::ordered_json physicsToJson(const PhysicsStudy &study)
{
    const std::vector<CombRow> &curve = study.curve.rows;
    return {{"formula", "corrected"},
            {"combs", combsToJson(study.request.comb)},
            {"displacement_um", study.request.transducer.restDisplacementUm},
            {"displacement_um_per_dps", study.request.transducer.displacementUmPerDps},
            {"scale_factor_fF_per_dps", study.table.scaleFactorFfPerDps},
            {"contact_C", finite(study.table.contactC)},
            {"ends_at_contact", study.table.endsAtContact},
            {"thinnest_comb_um", study.thinnestCombUm},
            {"rows", rowsToJson(study.table.rows)},
            {"sensitivities", sensitivitiesToJson(study)},
            {"quantities", quantitiesToJson(study.quantities)},
            {"curve",
             {{"temperature_C", column(curve, &CombRow::temperatureC)},
              {"rest_change_fF", curve.front().restChangeFf},
              {"change_fF", column(curve, &CombRow::changeFf)},
              {"error_fF", column(curve, &CombRow::errorFf)}}},
            {"gap", gapToJson(study)}};
}

} // namespace driftbench::cli
