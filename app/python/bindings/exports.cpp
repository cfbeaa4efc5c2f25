// Files for other programs, and the gears as arrays.

#include <algorithm>
#include <filesystem>

#include "app/python/bindings/snapshot.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/stoppable_sink.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/export_api/graph_files.h"
#include "core/presentation/export_api/report_lists.h"
#include "core/presentation/export_api/train_export.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "core/teaching/derivation/solved_statics.h"

namespace geargraph::python {
namespace {

[[noreturn]] void raiseFailure(const Snapshot& self, const ExportFailure& why) {
  using Kind = ExportFailure::Kind;
  if (!why.diagnostics.empty()) raise(why.diagnostics);
  if (why.kind == Kind::choice) throw py::value_error(why.message + ".");
  if (why.kind == Kind::mechanism) self.raiseUndefined(why.message + ".");
  raise("limit", why.message + (why.kind == Kind::triangles ? "; choose a coarser tolerance." : "."));
}

template <class Value>
Value madeOrRaise(const Snapshot& self, std::variant<Value, ExportFailure>&& made) {
  if (const auto* why = std::get_if<ExportFailure>(&made)) raiseFailure(self, *why);
  return std::get<Value>(std::move(made));
}

ExportTrain trainOf(const Snapshot& self) {
  return madeOrRaise(
      self, interruptible([&](const std::stop_token& stop) { return exportTrain(self.live(), stop); }));
}

double checked(double tolerance) {
  if (tolerance >= kFinestTolerance && tolerance <= kCoarsestTolerance) return tolerance;
  throw py::value_error("A tolerance is 0.0001 to 0.2 modules.");
}

void raiseIf(const std::optional<MeshFileError>& error) {
  if (error) raise(error->kind == MeshFileError::Kind::limit ? "limit" : "file", error->message);
}

/// Writes gears; the tolerance taken in modules, how many gears were left out, why nothing moves.
py::tuple writeSolids(const Snapshot& self, const std::string& path, const std::string& form,
                      const std::optional<std::string>& gear, const std::optional<std::string>& link,
                      double seconds, std::optional<double> tolerance) {
  const auto format = meshFormatFromName(form);
  if (!format)
    throw py::value_error("Solids are written as stl, obj, ply, glb or 3mf, not \"" + form + "\".");
  if (tolerance) (void)checked(*tolerance);
  if (seconds != 0 && !(seconds >= kShortestAnimation && seconds <= kMaxAnimation))
    throw py::value_error("An animation plays 0.001 to 1,000,000 seconds.");
  const ExportTrain train = trainOf(self);
  const SolidsChoice choice{tolerance, link, carriesAnimation(*format), seconds};
  TrainSolids solids;
  if (gear) {
    solids.tolerance = tolerance.value_or(kExportTolerance);
    solids.scene = madeOrRaise(self, interruptible([&](const std::stop_token& /*stop*/) {
                                 return gearScene(train, *gear, solids.tolerance);
                               }));
  } else {
    solids = madeOrRaise(
        self, interruptible([&](const std::stop_token& stop) { return trainSolids(train, choice, stop); }));
  }
  raiseIf(interruptible([&](const std::stop_token& stop) {
    MeshWriteOptions options;
    options.stop = stop;
    return writeMesh(solids.scene, *format, path, options);
  }));
  return py::make_tuple(solids.tolerance, rowsOf(solids.left), solids.shows);
}

void writeAssemblyFolder(const Snapshot& self, const std::string& folder, std::size_t frames,
                         double tolerance, bool overwrite) {
  if (frames < kMinFrames || frames > kMaxAssemblyFrames)
    throw py::value_error("An assembly has 12 to 10,000 frames.");
  const ExportTrain train = trainOf(self);
  const Assembly assembly = madeOrRaise(self, interruptible([&](const std::stop_token& stop) {
                                          return trainAssembly(train, checked(tolerance), frames, stop);
                                        }));
  raiseIf(interruptible([&](const std::stop_token& stop) {
    MeshWriteOptions options;
    options.stop = stop;
    return geargraph::writeAssembly(assembly, folder, overwrite, options);
  }));
}

std::vector<double> numbersOf(const Eigen::Isometry3d& pose) {
  std::vector<double> numbers;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  }
  return numbers;
}

py::tuple arraysOf(const Solid& solid) {
  return py::make_tuple(packed(solid.positions), packed(solid.normals), packed(solid.triangles));
}

/// By gear: its name, link, meshes, spec and pose.
py::list gears(const Snapshot& self) {
  const ExportTrain train = trainOf(self);
  py::list list;
  for (const TrainGear& gear : train.train.gears) {
    const GearSpec& spec = gear.spec;
    py::dict values;
    values["kind"] = gearKindName(spec.kind);
    values["teeth"] = spec.teeth;
    values["module"] = spec.module;
    values["pressure_angle"] = spec.pressureAngle;
    values["profile_shift"] = spec.profileShift;
    values["thinning"] = spec.backlashAllowance;
    values["cone_angle"] = spec.coneAngle;
    values["helix_angle"] = spec.helixAngle;
    values["face_width"] = spec.faceWidth;
    values["bore"] = spec.bore;
    values["pitch_radius"] = pitchRadius(spec);
    values["tip_radius"] = nominalTipRadius(spec);
    values["root_radius"] = nominalRootRadius(spec);
    list.append(py::make_tuple(gear.name, gear.link, gear.meshes, values, packed(numbersOf(gear.pose))));
  }
  return list;
}

py::tuple gearArrays(const Snapshot& self, const std::string& name, double tolerance) {
  const MeshScene scene = madeOrRaise(self, [&] {
    const ExportTrain train = trainOf(self);
    return interruptible(
        [&](const std::stop_token& /*stop*/) { return gearScene(train, name, checked(tolerance)); });
  }());
  return arraysOf(*scene.nodes.front().solid);
}

/// By solid of the train: its name, the position of its link, its pose and its arrays.
py::list parts(const Snapshot& self, double tolerance) {
  const ExportTrain train = trainOf(self);
  const TrainParts made = interruptible([&](const std::stop_token& stop) {
    GearCache cache;
    return trainParts(train.mechanism(), train.train, cache, checked(tolerance), stop);
  });
  py::list list;
  for (const LinkPart& part : made.parts) {
    list.append(py::make_tuple(part.name, part.link, part.gear >= 0, packed(numbersOf(part.pose)),
                               arraysOf(*part.solid)));
  }
  return list;
}

py::bytes report(Snapshot& self, const std::string& form) {
  if (self.mechanism().n() > kMaxReportLinks)
    raise("limit", "A derivation is written of at most " + std::to_string(kMaxReportLinks) + " links.");
  const SnapshotPtr snapshot = self.full();
  return bytesOf(valueOrRaise(interruptible([&](const std::stop_token& stop) -> Expected<std::string> {
    Report made = derivationReport(snapshot, stop);
    if (form == "pdf") return reportPdf(std::move(made), reportLists(*snapshot, stop));
    return reportText(made, *reportFormFromName(form), [&] { return reportLists(*snapshot, stop); });
  })));
}

/// The names of the tables that the mechanism has, or one of them written to a file ("" gives its text).
py::dict csv(Snapshot& self, const std::optional<std::string>& name, char separator, char decimal,
             bool labels) {
  const SnapshotPtr snapshot = self.solved();
  std::vector<std::pair<std::string, std::string>> texts;
  runInterruptible([&](const std::stop_token& stop) {
    const ResultSource source{snapshot, solvedStatics(snapshot, {}, true, stop)};
    for (const NamedResult* result : namedResults()) {
      const ResultTablePtr table = name && result->name != *name ? nullptr : exactTable(*result, source);
      if (!table) continue;
      TextSink text;
      StoppableSink sink(text, stop);
      writeResultCsv(sink, *table, {separator, decimal, labels, false});
      texts.emplace_back(result->name, text.take());
    }
  });
  py::dict tables;
  for (const auto& [title, text] : texts) tables[py::str(title)] = text;
  return tables;
}

std::string graphText(const Snapshot& self, const std::string& name, const std::string& formName) {
  const auto form = graphFormFromName(formName);
  if (!form) throw py::value_error("A graph is written as dot, graphml or node-link.");
  if (name == "digraph") return digraphFile(self.mechanism(), *form);
  if (name != "ttgraph") throw py::value_error("A graph is the digraph or the ttgraph.");
  const auto text = ttGraphFile(*self.live(), *form);
  if (!text) self.raiseUndefined("A mesh has no carrier.");
  return *text;
}

}  // namespace

void addExports(py::module_& module) {
  module.def("write_file", [](const std::string& path, const py::bytes& bytes) {
    if (const auto error = writeFile(path, std::string_view(bytes))) raise("file", error->message);
  });
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot"))
      .def("write_solids", writeSolids)
      .def("write_assembly", writeAssemblyFolder)
      .def("gears", gears)
      .def("gear_arrays", gearArrays)
      .def("parts", parts)
      .def("report", report)
      .def("csv", csv)
      .def("graph", graphText);
}

}  // namespace geargraph::python
