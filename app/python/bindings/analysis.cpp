#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/python/bindings/snapshot.h"
#include "core/design/collision/motion_diagnostics.h"
#include "core/presentation/export_api/input_pose.h"
#include "core/presentation/result_json/analysis_json.h"
#include "core/presentation/result_json/lost_motion_report.h"
#include "core/presentation/result_json/states_json.h"
#include "core/presentation/result_json/vibration_report.h"
#include "core/teaching/derivation/named_results.h"
#include "core/theory/matroid/input_sets.h"

namespace geargraph::python {

Snapshot::Snapshot(const Document& document, bool symbolic)
    : m_options{symbolic}, m_live(interruptible([&](const std::stop_token& stop) {
        return analyzeLive(document.geometry(), 0, stop);
      })) {}

template <class Make>
SnapshotPtr Snapshot::kept(SnapshotPtr& place, const Make& make) {
  {
    const std::lock_guard lock(m_mutex);
    if (place) return place;
  }
  SnapshotPtr made = interruptible(make);
  const std::lock_guard lock(m_mutex);
  if (!place) place = std::move(made);
  return place;
}

SnapshotPtr Snapshot::solved() {
  return kept(m_solved, [&](const std::stop_token& stop) -> SnapshotPtr {
    const MatroidAnalysis* matroid = m_live->matroid();
    if (matroid == nullptr || !matroid->solution || hasErrors(m_live->diagnostics)) return m_live;
    auto snapshot = std::make_shared<AnalysisSnapshot>(*m_live);
    snapshot->solved = solvedKinematics(mechanism(), *m_live->kinematics, m_options, stop);
    if (!snapshot->solved) return nullptr;
    append(snapshot->diagnostics, snapshot->solved->diagnostics);
    return snapshot;
  });
}

SnapshotPtr Snapshot::shifted() {
  return kept(m_shifted, [&](const std::stop_token& stop) { return analyzeStates(m_live, m_options, stop); });
}

SnapshotPtr Snapshot::full() {
  return kept(m_full, [&](const std::stop_token& stop) { return analyzeFully(m_live, m_options, stop); });
}

void Snapshot::raiseUndefined(const std::string& what) const {
  Diagnostics errors;
  for (const Diagnostic& diagnostic : m_live->diagnostics) {
    if (diagnostic.severity() == Severity::error) errors.push_back(diagnostic);
  }
  if (!errors.empty()) raise(errors);
  raise("undefined", what);
}

const MatroidAnalysis& Snapshot::matroid(bool needsSolution) const {
  const MatroidAnalysis* found = m_live->matroid();
  if (found == nullptr || (needsSolution && (!found->solution || hasErrors(m_live->diagnostics))))
    raiseUndefined("The mechanism leaves nothing to solve.");
  return *found;
}

py::tuple RawMatrix::heading(const Heading& heading, bool hasElement) {
  return py::make_tuple(heading.label, heading.text, hasElement ? kindName(heading.element.kind) : "",
                        hasElement ? heading.element.id.text() : std::string());
}

namespace {

template <class Table>
RawMatrix headed(const Table& table) {
  RawMatrix raw;
  const auto add = [](py::list& list, const Heading& heading) {
    list.append(RawMatrix::heading(heading, !heading.element.id.empty()));
  };
  for (int row = 0; row < table.rows(); ++row) add(raw.rows, table.rowHeading(row));
  for (int column = 0; column < table.columns(); ++column) add(raw.columns, table.columnHeading(column));
  raw.partition = table.partition();
  return raw;
}

const NamedResult& resultOfName(const std::string& name) {
  const NamedResult* result = resultNamed(name);
  if (result == nullptr) throw py::value_error("There is no result \"" + name + "\".");
  return *result;
}

/// By result of the catalogue: its name, and whether it is a matrix of the digraph, a quantity or a table.
py::list rowsOfResults() {
  py::list list;
  for (const NamedResult* result : namedResults()) {
    const bool isOfLoads = result->of == ResultOf::loads || result->of == ResultOf::states;
    const char* kind = result->of == ResultOf::graph ? "matrix" : isOfLoads ? "table" : "quantity";
    list.append(py::make_tuple(result->name, kind));
  }
  return list;
}

py::object integerMatrix(const Snapshot& self, const std::string& name) {
  const NamedResult& result = resultOfName(name);
  const ResultTablePtr table = exactTable(result, {self.live()});
  if (!table) self.raiseUndefined("The matrix needs " + std::string(result.needs) + ".");
  RawMatrix raw = headed(*table);
  std::vector<std::int8_t> values;
  std::vector<MatrixEntry> entries;
  const IntegerMatrixPtr matrix = table->integers();
  for (int row = 0; row < matrix->rows(); ++row) {
    matrix->rowEntries(row, entries);
    for (const MatrixEntry& entry : entries) {
      raw.rowOf.push_back(row);
      raw.columnOf.push_back(entry.column);
      values.push_back(static_cast<std::int8_t>(entry.value));
    }
  }
  return py::make_tuple(result.symbol, result.title, numberOf(result.equation(table->form())), raw.rows,
                        raw.columns, raw.partition, packed(raw.rowOf), packed(raw.columnOf), packed(values));
}

/// None where the quantity does not have the form. Whole numbers are decimals, too.
py::object quantity(Snapshot& self, const std::string& name, const std::string& formName) {
  const NamedResult& result = resultOfName(name);
  EntryForm form = formName == "decimals"    ? EntryForm::decimals
                   : formName == "fractions" ? EntryForm::fractions
                                             : EntryForm::symbols;
  if (result.forms({self.live()}).empty())
    self.raiseUndefined(result.isWhole ? "A mesh has no carrier." : "A mesh has no geometry.");
  if (result.isWhole && form == EntryForm::decimals) form = EntryForm::fractions;
  const bool isSolved = result.of == ResultOf::solution && form != EntryForm::decimals;
  const ResultTablePtr table = resultTable(result, {isSolved ? self.solved() : self.live()}, form);
  if (!table) return py::none();
  RawMatrix raw = headed(*table);
  std::vector<double> values;
  py::list texts, latex;
  for (int row = 0; row < table->rows(); ++row) {
    for (const ResultEntry& entry : table->row(row)) {
      raw.rowOf.push_back(row);
      raw.columnOf.push_back(entry.column);
      values.push_back(entry.value);
      texts.append(entry.text);
      latex.append(entry.latex);
    }
  }
  return py::make_tuple(result.symbol, result.title, numberOf(result.equation(form)), raw.rows, raw.columns,
                        raw.partition, packed(raw.rowOf), packed(raw.columnOf), packed(values), texts, latex);
}

py::tuple inputSets(const Snapshot& self, std::size_t limit) {
  const MatroidAnalysis& matroid = self.matroid(false);
  struct Sets {
    bool areFound = false;
    std::optional<Rational> count;
    std::vector<std::vector<int>> lists;
  };
  Sets sets = interruptible([&](const std::stop_token& stop) {
    const auto found =
        InputSets::of(*self.live()->kinematics->model, ModularDoubleField(), matroid.choice.joints, stop);
    if (!found) return Sets{};
    return Sets{true, found->count(stop), found->list(limit, stop)};
  });
  if (!sets.areFound) raise("limit", "There are over 20 million rates of joints over inputs.");
  for (std::vector<int>& set : sets.lists) {
    for (int& joint : set) joint = self.live()->graph->edgeLabel(joint);
  }
  return py::make_tuple(sets.count ? py::object(py::str(sets.count->toString())) : py::none(), sets.lists);
}

/// `degrees`, `radians`: a text for each input.
py::tuple pose(const Snapshot& self, const std::vector<NumberText>& degrees,
               const std::vector<NumberText>& radians) {
  const std::size_t inputs = self.matroid(true).choice.joints.size();
  if (degrees.size() != inputs || radians.size() != inputs)
    throw py::value_error("An angle for each input is needed.");
  InputAngles angles;
  for (const NumberText& text : degrees) angles.degrees.push_back(rationalFrom(text));
  for (const NumberText& text : radians) angles.radians.push_back(rationalFrom(text));
  const auto found =
      interruptible([&](const std::stop_token& stop) { return poseOfInputs(*self.live(), angles, stop); });
  std::vector<double> matrices;
  for (const Eigen::Isometry3d& link : found->links) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) matrices.push_back(link.matrix()(row, column));
    }
  }
  return py::make_tuple(packed(found->angles), packed(matrices), found->beyondLimits);
}

py::object motion(const Snapshot& self) {
  const auto report =
      interruptible([&](const std::stop_token& stop) { return checkMotion(*self.live(), stop); });
  if (!report) return py::none();
  return py::make_tuple(report->check.from, report->check.to, report->check.coversAll,
                        report->check.isComplete, rowsOf(report->diagnostics));
}

std::string vibrationRows(const Snapshot& self, std::optional<double> rpm, std::optional<int> label,
                          int harmonics, int sidebands, int planets) {
  using Bounds = FrequencyOptions;
  const auto within = [](int value, int least, int most, const char* what) {
    if (value < least || value > most) throw py::value_error(what);
  };
  within(harmonics, 1, Bounds::kMaxHarmonics, "There are 1 to 20 harmonics.");
  within(sidebands, 0, Bounds::kMaxSidebands, "There are 0 to 20 sidebands.");
  within(planets, 1, Bounds::kMaxPlanets, "There are 1 to 100 planets.");
  if (rpm && !(*rpm > 0 && std::isfinite(*rpm))) throw py::value_error("A speed in rpm is above 0.");
  VibrationOptions options{{harmonics, sidebands, planets}, {}, rpm};
  const Mechanism& mechanism = *self.live()->mechanism;
  if (label) {
    const int joint = *label - mechanism.jointLabel(0);
    if (*label >= 1 && *label <= mechanism.n()) {
      options.reference = LinkOrdinal(*label);
    } else if (joint >= 0 && joint < mechanism.t()) {
      options.reference = JointOrdinal(joint);
    } else {
      raise("unknown-id", "There is no joint or moving link with this label.");
    }
  }
  const auto cases =
      interruptible([&](const std::stop_token& stop) { return frequencyCases(*self.live(), options, stop); });
  return vibrationJson(&mechanism, &*cases, options);
}

std::string backlashRows(const Snapshot& self) {
  const AnalysisSnapshot& snapshot = *self.live();
  const Mechanism& mechanism = *snapshot.mechanism;
  const auto cases = interruptible([&](const std::stop_token& stop) {
    if (!mechanism.states.empty() && mechanism.engaged.empty()) return lostMotionCases(mechanism, stop);
    auto one = lostMotionCase(snapshot, stop);
    return one ? std::optional(std::vector<LostMotionCase>{*std::move(one)}) : std::nullopt;
  });
  return lostMotionJson(&mechanism, *cases);
}

}  // namespace

void addAnalysis(py::module_& module) {
  module.def("results", rowsOfResults);
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module, "Snapshot")
      .def(py::init<const Document&, bool>())
      .def("rank", [](const Snapshot& self) { return self.matroid(false).rank; })
      .def("dof", [](const Snapshot& self) { return self.matroid(false).dof; })
      .def("inputs", [](const Snapshot& self) { return self.matroid(false).choice.joints; })
      .def("rates", [](const Snapshot& self) { return packed(self.matroid(true).solution->rates); })
      .def("live_findings", [](const Snapshot& self) { return rowsOf(self.live()->diagnostics); })
      .def("findings", [](Snapshot& self) { return rowsOf(self.full()->diagnostics); })
      .def("json",
           [](Snapshot& self) {
             const SnapshotPtr snapshot = self.solved();
             TextSink sink;
             writeAnalysisJson(sink, snapshot, snapshot->diagnostics, {.matrices = false});
             return sink.take();
           })
      .def("states_json", [](Snapshot& self) { return statesJson(self.shifted().get()); })
      .def("vibration_json", vibrationRows)
      .def("backlash_json", backlashRows)
      .def("matrix", integerMatrix)
      .def("quantity", quantity)
      .def("input_sets", inputSets)
      .def("pose", pose)
      .def("motion", motion);
}

}  // namespace geargraph::python
