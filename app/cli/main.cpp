#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/help_format.h"
#include "app/cli/interrupt.h"

#include <exception>
#include <memory>

namespace driftbench::cli {

namespace {

std::string usageSentence(const CLI::App &program, const CLI::ParseError &error)
{
    if (program.get_subcommands().empty() && !program.remaining().empty())
        return "There is no command or option \"" + program.remaining().front() + "\"; see " +
               std::string(kProgramName) + " --help.";
    std::string help(kProgramName);
    for (const CLI::App *command : program.get_subcommands())
        help += " " + command->get_name();
    std::string what = error.what();
    while (!what.empty() && (what.back() == '.' || what.back() == '\n'))
        what.pop_back();
    return what + "; see " + help + " --help.";
}

int runProgram(int argc, char **argv)
{
    CLI::App program(
        "Removes the temperature drift of MEMS gyros: logs in, models judged on unseen runs, tables out.",
        std::string(kProgramName));
    program.formatter(std::make_shared<HelpFormat>()); // commands inherit it
    program.set_version_flag("--version", std::string(kProgramName) + " " + DRIFTBENCH_VERSION);
    program.require_subcommand(1);
    program.footer("Example:\n  driftbench-cli simulate --out campaign --reference-rate 25,5,53\n\n" +
                   exitCodeList());
    Invocation invocation;
    for (const AddCommand add : allCommands())
        add(program, invocation);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            return program.exit(error); // help or version
        printError(usageSentence(program, error));
        return kExitUsage;
    }
    listenForInterrupts();
    const Status status = invocation.run();
    if (status)
        return kExitSuccess;
    printError(status.error().message);
    return static_cast<int>(status.error().code);
}

} // namespace

} // namespace driftbench::cli

int main(int argc, char **argv)
{
    using namespace driftbench::cli;
    try {
        return runProgram(argc, argv);
    } catch (const std::exception &error) {
        printError("An error of the program itself (" + std::string(error.what()) +
                   "); please report it with the command you gave.");
    } catch (...) {
        printError("An error of the program itself; please report it with the command you gave.");
    }
    return kExitUnexpected;
}
