#include "app/cli/model_input.h"

#include "app/cli/cli_io.h"
#include "engine/models/model_file.h"

namespace driftbench::cli {

void addModelOptions(CLI::App &command, ModelChoice &choice)
{
    command.add_option("--model", choice.file, "Model file that fit wrote, or session (.driftbench)")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--name", choice.name,
                    "Which model of the session (default: the one that is chosen in it, else auto)")
        ->type_name("NAME");
}

bool isSessionPath(const std::filesystem::path &path)
{
    return path.extension() == kSessionEnding;
}

Result<ModelInput> openModel(const ModelChoice &choice)
{
    if (!isSessionPath(choice.file)) {
        if (!choice.name.empty())
            return Error{Errc::InvalidOption,
                         "--name picks a model of a session, but " + choice.file + " is none; leave it out."};
        auto model = loadModel(choice.file);
        if (!model)
            return model.error();
        return ModelInput{*std::move(model)};
    }
    auto session = Session::open(choice.file);
    if (!session)
        return session.error();
    const auto &result = (*session)->result();
    if (!result)
        return Error{Errc::NoSuchRun, choice.file +
                                          " holds no models of its runs as they are now; train them with \"" +
                                          std::string(kProgramName) + " fit " + choice.file + "\"."};
    const std::string name = choice.name.empty() ? (*session)->exportChoice().model : choice.name;
    const TrainedModel *model = result->model(name);
    if (!model) {
        std::string known;
        for (const TrainedModel &each : result->models)
            known += (known.empty() ? "" : ", ") + each.name;
        return Error{Errc::NoSuchRun,
                     choice.file + " has no model named " + name + "; it has " + known + "."};
    }
    return ModelInput{*model, *std::move(session)};
}

bool isNotedIn(const ModelInput &input, const std::string &what)
{
    if (!input.session)
        return false;
    if (!input.session->isReadOnly())
        return true;
    printNotice("The session does not note the " + what + ": " +
                input.session->readOnlyReason().toStdString());
    return false;
}

} // namespace driftbench::cli
