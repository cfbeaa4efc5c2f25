// Models for simulators of rigid bodies.

#include "app/python/bindings/snapshot.h"
#include "core/foundations/files/folder.h"
#include "core/presentation/export_api/train_export.h"
#include "core/presentation/simulators/simulator_model.h"

namespace geargraph::python {
namespace {

struct ModelChoice {
  std::string form;
  std::string motor;
  double timestep = 0;
  std::optional<double> armature;
  double tolerance = 0;
};

SimulatorOptions optionsFrom(const ModelChoice& choice) {
  SimulatorOptions options;
  if (choice.form != "mjcf" && choice.form != "urdf")
    throw py::value_error("A model is written as mjcf or urdf, not \"" + choice.form + "\".");
  if (choice.motor == "torque") {
    options.motor = SimulatorMotor::torque;
  } else if (choice.motor == "none") {
    options.motor = SimulatorMotor::none;
  } else if (choice.motor != "speed") {
    throw py::value_error("A motor is speed, torque or none, not \"" + choice.motor + "\".");
  }
  if (!(choice.timestep >= 1e-6 && choice.timestep <= 1))
    throw py::value_error("A timestep is 1e-6 to 1 second.");
  if (choice.armature && !(*choice.armature >= 0 && *choice.armature <= 1e9))
    throw py::value_error("The inertia of rotors is 0 to 1e9 kg m².");
  if (!(choice.tolerance >= kFinestTolerance && choice.tolerance <= kCoarsestTolerance))
    throw py::value_error("A tolerance is 0.0001 to 0.2 modules.");
  options.timestep = choice.timestep;
  options.armature = choice.armature;
  options.tolerance = choice.tolerance;
  return options;
}

[[noreturn]] void raiseFailure(const SimulatorError& error) {
  raise(error.kind == SimulatorError::Kind::limit ? "limit" : "undefined", error.message);
}

/// Writes the model into a folder, its file under this name; what a reader of the file has to know.
std::vector<std::string> writeModel(const Snapshot& self, const std::string& folder, const std::string& name,
                                    const ModelChoice& choice, bool overwrite) {
  const SimulatorOptions options = optionsFrom(choice);
  const MatroidAnalysis& matroid = self.matroid(true);
  if (matroid.solution->inputs.size() * matroid.solution->outputs.size() > ExactSolution::kMaxExactEntries)
    raise("limit", "The mechanism is too large for simulators.");
  auto made = interruptible([&](const std::stop_token& stop) -> std::variant<SimulatorModel, SimulatorError> {
    const auto train = self.live()->geometry->train(stop);
    if (!train) return SimulatorError{SimulatorError::Kind::stopped, {}};
    return simulatorModel(*self.live(), *train, options, stop);
  });
  if (const auto* error = std::get_if<SimulatorError>(&made)) raiseFailure(*error);
  auto& model = std::get<SimulatorModel>(made);
  auto text = choice.form == "mjcf" ? std::variant<std::string, SimulatorError>(mjcfText(model, options))
                                    : urdfText(model);
  if (const auto* error = std::get_if<SimulatorError>(&text)) raiseFailure(*error);
  FolderFiles files = std::move(model.meshes);
  files.emplace_back(name + (choice.form == "mjcf" ? ".xml" : ".urdf"),
                     std::get<std::string>(std::move(text)));
  const auto error = interruptible([&](const std::stop_token& stop) {
    return writeFolder(folder, files, {overwrite, stop, {}});
  });
  if (error) raise("file", error->message);
  std::vector<std::string> notes;
  for (const SimulatorNote& note : model.notes) notes.push_back(note.text);
  return notes;
}

}  // namespace

void addSimulators(py::module_& module) {
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot"))
      .def("write_model", [](const Snapshot& self, const std::string& folder, const std::string& name,
                             const std::string& form, const std::string& motor, double timestep,
                             std::optional<double> armature, double tolerance, bool overwrite) {
        return writeModel(self, folder, name, {form, motor, timestep, armature, tolerance}, overwrite);
      });
}

}  // namespace geargraph::python
