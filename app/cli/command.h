// How a command of driftbench-cli comes to be: one file command_<name>.cpp with one function that adds the
// command's options to the program and, when the command is named, leaves in the invocation what to run.
// A new command is declared below and entered in kCommands in command.cpp.
//
//   void addFitCommand(CLI::App &program, Invocation &invocation)
//   {
//       auto options = std::make_shared<FitOptions>();
//       CLI::App *command = addCommand(program, "fit", "what it does", "driftbench-cli fit run1.csv --out
//       fit"); command->add_option("--seed", options->seed, "of the networks")->capture_default_str();
//       command->callback([options, &invocation] { invocation.run = [options] { return fit(*options); }; });
//   }
//
// An error that run returns is printed as its sentence; its code is the exit code.
#pragma once

#include "engine/base/result.h"
#include "engine/evaluation/scoring.h"

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace driftbench::cli {

struct Invocation
{
    std::function<Status()> run;
};

using AddCommand = void (*)(CLI::App &program, Invocation &invocation);

void addApplyCommand(CLI::App &program, Invocation &invocation);
void addDeviceCommand(CLI::App &program, Invocation &invocation);
void addDevicesCommand(CLI::App &program, Invocation &invocation);
void addEvaluateCommand(CLI::App &program, Invocation &invocation);
void addExportCommand(CLI::App &program, Invocation &invocation);
void addFitCommand(CLI::App &program, Invocation &invocation);
void addInspectCommand(CLI::App &program, Invocation &invocation);
void addPhysicsCommand(CLI::App &program, Invocation &invocation);
void addRecordCommand(CLI::App &program, Invocation &invocation);
void addReproduceCommand(CLI::App &program, Invocation &invocation);
void addPlanCommand(CLI::App &program, Invocation &invocation);
void addSessionCommand(CLI::App &program, Invocation &invocation);
void addSimulateCommand(CLI::App &program, Invocation &invocation);

std::span<const AddCommand> allCommands();

// A subcommand whose help ends with an example.
CLI::App *addCommand(CLI::App &program, const std::string &name, const std::string &description,
                     const std::string &example);

// Options that several commands have, with the same words.
void addJsonOption(CLI::App &command, bool &json);
void addSeedOption(CLI::App &command, std::uint64_t &seed);
void addJudgeOption(CLI::App &command, Judging &judging);
void addReferenceRateOption(CLI::App &command, Eigen::Vector3d &referenceRateDps);

// "x,y" or "xy" of --axes.
Result<std::array<bool, 3>> axesNamed(const std::string &text);

// "25,5,53" of the named option; anything else is a usage error.
Eigen::Vector3d parseTriple(const std::string &option, const std::string &text);

} // namespace driftbench::cli
