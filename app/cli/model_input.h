// A trained model as the commands name it: a file that fit wrote, or a session and one of its models.
#pragma once

#include "app/session/session.h"
#include "engine/base/result.h"
#include "engine/models/trained_model.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

namespace driftbench::cli {

struct ModelChoice
{
    std::string file; // of the model, or of the session
    std::string name; // in a session; empty: the one that is chosen there
};

// --model FILE and --name NAME
void addModelOptions(CLI::App &command, ModelChoice &choice);

bool isSessionPath(const std::filesystem::path &path); // by its ending

struct ModelInput
{
    TrainedModel model;
    std::unique_ptr<Session> session{}; // that it is in; null: it is a file
};

// Errors: those of loadModel and Session::open; NoSuchRun where the session has no such model.
Result<ModelInput> openModel(const ModelChoice &choice);

// Whether the model's session can keep what was done with it ("export", "upload"). One that can't be written
// to does not undo what was done: a notice says so.
bool isNotedIn(const ModelInput &input, const std::string &what);

} // namespace driftbench::cli
