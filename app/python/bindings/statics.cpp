#include "app/python/bindings/snapshot.h"
#include "core/presentation/result_json/statics_json.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::python {
namespace {

struct StaticsChoice {
  std::optional<std::string> state;
  bool losses = false;
  std::optional<NumberText> efficiency;
  bool stiffness = false;
  bool symbolic = true;
};

/// The position of the state, -1 for none.
int statePosition(const Mechanism& mechanism, const std::optional<std::string>& name) {
  if (!name) return -1;
  for (std::size_t i = 0; i < mechanism.states.size(); ++i) {
    if (mechanism.states[i].name == *name) return static_cast<int>(i);
  }
  raise(Diagnostics{{Code::unknownId,
                     "There is no state \"" + *name + "\".",
                     {ElementId(ElementKind::state, InternedString(*name))},
                     {}}});
}

/// A state brings its own couplings: the analysis is of the train with the document's released.
SnapshotPtr analysedFor(const Snapshot& self, int state) {
  if (state < 0 || self.mechanism().engaged.empty()) return self.live();
  Mechanism released = self.mechanism();
  released.engaged.clear();
  return interruptible([&](const std::stop_token& stop) {
    return analyzeLive(std::make_shared<const Mechanism>(std::move(released)), 0, stop);
  });
}

std::string staticsJson(const Snapshot& self, const StaticsChoice& choice) {
  StaticsOptions options;
  options.state = statePosition(self.mechanism(), choice.state);
  options.losses = choice.losses || choice.efficiency;
  if (choice.efficiency) {
    options.efficiency = rationalFrom(*choice.efficiency);
    if (options.efficiency->sign() <= 0 || *options.efficiency > Rational(1))
      throw py::value_error("An efficiency is above 0 and at most 1.");
  }
  if (choice.stiffness) options.sharing = LoadSharing::stiffness;
  options.symbolic = choice.symbolic;
  const SnapshotPtr snapshot = analysedFor(self, options.state);
  Diagnostics diagnostics, errors;
  for (const Diagnostic& diagnostic : snapshot->diagnostics) {
    if (options.state >= 0 && diagnostic.code == Code::invalidInputs) continue;  // a state drives by itself
    diagnostics.push_back(diagnostic);
    if (diagnostic.severity() == Severity::error) errors.push_back(diagnostic);
  }
  if (!errors.empty()) raise(errors);
  if (snapshot->matroid() == nullptr) self.raiseUndefined("A mesh has no geometry.");
  const auto report = interruptible([&](const std::stop_token& stop) {
    return analyzeStatics(*snapshot->mechanism, *snapshot->kinematics->model,
                          snapshot->kinematics->placement(), *snapshot->kinematics->ttGraph,
                          *snapshot->matroid(), options, stop);
  });
  append(diagnostics, report->diagnostics);
  TextSink sink;
  {
    JsonWriter json(sink);
    writeStaticsJson(json, snapshot.get(), &*report, options.state, diagnostics);
  }
  return sink.take();
}

}  // namespace

void addStatics(py::module_& module) {
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot"))
      .def("statics_json", [](const Snapshot& self, const std::optional<std::string>& state, bool losses,
                              const std::optional<NumberText>& efficiency, bool stiffness, bool symbolic) {
        return staticsJson(self, {state, losses, efficiency, stiffness, symbolic});
      });
}

}  // namespace geargraph::python
