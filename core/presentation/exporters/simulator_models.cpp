// Models of rigid bodies for simulators, with their meshes.

#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/files/folder.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/mass_options.h"
#include "core/presentation/exporters/number_options.h"
#include "core/presentation/simulators/simulator_model.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNotExpressible{
    "not-expressible", toTranslate("The format cannot hold the mechanism: a joint depends on several inputs, "
                                   "a link is too light, or the unit of length is not known.")};

enum class SimulatorForm { mjcf, urdf };

constexpr std::array kMotors = {std::pair<std::string_view, SimulatorMotor>{"speed", SimulatorMotor::speed},
                                std::pair<std::string_view, SimulatorMotor>{"torque", SimulatorMotor::torque},
                                std::pair<std::string_view, SimulatorMotor>{"none", SimulatorMotor::none}};

std::vector<std::string> namesOfMotors() {
  std::vector<std::string> names;
  for (const auto& [name, motor] : kMotors) names.emplace_back(name);
  return names;
}

std::variant<SimulatorOptions, UsageError> simulatorOptions(const OptionValues& given) {
  SimulatorOptions options;
  const auto timestep = numberWithin(given, "--timestep", options.timestep, 1e-6, 1);
  const auto tolerance = numberWithin(given, "--tolerance", options.tolerance, 1e-4, 0.2);
  const auto armature = numberWithin(given, "--armature", 0, 0, 1e9);
  for (const auto* read : {&timestep, &tolerance, &armature}) {
    if (const auto* error = std::get_if<UsageError>(read)) return *error;
  }
  options.timestep = std::get<double>(timestep);
  options.tolerance = std::get<double>(tolerance);
  if (given.has("--armature")) options.armature = std::get<double>(armature);
  const std::string motor = given.value("--motor").value_or("speed");
  for (const auto& [name, value] : kMotors) {
    if (name != motor) continue;
    options.motor = value;
    return options;
  }
  return UsageError{translated("--motor is one of speed, torque, none.")};
}

ExportError simulatorErrorOf(const SimulatorError& error) {
  if (error.kind == SimulatorError::Kind::stopped) return outOfTime(translated("the model"));
  if (error.kind == SimulatorError::Kind::limit)
    return {ExportError::Kind::limit, error.message, kTooLargeRefusal.code};
  return {ExportError::Kind::mechanism, error.message, kNotExpressible.code};
}

/// What the user should know about the freedom of what was written.
void tellFreedom(const ExportContext& context, const ExportTrain& train, const OptionValues& given) {
  const std::vector<int>& inputs = train.snapshot->matroid()->choice.joints;
  if (inputs.empty()) return context.tell(translated("Nothing can move; the model holds still."));
  const auto state = given.value("--state");
  if (!state || inputs.size() < 2) return;
  std::vector<std::string> driven;
  for (const int input : inputs) driven.push_back(std::to_string(train.snapshot->graph->edgeLabel(input)));
  context.tell(translated("State %1 leaves %2 freedoms; joints %3 are driven.",
                          {*state, std::to_string(inputs.size()), listed(driven, kAllNames)}));
}

/// The gears of a document with a solution that drives the model.
std::variant<ExportTrain, ExportError> drivenTrain(ExportContext& context, const OptionValues& given,
                                                   const std::stop_token& stop) {
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  auto weighed = withMassOptions(std::get<Mechanism>(std::move(document)), given);
  if (auto* error = std::get_if<UsageError>(&weighed))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  auto loaded = context.train(std::get<Mechanism>(std::move(weighed)), false, stop);
  const auto* train = std::get_if<ExportTrain>(&loaded);
  if (train == nullptr) return loaded;
  const MatroidAnalysis* const matroid = train->snapshot->matroid();
  if (matroid == nullptr || !matroid->solution) {
    return ExportError{ExportError::Kind::mechanism,
                       translated("There is no solution to drive the model by; nothing was written."),
                       kNoSolutionRefusal.code};
  }
  if (matroid->solution->inputs.size() * matroid->solution->outputs.size() >
      ExactSolution::kMaxExactEntries) {
    return ExportError{
        ExportError::Kind::limit,
        translated(
            "Models for simulators have at most %1 entries of the solution (inputs times other joints).",
            {std::to_string(ExactSolution::kMaxExactEntries)}),
        kTooLargeRefusal.code};
  }
  return loaded;
}

template <SimulatorForm form>
ExportResult writeSimulatorModel(ExportContext& context, const OptionValues& given,
                                 const ExportTarget& target, const std::stop_token& stop) {
  const auto read = simulatorOptions(given);
  if (const auto* error = std::get_if<UsageError>(&read))
    return ExportError{ExportError::Kind::usage, error->message};
  if (target.path == "-") {
    return ExportError{ExportError::Kind::usage,
                       translated("A model for simulators is a folder; \"-\" is none.")};
  }
  const auto loaded = drivenTrain(context, given, stop);
  if (const auto* error = std::get_if<ExportError>(&loaded)) return *error;
  const auto& train = std::get<ExportTrain>(loaded);
  const auto& options = std::get<SimulatorOptions>(read);
  auto made = simulatorModel(*train.snapshot, train.train, options, stop);
  if (const auto* error = std::get_if<SimulatorError>(&made)) return simulatorErrorOf(*error);
  auto& model = std::get<SimulatorModel>(made);
  using Text = std::variant<std::string, SimulatorError>;
  Text text = form == SimulatorForm::mjcf ? Text(mjcfText(model, options)) : urdfText(model);
  if (const auto* error = std::get_if<SimulatorError>(&text)) return simulatorErrorOf(*error);
  FolderFiles files = std::move(model.meshes);
  files.emplace_back(context.stem() + (form == SimulatorForm::mjcf ? ".xml" : ".urdf"),
                     std::get<std::string>(std::move(text)));
  const auto error = writeFolder(target.path, files, {target.mayOverwrite, stop, target.progress});
  if (error) {
    return error->isStopped ? outOfTime(translated("the folder"))
                            : ExportError{ExportError::Kind::file, error->message};
  }
  for (const SimulatorNote& note : model.notes) context.tell(note.text);
  tellFreedom(context, train, given);
  return ExportOutcome{};
}

constexpr ExportOption kMeshTolerance =
    numberOption("--tolerance", kFinestTolerance, kCoarsestTolerance, "0.01", toTranslate("modules"));
constexpr std::array kUrdfOptions = {textOption("--gravity"), textOption("--density"), kMeshTolerance};
constexpr std::array kMjcfOptions = {textOption("--gravity"),
                                     textOption("--density"),
                                     choiceOption("--motor", namesOfMotors, "speed"),
                                     numberOption("--armature", 0, 1e9, {}, "kg m²"),
                                     numberOption("--timestep", 1e-6, 1, "0.001", "s"),
                                     kMeshTolerance};
constexpr std::array kSimulatorRefusals = {&kErrorsRefusal, &kGearsRefusal, &kNoSolutionRefusal,
                                           &kNotExpressible, &kTooLargeRefusal};
constexpr std::string_view kSimulatorModel = toTranslate("a model for simulators");

constexpr std::array kSimulatorExporters = {Exporter{"mjcf",
                                                     "mjcf",
                                                     "MuJoCo (MJCF)",
                                                     kSimulatorModel,
                                                     ExportFiles::folder,
                                                     {},
                                                     kMjcfOptions,
                                                     {},
                                                     ExportNeed::solution,
                                                     kSimulatorRefusals,
                                                     writeSimulatorModel<SimulatorForm::mjcf>},
                                            Exporter{"urdf",
                                                     "urdf",
                                                     "URDF",
                                                     kSimulatorModel,
                                                     ExportFiles::folder,
                                                     {},
                                                     kUrdfOptions,
                                                     {},
                                                     ExportNeed::solution,
                                                     kSimulatorRefusals,
                                                     writeSimulatorModel<SimulatorForm::urdf>}};

}  // namespace

ExportFamily simulatorFamily() {
  return {toTranslate("Simulators"), {}, {}, false, kSimulatorExporters, ExportPurpose::simulator, "png-3d"};
}

}  // namespace geargraph
