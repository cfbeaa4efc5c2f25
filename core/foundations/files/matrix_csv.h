#pragma once

#include <string>
#include <vector>

#include "core/foundations/files/csv.h"

namespace geargraph {

/// Writes a labelled matrix by the non-zeros of its rows: an IntegerMatrix of core/mechanism/graph, or any
/// type with the same members, so that this layer does not depend on that one.
template <class Entry, class UniformRow, class Matrix>
void writeMatrixCsv(ByteSink& sink, const Matrix& matrix, const CsvOptions& options = {}) {
  std::vector<std::string> columns;
  columns.reserve(static_cast<std::size_t>(matrix.columns()));
  for (int column = 0; column < matrix.columns(); ++column)
    columns.push_back(matrix.columnHeading(column).text);
  CsvWriter csv(sink, columns, options);
  std::vector<Entry> entries;
  UniformRow uniform;
  for (int row = 0; row < matrix.rows() && !csv.failed(); ++row) {
    const std::string label = matrix.rowHeading(row).text;
    if (matrix.uniformRow(row, uniform)) {
      csv.signRow(label, uniform.columns, uniform.value);
    } else {
      matrix.rowEntries(row, entries);
      csv.row(label, std::span<const Entry>(entries));
    }
  }
}

}  // namespace geargraph
