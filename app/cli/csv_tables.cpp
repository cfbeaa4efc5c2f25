#include "app/cli/csv_tables.h"

#include "core/foundations/files/matrix_csv.h"
#include "core/teaching/derivation/quantity_table.h"

namespace geargraph::cli {
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
  return kind == QuantityKind::solution ? "a mechanism without errors, and at most 250,000 entries"
                                        : "a geometry of every mesh";
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
  for (const QuantityKind kind : allQuantityKinds()) {
    CsvTable& quantity = tables.emplace_back(CsvTable{quantityCommandName(kind), needsOf(kind), {}});
    if (const QuantityTablePtr table = tableOf(snapshot, kind)) {
      quantity.write = [table](ByteSink& sink, const CsvOptions& options) {
        writeQuantity(sink, options, *table);
      };
    }
  }
  return tables;
}

}  // namespace geargraph::cli
