#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/output_folder.h"
#include "app/cli/pending_files.h"
#include "app/cli/physics_text.h"
#include "app/cli/sibling_program.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char *kReportProgram = "driftbench-report";

struct PhysicsArguments
{
    PhysicsRequest request;
    bool asPrinted = false;
    std::string csv;
    std::string out;
    bool json = false;
};

Status writeFiles(const PhysicsArguments &arguments, const PhysicsStudy &study)
{
    OutputFolders folders;
    PendingFiles files;
    const std::string csv = physicsAsCsv(study, arguments.asPrinted);
    if (!arguments.csv.empty()) {
        if (Status added = files.add(arguments.csv, csv); !added)
            return added;
    }
    if (!arguments.out.empty()) {
        if (Status made = folders.make(arguments.out); !made)
            return made;
        if (Status added = files.add(fs::path(arguments.out) / "physics.csv", csv); !added)
            return added;
        const std::string json = physicsToJson(study).dump(1) + "\n";
        if (Status added = files.add(fs::path(arguments.out) / "physics.json", json); !added)
            return added;
    }
    if (Status committed = files.commit(); !committed)
        return committed;
    folders.keep();
    return {};
}

// The page with the plots; empty, and a notice, where they could not be drawn.
std::string drawPlots(const std::string &out)
{
    const std::string plots = (fs::path(out) / "plots").string();
    const auto report = siblingProgram(kReportProgram);
    if (!report) {
        printNotice("There is no " + std::string(kReportProgram) +
                    " beside this program, so no plots; run \"" + kReportProgram + " " + out + " --out " +
                    plots + "\" where it is installed.");
        return {};
    }
    if (const int code = runQuietly(*report, {out, "--out", plots}); code != 0) {
        printNotice("The plots could not be drawn; run \"" + report->string() + " " + out + " --out " +
                    plots + "\" to see why.");
        return {};
    }
    return (fs::path(plots) / "index.html").string();
}

Status physics(const PhysicsArguments &arguments)
{
    const auto study = studyPhysics(arguments.request);
    if (!study)
        return study.error();
    if (Status written = writeFiles(arguments, *study); !written)
        return written;
    const std::string plots = arguments.out.empty() ? std::string() : drawPlots(arguments.out);
    if (arguments.json) {
        auto json = physicsToJson(*study);
        if (!plots.empty())
            json["plots"] = plots;
        return printJson(json);
    }
    std::string text = physicsAsText(*study, arguments.asPrinted);
    if (!arguments.csv.empty())
        text += "\nTable: " + arguments.csv + "\n";
    if (!arguments.out.empty())
        text += "\nTable and figures: " + (fs::path(arguments.out) / "physics.csv").string() + ", " +
                (fs::path(arguments.out) / "physics.json").string() + "\n";
    if (!plots.empty())
        text += "Plots: " + plots + "\n";
    return printResult(text);
}

void addNumber(CLI::App &command, const std::string &name, double &value, const std::string &what,
               const std::string &unit)
{
    command.add_option(name, value, what)->type_name(unit);
}

void addCombOptions(CLI::App &command, CombParameters &comb)
{
    CombGeometry &geometry = comb.geometry;
    addNumber(command, "--thickness", geometry.thicknessUm, "Comb thickness a0", "UM");
    addNumber(command, "--length", geometry.overlapLengthUm, "Overlap length b0", "UM");
    addNumber(command, "--width", geometry.overlapWidthUm, "Overlap width c0", "UM");
    addNumber(command, "--gap", geometry.gapUm, "Gap d0", "UM");
    command.add_option("--gaps", geometry.gapCount, "Number of gaps n")->type_name("N");
    addNumber(command, "--permittivity", geometry.relativePermittivity, "Relative permittivity in the gap",
              "NUMBER");
    addNumber(command, "--expansion", comb.material.expansionPerC, "Thermal expansion coefficient per °C",
              "NUMBER");
    addNumber(command, "--modulus", comb.material.elasticModulusGPa, "Elastic modulus", "GPA");
    addNumber(command, "--poisson", comb.material.poissonRatio, "Poisson ratio", "NUMBER");
    addNumber(command, "--straight-at", comb.straightAtC, "Temperature T0 at which the combs are straight",
              "C");
}

} // namespace

void addPhysicsCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<PhysicsArguments>();
    PhysicsRequest &request = arguments->request;
    CLI::App *command =
        addCommand(program, "physics",
                   "The sensing combs under thermal stress: change and error of their "
                   "capacitance over temperature, what that error depends on, and how much of "
                   "it the temperature quantities explain. The sizes and displacements are "
                   "assumed ones, the material is the paper's.",
                   "driftbench-cli physics --length 100 --from -40 --to 85 --out combs");
    command->option_defaults()->always_capture_default();
    addCombOptions(*command, request.comb);
    addNumber(*command, "--displacement", request.transducer.restDisplacementUm, "Displacement of the combs",
              "UM");
    addNumber(*command, "--displacement-per-dps", request.transducer.displacementUmPerDps,
              "What a rate of 1 dps adds to it; turns the error into a rate", "UM");
    addNumber(*command, "--from", request.range.lowestC, "Lowest temperature", "C");
    addNumber(*command, "--to", request.range.highestC, "Highest temperature", "C");
    addNumber(*command, "--step", request.range.stepC, "From row to row", "C");
    command->option_defaults()->always_capture_default(false);
    command->add_flag("--as-printed", arguments->asPrinted,
                      "Show Eq. (10) as the paper prints it beside the corrected one");
    command->add_option("--csv", arguments->csv, "File for the table")->type_name("FILE");
    command
        ->add_option("--out", arguments->out,
                     "Folder for physics.csv, physics.json and the plots; made if it is not there")
        ->type_name("DIR");
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return physics(*arguments); }; });
}

} // namespace driftbench::cli
