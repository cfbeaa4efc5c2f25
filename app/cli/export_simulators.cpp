// `export FILE --to mjcf|urdf -o FOLDER`: a model of rigid bodies for simulators, with its meshes.

#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/export_forms.h"
#include "app/cli/load_train.h"
#include "app/cli/mass_options.h"
#include "app/cli/number_options.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/folder.h"
#include "core/presentation/simulators/simulator_model.h"

namespace geargraph::cli {
namespace {

std::variant<SimulatorOptions, UsageError> simulatorOptions(const Arguments& arguments) {
  SimulatorOptions options;
  const auto timestep = numberWithin(arguments, "--timestep", options.timestep, 1e-6, 1);
  const auto tolerance = numberWithin(arguments, "--tolerance", options.tolerance, 1e-4, 0.2);
  const auto armature = numberWithin(arguments, "--armature", 0, 0, 1e9);
  for (const auto* read : {&timestep, &tolerance, &armature}) {
    if (const auto* error = std::get_if<UsageError>(read)) return *error;
  }
  options.timestep = std::get<double>(timestep);
  options.tolerance = std::get<double>(tolerance);
  if (arguments.has("--armature")) options.armature = std::get<double>(armature);
  const std::string motor = arguments.value("--motor").value_or("speed");
  if (motor == "speed") {
    options.motor = SimulatorMotor::speed;
  } else if (motor == "torque") {
    options.motor = SimulatorMotor::torque;
  } else if (motor == "none") {
    options.motor = SimulatorMotor::none;
  } else {
    return UsageError{translated("--motor is one of speed, torque, none.")};
  }
  return options;
}

int failureOf(const SimulatorError& error, const Arguments& arguments) {
  if (error.kind == SimulatorError::Kind::stopped) return outOfTime(arguments, translated("the model"));
  std::cerr << "geargraph-cli: " << error.message << '\n';
  return error.kind == SimulatorError::Kind::limit ? kResourceLimit : kMechanismErrors;
}

/// What the user should know about the freedom of what was written.
void tellFreedom(const ExportTrain& loaded, const Arguments& arguments) {
  const std::vector<int>& inputs = loaded.snapshot->matroid()->choice.joints;
  if (inputs.empty()) {
    std::cerr << "geargraph-cli: " << translated("Nothing can move; the model holds still.") << '\n';
    return;
  }
  const auto state = arguments.value("--state");
  if (!state || inputs.size() < 2) return;
  std::vector<std::string> driven;
  for (const int input : inputs) driven.push_back(std::to_string(loaded.snapshot->graph->edgeLabel(input)));
  std::cerr << "geargraph-cli: "
            << translated("State %1 leaves %2 freedoms; joints %3 are driven.",
                          {*state, std::to_string(inputs.size()), listed(driven, kAllNames)})
            << '\n';
}

}  // namespace

int exportSimulator(const Arguments& arguments, SimulatorForm form) {
  const auto options = simulatorOptions(arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kExport, error->message);
  const std::filesystem::path folder = *arguments.value("-o");
  if (folder == "-")
    return wrongUsage(kExport, translated("A model for simulators is a folder; \"-\" is none."));
  const auto loaded = loadTrain(
      arguments, [&](Mechanism mechanism) { return withMassOptions(std::move(mechanism), arguments); });
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const ExportTrain& train = std::get<ExportTrain>(loaded);
  const MatroidAnalysis* const matroid = train.snapshot->matroid();
  if (matroid == nullptr || !matroid->solution) {
    std::cerr << "geargraph-cli: "
              << translated("There is no solution to drive the model by; nothing was written.") << '\n';
    return kMechanismErrors;
  }
  if (matroid->solution->inputs.size() * matroid->solution->outputs.size() >
      ExactSolution::kMaxExactEntries) {
    std::cerr
        << "geargraph-cli: "
        << translated(
               "Models for simulators have at most %1 entries of the solution (inputs times other joints).",
               {std::to_string(ExactSolution::kMaxExactEntries)})
        << '\n';
    return kResourceLimit;
  }
  auto made =
      simulatorModel(*train.snapshot, train.train, std::get<SimulatorOptions>(options), arguments.stop);
  if (const auto* error = std::get_if<SimulatorError>(&made)) return failureOf(*error, arguments);
  auto& model = std::get<SimulatorModel>(made);
  std::variant<std::string, SimulatorError> text =
      form == SimulatorForm::mjcf
          ? std::variant<std::string, SimulatorError>(mjcfText(model, std::get<SimulatorOptions>(options)))
          : urdfText(model);
  if (const auto* error = std::get_if<SimulatorError>(&text)) return failureOf(*error, arguments);
  const std::filesystem::path source = arguments.files.front();
  const std::string stem = source == "-" ? "mechanism" : source.stem().string();
  FolderFiles files = std::move(model.meshes);
  files.emplace_back(stem + (form == SimulatorForm::mjcf ? ".xml" : ".urdf"),
                     std::get<std::string>(std::move(text)));
  const auto error = writeFolder(folder, files, {arguments.has("--force"), arguments.stop, {}});
  if (error)
    return error->isStopped ? outOfTime(arguments, translated("the folder")) : fileFailure(error->message);
  for (const SimulatorNote& note : model.notes) std::cerr << "geargraph-cli: " << note.text << '\n';
  tellFreedom(train, arguments);
  return kFine;
}

}  // namespace geargraph::cli
