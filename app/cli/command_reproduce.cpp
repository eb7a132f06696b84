#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/output_folder.h"
#include "app/cli/progress_line.h"
#include "app/cli/reproduce_files.h"
#include "app/cli/reproduce_text.h"
#include "app/cli/reproduction.h"

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace driftbench::cli {

namespace {

struct ReproduceArguments
{
    std::uint64_t seed = 1;
    std::set<int> tables{1, 2, 3, 4, 5, 6};
    std::string out;
    bool checkOnly = false;
    bool json = false;
};

std::optional<int> tableNumber(std::string_view text)
{
    int number = 0;
    const char *end = text.data() + text.size();
    const auto [parsed, code] = std::from_chars(text.data(), end, number);
    if (code != std::errc() || parsed != end || number < 1 || number > kPaperTableCount)
        return std::nullopt;
    return number;
}

// "1,3-5"; anything else is a usage error.
std::set<int> parseTables(const std::string &text)
{
    const auto refuse = [&text] {
        throw CLI::ValidationError("--tables", "\"" + text + "\" does not name tables from 1 to " +
                                                   std::to_string(kPaperTableCount) + ", like 1,3-5");
    };
    std::set<int> tables;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string_view part = std::string_view(text).substr(at, comma - at);
        const std::size_t dash = std::min(part.find('-'), part.size());
        const auto first = tableNumber(part.substr(0, dash));
        const auto last = dash < part.size() ? tableNumber(part.substr(dash + 1)) : first;
        if (!first || !last || *first > *last)
            refuse();
        for (int table = *first; table <= *last; ++table)
            tables.insert(table);
        at = comma + 1;
    }
    return tables;
}

// Only what the tables show.
Result<std::vector<PaperExperimentOutcome>> runExperiments(const ReproduceArguments &arguments)
{
    std::vector<PaperExperiment> wanted;
    for (const PaperExperiment &experiment : paperExperiments()) {
        for (const int table : arguments.tables) {
            if (experiment.shows(table)) {
                wanted.push_back(experiment);
                break;
            }
        }
    }
    ProgressLine progress;
    const ProgressHook hook = progress.hook();
    std::vector<PaperExperimentOutcome> outcomes;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto part = [&hook, i, &wanted](const Progress &of) {
            return hook(
                {of.stage, (static_cast<double>(i) + of.fraction) / static_cast<double>(wanted.size())});
        };
        // Each with a seed of its own, so that the noise of one says nothing about that of the other.
        const auto place = static_cast<std::uint64_t>(wanted[i].firstTable - 1);
        auto outcome = runPaperExperiment(wanted[i], arguments.seed + place, part);
        if (!outcome)
            return outcome.error();
        outcomes.push_back(*std::move(outcome));
    }
    return outcomes;
}

Status reproduce(const ReproduceArguments &arguments)
{
    OutputFolders folders;
    if (!arguments.out.empty()) {
        if (Status writable = folders.make(arguments.out); !writable)
            return writable;
    }
    std::vector<PaperExperimentOutcome> outcomes;
    if (!arguments.checkOnly) {
        auto run = runExperiments(arguments);
        if (!run)
            return run.error();
        outcomes = *std::move(run);
    }
    for (const PaperExperimentOutcome &outcome : outcomes) {
        for (const std::string &warning : outcome.warnings)
            printNotice(outcome.experiment.sensor + ": " + warning);
    }
    const Reproduction reproduction = assembleReproduction({arguments.tables.begin(), arguments.tables.end()},
                                                           arguments.seed, std::move(outcomes));
    if (!arguments.out.empty()) {
        if (Status written = writeReproduction(reproduction, arguments.out); !written)
            return written;
        folders.keep();
    }
    return arguments.json ? printJson(reproductionToJson(reproduction))
                          : printResult(reproductionToText(reproduction));
}

} // namespace

void addReproduceCommand(CLI::App &program, Invocation &invocation)
{
    const auto arguments = std::make_shared<ReproduceArguments>();
    CLI::App *command = addCommand(
        program, "reproduce",
        "Runs the paper's two experiments on the simulator and prints its Tables 1 to 6 with the simulated "
        "figures below the printed ones; checks the arithmetic of the printed ones.",
        "driftbench-cli reproduce --out paper-tables");
    addSeedOption(*command, arguments->seed);
    const auto parse = [arguments](const std::string &text) { arguments->tables = parseTables(text); };
    command->add_option_function<std::string>("--tables", parse, "Which tables, like 1,3-5 (default: all)")
        ->type_name("LIST");
    CLI::Option *out =
        command
            ->add_option("--out", arguments->out,
                         "Also writes tables.md, tables.csv and tables.json into this folder; made if it is "
                         "not there")
            ->type_name("DIR");
    command
        ->add_flag("--check-only", arguments->checkOnly,
                   "Only the arithmetic of the printed tables; nothing is simulated")
        ->excludes(out);
    addJsonOption(*command, arguments->json);
    command->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return reproduce(*arguments); }; });
}

} // namespace driftbench::cli
