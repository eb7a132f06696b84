#include "app/cli/cli_io.h"
#include "app/cli/command.h"
#include "app/cli/log_options.h"
#include "app/cli/progress_line.h"
#include "app/cli/session_text.h"
#include "app/session/load_job.h"
#include "engine/formats/csv_writer.h"

#include <memory>
#include <nlohmann/json.hpp>

namespace driftbench::cli {

namespace {

struct SessionArguments
{
    std::string file;
    bool json = false;
};

// info ---------------------------------------------------------------------------------------------------

Status showInfo(const SessionArguments &arguments)
{
    const auto session = Session::open(arguments.file, SessionAccess::ReadOnly);
    if (!session)
        return session.error();
    return arguments.json ? printJson(sessionAsJson(**session)) : printResult(sessionAsText(**session));
}

// check --------------------------------------------------------------------------------------------------

Status check(const SessionArguments &arguments)
{
    const auto file = SessionFile::open(arguments.file, SessionAccess::ReadOnly);
    if (!file)
        return file.error();
    ProgressLine progress;
    const auto problems = file->check(progress.hook());
    if (!problems)
        return problems.error();
    std::string text;
    for (const std::string &problem : *problems)
        text += problem + "\n";
    if (problems->empty())
        text = "Nothing is wrong with it.\n";
    const Status shown =
        arguments.json ? printJson({{"file", arguments.file}, {"problems", *problems}}) : printResult(text);
    if (!shown || problems->empty())
        return shown;
    return Error{Errc::SessionDamaged,
                 arguments.file + " is damaged in " + std::to_string(problems->size()) +
                     " places; what can be read of its runs is had by session export-csv."};
}

// export-csv ---------------------------------------------------------------------------------------------

struct ExportCsvArguments
{
    SessionArguments session;
    std::string run;
    std::string out;
};

Result<RunRecord> runNamed(const SessionFile &file, const std::string &name)
{
    const auto runs = file.runs();
    if (!runs)
        return runs.error();
    std::string known;
    for (const RunRecord &run : *runs) {
        if (run.description.name == name || (name.empty() && runs->size() == 1))
            return run;
        known += (known.empty() ? "" : ", ") + run.description.name;
    }
    return Error{Errc::NoSuchRun, file.path().string() + " has no run " +
                                      (name.empty() ? "at all" : "named " + name) + "; it has " +
                                      (known.empty() ? "none" : known) + "."};
}

Status exportCsv(const ExportCsvArguments &arguments)
{
    const auto file = SessionFile::open(arguments.session.file, SessionAccess::ReadOnly);
    if (!file)
        return file.error();
    const auto run = runNamed(*file, arguments.run);
    if (!run)
        return run.error();
    ProgressLine progress;
    const auto recording = file->readRun(run->id, {.skipDamaged = true}, progress.hook());
    if (!recording)
        return recording.error();
    printWarnings(run->description.name, recording->info.warnings);
    if (Status written = writeCsv(arguments.out, *recording); !written)
        return written;
    if (arguments.session.json)
        return printJson({{"out", arguments.out},
                          {"run", run->description.name},
                          {"samples", recording->size()},
                          {"warnings", recording->info.warnings}});
    return printResult(arguments.out + "\n");
}

// import -------------------------------------------------------------------------------------------------

struct ImportArguments
{
    SessionArguments session;
    LoadInput input;
};

Result<std::unique_ptr<Session>> openOrCreate(const std::filesystem::path &path)
{
    std::error_code code;
    return std::filesystem::exists(path, code) ? Session::open(path) : Session::create(path);
}

Status import(const ImportArguments &arguments)
{
    const auto session = openOrCreate(arguments.session.file);
    if (!session)
        return session.error();
    if ((*session)->isReadOnly())
        return Error{Errc::SessionReadOnly, (*session)->readOnlyReason().toStdString()};
    LoadInput input = arguments.input;
    auto file = (*session)->anotherFile();
    if (!file)
        return file.error();
    input.file = *std::move(file);
    std::vector<LoadedLog> logs;
    {
        ProgressLine progress;
        logs = importLogs(input, progress.hook());
    }
    if (Status read = (*session)->refreshRuns(); !read)
        return read;
    Status first;
    nlohmann::ordered_json imported = nlohmann::ordered_json::array();
    std::string text;
    for (const LoadedLog &log : logs) {
        if (!log.run) {
            printNotice(log.run.error().message);
            if (first)
                first = log.run.error();
            continue;
        }
        const std::string &name = (*session)->run(*log.run)->description.name;
        imported.push_back({{"file", log.path.string()}, {"run", name}, {"id", *log.run}});
        text += name + "\n";
    }
    if (Status shown = arguments.session.json ? printJson({{"imported", imported}}) : printResult(text);
        !shown)
        return shown;
    return first;
}

// options ------------------------------------------------------------------------------------------------

CLI::App *addPart(CLI::App &session, const std::string &name, const std::string &description,
                  const std::string &example, SessionArguments &arguments)
{
    CLI::App *part = addCommand(session, name, description, "driftbench-cli session " + example);
    part->add_option("SESSION", arguments.file, "Session file (.driftbench)")->required();
    addJsonOption(*part, arguments.json);
    return part;
}

void addImport(CLI::App &session, Invocation &invocation)
{
    const auto arguments = std::make_shared<ImportArguments>();
    CLI::App *part =
        addPart(session, "import",
                "Reads logs into the session, which is made if it is not there. A log that can't be "
                "read does not keep the others out.",
                "import gyro7.driftbench run1.csv run2.csv", arguments->session);
    part->add_option("RUN", arguments->input.files, "Logs of one sensor")->required();
    addReferenceRateOption(*part, arguments->input.referenceRateDps);
    addSensorOption(*part, arguments->input.sensor);
    addReadOptions(*part, arguments->input.read);
    part->callback([arguments, &invocation] { invocation.run = [arguments] { return import(*arguments); }; });
}

void addExportCsv(CLI::App &session, Invocation &invocation)
{
    const auto arguments = std::make_shared<ExportCsvArguments>();
    CLI::App *part =
        addPart(session, "export-csv", "Writes a run as a CSV log, what is damaged in it left out.",
                "export-csv gyro7.driftbench --run \"run 2\" --out run2.csv", arguments->session);
    part->add_option("--run", arguments->run, "Name of the run (default: the only one)")->type_name("NAME");
    part->add_option("--out", arguments->out, "File to write")->required()->type_name("FILE");
    part->callback(
        [arguments, &invocation] { invocation.run = [arguments] { return exportCsv(*arguments); }; });
}

} // namespace

void addSessionCommand(CLI::App &program, Invocation &invocation)
{
    CLI::App *session =
        addCommand(program, "session",
                   "Looks into a session file, which keeps a calibration with its runs, models, exports "
                   "and uploads; brings logs in and out.",
                   "driftbench-cli session info gyro7.driftbench");
    session->require_subcommand(1);
    const auto info = std::make_shared<SessionArguments>();
    addPart(*session, "info", "Prints what the session holds.", "info gyro7.driftbench", *info)
        ->callback([info, &invocation] { invocation.run = [info] { return showInfo(*info); }; });
    addImport(*session, invocation);
    addExportCsv(*session, invocation);
    const auto checked = std::make_shared<SessionArguments>();
    addPart(*session, "check", "Reads the whole file and says what is damaged in it.",
            "check gyro7.driftbench", *checked)
        ->callback([checked, &invocation] { invocation.run = [checked] { return check(*checked); }; });
}

} // namespace driftbench::cli
