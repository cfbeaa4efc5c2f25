#include "app/cli/csv_tables.h"

#include "core/io/matrix_csv.h"
#include "core/screws/screw.h"

namespace geargraph::cli {
namespace {

std::vector<std::string> labelsOf(const Digraph& graph, std::span<const int> joints) {
  std::vector<std::string> labels;
  labels.reserve(joints.size());
  for (const int joint : joints) labels.push_back(std::to_string(graph.edgeLabel(joint)));
  return labels;
}

std::string cycleLabel(const Digraph& graph, int mesh) {
  return "C" + std::to_string(graph.edgeLabel(graph.t() + mesh));
}

void writeScrews(ByteSink& sink, const CsvOptions& options, const AnalysisSnapshot& snapshot) {
  const Placement& placement = snapshot.kinematics->placement;
  const Digraph& graph = *snapshot.graph;
  const IntegerMatrix& cycles = *snapshot.matrix(MatrixKind::spanningTree);
  const std::vector<std::string> columns = {"L", "M", "N", "P", "Q", "R"};
  CsvWriter csv(sink, columns, options);
  std::vector<MatrixEntry> entries;
  for (int mesh = 0; mesh < graph.c(); ++mesh) {
    cycles.rowEntries(mesh, entries);
    for (const MatrixEntry& entry : entries) {
      const auto joint = static_cast<std::size_t>(entry.column);
      const AxisLine& line = placement.lineOfClass(placement.classes->classOf[joint]);
      const double sense = placement.classes->sense[joint];
      const auto screw = screwAbout(placement.meshes[static_cast<std::size_t>(mesh)]->pitchPoint, line.point,
                                    sense * line.direction);
      std::vector<double> values(screw.direction.begin(), screw.direction.end());
      values.insert(values.end(), screw.moment.begin(), screw.moment.end());
      for (double& value : values) value += 0.0;  // no -0
      csv.row(cycleLabel(graph, mesh) + " " + std::to_string(graph.edgeLabel(entry.column)), values);
    }
  }
}

void writeCoefficients(ByteSink& sink, const CsvOptions& options, const AnalysisSnapshot& snapshot) {
  const Digraph& graph = *snapshot.graph;
  const CoefficientMatrix matrix(*snapshot.mechanism, *snapshot.kinematics->model,
                                 snapshot.kinematics->placement);
  std::vector<int> joints;
  for (int joint = 0; joint < graph.t(); ++joint) joints.push_back(joint);
  CsvWriter csv(sink, labelsOf(graph, joints), options);
  for (int mesh = 0; mesh < graph.c(); ++mesh) {
    std::vector<double> values(static_cast<std::size_t>(graph.t()), 0);
    for (const auto& entry : matrix.row(mesh)) values[static_cast<std::size_t>(entry.joint)] = entry.length;
    csv.row(cycleLabel(graph, mesh), values);
  }
}

void writeSolution(ByteSink& sink, const CsvOptions& options, const AnalysisSnapshot& snapshot) {
  const ExactSolution& exact = *snapshot.solved->exact;
  CsvWriter csv(sink, labelsOf(*snapshot.graph, exact.inputs), options);
  const std::size_t columns = exact.inputs.size();
  for (std::size_t row = 0; row < exact.outputs.size(); ++row) {
    std::vector<double> values;
    for (std::size_t column = 0; column < columns; ++column) {
      values.push_back(exact.matrix[row * columns + column].toDouble());
    }
    csv.row(std::to_string(snapshot.graph->edgeLabel(exact.outputs[row])), values);
  }
}

bool hasSolutionMatrix(const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved || !snapshot.solved->exact) return false;
  const ExactSolution& exact = *snapshot.solved->exact;
  return exact.matrix.size() == exact.inputs.size() * exact.outputs.size();
}

}  // namespace

std::vector<CsvTable> csvTables(const SnapshotPtr& snapshot) {
  std::vector<CsvTable> tables;
  for (const MatrixKind kind : allMatrixKinds()) {
    CsvTable& table = tables.emplace_back(CsvTable{matrixCommandName(kind), "a spanning tree", {}});
    if (const IntegerMatrixPtr matrix = snapshot->matrix(kind)) {
      table.write = [matrix](ByteSink& sink, const CsvOptions& options) {
        writeMatrixCsv<MatrixEntry, UniformRow>(sink, *matrix, options);
      };
    }
  }
  const bool hasModel = snapshot->kinematics && snapshot->kinematics->model;
  const auto add = [&](std::string_view name, std::string_view needs, bool isDefined,
                       void (*write)(ByteSink&, const CsvOptions&, const AnalysisSnapshot&)) {
    CsvTable& table = tables.emplace_back(CsvTable{name, needs, {}});
    if (!isDefined) return;
    table.write = [snapshot, write](ByteSink& sink, const CsvOptions& options) {
      write(sink, options, *snapshot);
    };
  };
  add("screw", "a geometry of every mesh", hasModel, writeScrews);
  add("p", "a geometry of every mesh", hasModel, writeCoefficients);
  add("solution", "a mechanism without errors, and at most 250,000 entries", hasSolutionMatrix(*snapshot),
      writeSolution);
  return tables;
}

}  // namespace geargraph::cli
