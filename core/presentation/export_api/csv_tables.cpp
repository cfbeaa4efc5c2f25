#include "core/presentation/export_api/csv_tables.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/matrix_csv.h"
#include "core/teaching/derivation/quantity_table.h"

namespace geargraph {
namespace {

/// The heading of a screw's row aligns its joint for the eye; a program wants one blank.
std::string labelOf(const Heading& heading) {
  std::string label;
  for (const char c : heading.text) {
    if (c != ' ' || (!label.empty() && label.back() != ' ')) label += c;
  }
  return label;
}

/// From the exact values where there are any: the decimals are the nearest ones.
QuantityTablePtr tableOf(const SnapshotPtr& snapshot, QuantityKind kind) {
  QuantityTablePtr table = quantityTable(snapshot, kind, EntryForm::fractions);
  return table ? table : quantityTable(snapshot, kind, EntryForm::decimals);
}

void writeQuantity(ByteSink& sink, const CsvOptions& options, const QuantityTable& table) {
  std::vector<std::string> columns;
  for (int column = 0; column < table.columns(); ++column)
    columns.push_back(labelOf(table.columnHeading(column)));
  CsvWriter csv(sink, columns, options);
  for (int row = 0; row < table.rows() && !csv.failed(); ++row) {
    const std::vector<QuantityEntry> entries = table.row(row);
    csv.sparseRow(labelOf(table.rowHeading(row)), std::span<const QuantityEntry>(entries));
  }
}

std::string_view needsOf(QuantityKind kind) {
  switch (kind) {
    case QuantityKind::solution:
      return toTranslate("a mechanism without errors, and at most 250,000 entries");
    case QuantityKind::ttCircuits:
    case QuantityKind::ttCutsets:
      return toTranslate("a carrier and a sign of every mesh");
    default:
      return toTranslate("a geometry of every mesh");
  }
}

constexpr std::string_view kStaticsMatrix = "statics";
constexpr std::string_view kCutsetEquations = "cutset-equations";

struct Sparse {
  int column = 0;
  double value = 0;
};

void writeTorqueMatrix(ByteSink& sink, const CsvOptions& options, const Mechanism& mechanism,
                       const StaticsReport& report) {
  const TorqueMatrix& matrix = *report.matrix;
  std::vector<std::string> columns;
  for (const JointOrdinal joint : matrix.loaded)
    columns.push_back(std::to_string(mechanism.jointLabel(joint)));
  CsvWriter csv(sink, columns, options);
  std::vector<double> values(matrix.loaded.size());
  for (std::size_t row = 0; row < report.balancedJoints.size() && !csv.failed(); ++row) {
    for (std::size_t column = 0; column < values.size(); ++column)
      values[column] = matrix.entries[row * values.size() + column].toDouble();
    csv.row(std::to_string(mechanism.jointLabel(report.balancedJoints[row])), values);
  }
}

void writeCutsets(ByteSink& sink, const CsvOptions& options, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const CutsetEquations cutsets(
      CoefficientMatrix(mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement()));
  std::vector<std::string> columns;
  for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh)
    columns.push_back(std::to_string(mechanism.meshLabel(mesh)));
  CsvWriter csv(sink, columns, options);
  std::vector<Sparse> entries;
  for (JointOrdinal joint = 0; joint < cutsets.count() && !csv.failed(); ++joint) {
    entries.clear();
    for (const CutsetEquations::Term& term : cutsets.terms(joint))
      entries.push_back({term.mesh, term.length});
    csv.sparseRow(std::to_string(mechanism.jointLabel(joint)), std::span<const Sparse>(entries));
  }
}

void addStaticsTables(const SnapshotPtr& snapshot, const SolvedStaticsPtr& statics,
                      std::vector<CsvTable>& tables) {
  CsvTable& matrix = tables.emplace_back(
      CsvTable{kStaticsMatrix,
               toTranslate("balances in joints that hold all loads, and at most 250,000 entries"),
               {}});
  matrix.ofLoads = true;
  if (statics && statics->report && statics->report->matrix)
    matrix.write = [statics](ByteSink& sink, const CsvOptions& options) {
      writeTorqueMatrix(sink, options, *statics->snapshot->mechanism, *statics->report);
    };
  CsvTable& cutsets =
      tables.emplace_back(CsvTable{kCutsetEquations, toTranslate("a geometry of every mesh"), {}});
  if (snapshot->matroid() != nullptr)
    cutsets.write = [snapshot](ByteSink& sink, const CsvOptions& options) {
      writeCutsets(sink, options, *snapshot);
    };
  const bool isHeld =
      statics && statics->report && statics->report->isAnswered() && statics->report->problem.hasLoads();
  for (const ForceTableKind kind : allForceTableKinds()) {
    CsvTable& table = tables.emplace_back(
        CsvTable{forceTableCommandName(kind), toTranslate("loads, and balances that hold them"), {}});
    table.ofLoads = true;
    if (!isHeld) continue;
    table.write = [statics, kind](ByteSink& sink, const CsvOptions& options) {
      const AnalysisSnapshot& solved = *statics->snapshot;
      writeForceCsv(sink,
                    forceTable(*solved.mechanism, *solved.kinematics->model, solved.kinematics->placement(),
                               *statics->report, kind),
                    options);
    };
  }
  CsvTable& shift = tables.emplace_back(
      CsvTable{forceTableCommandName(ForceTableKind::states), toTranslate("states of a gearbox"), {}});
  shift.ofLoads = true;
  if (statics && !statics->states.empty())
    shift.write = [statics](ByteSink& sink, const CsvOptions& options) {
      writeForceCsv(sink, shiftTable(*statics->snapshot->mechanism, statics->states), options);
    };
}

}  // namespace

bool isOfStatics(std::string_view name) {
  if (name == kStaticsMatrix || isOfAllStates(name)) return true;
  const auto& kinds = allForceTableKinds();
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](ForceTableKind kind) { return forceTableCommandName(kind) == name; });
}

bool isOfAllStates(std::string_view name) {
  return name == forceTableCommandName(ForceTableKind::states);
}

std::vector<std::string> csvTableNames() {
  std::vector<std::string> names;
  for (const MatrixKind kind : allMatrixKinds()) names.emplace_back(matrixCommandName(kind));
  for (const QuantityKind kind : allQuantityKinds()) names.emplace_back(quantityCommandName(kind));
  for (const std::string_view name : {kStaticsMatrix, kCutsetEquations}) names.emplace_back(name);
  for (const ForceTableKind kind : allForceTableKinds()) names.emplace_back(forceTableCommandName(kind));
  names.emplace_back(forceTableCommandName(ForceTableKind::states));
  return names;
}

std::vector<CsvTable> csvTables(const SnapshotPtr& snapshot, const SolvedStaticsPtr& statics) {
  std::vector<CsvTable> tables;
  for (const MatrixKind kind : allMatrixKinds()) {
    CsvTable& table =
        tables.emplace_back(CsvTable{matrixCommandName(kind), toTranslate("a spanning tree"), {}});
    if (const IntegerMatrixPtr matrix = snapshot->matrix(kind)) {
      table.write = [matrix](ByteSink& sink, const CsvOptions& options) {
        writeMatrixCsv<MatrixEntry, UniformRow>(sink, *matrix, options);
      };
    }
  }
  for (const QuantityKind kind : allQuantityKinds()) {
    CsvTable& quantity = tables.emplace_back(CsvTable{quantityCommandName(kind), needsOf(kind), {}});
    if (const QuantityTablePtr table = tableOf(snapshot, kind)) {
      quantity.write = [table](ByteSink& sink, const CsvOptions& options) {
        writeQuantity(sink, options, *table);
      };
    }
  }
  addStaticsTables(snapshot, statics, tables);
  return tables;
}

}  // namespace geargraph
