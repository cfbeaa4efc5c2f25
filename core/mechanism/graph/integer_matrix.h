#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/mechanism/graph/paper_equation.h"

namespace geargraph {

enum class MatrixKind { incidence, reducedIncidence, path, spanningTree, cycleBasis, cutset };

/// Every kind, in the order in which the paper derives them.
[[nodiscard]] const std::vector<MatrixKind>& allMatrixKinds();
[[nodiscard]] std::string_view matrixCommandName(
    MatrixKind kind);  ///< "reduced-incidence": command line, file names
[[nodiscard]] std::string_view matrixJsonName(MatrixKind kind);  ///< "reducedIncidence": analyze --json
[[nodiscard]] std::string_view matrixSymbol(MatrixKind kind);    ///< "Γ = [G | G*]", as the paper writes it
[[nodiscard]] std::string_view matrixTitle(MatrixKind kind);     ///< "Reduced incidence matrix"
/// The paper's equation that defines the matrix; none for the cutset matrix.
[[nodiscard]] PaperEquation matrixEquation(MatrixKind kind);

/// The heading of a row or column: a matrix leaves core only with its labels.
struct Heading {
  int label = 0;      ///< the paper's number
  std::string text;   ///< as shown: "8"; "C15" for a cycle
  ElementId element;  ///< what is highlighted with it; for a cycle, its mesh
};

struct MatrixEntry {
  int column = 0;
  int value = 0;
  friend bool operator==(const MatrixEntry&, const MatrixEntry&) = default;
};

/// A row whose non-zeros are all the same: column j holds `value` where bit j % 64 of word j / 64 is set,
/// else 0.
struct UniformRow {
  int value = 0;
  std::vector<std::uint64_t> columns;
  std::vector<std::uint8_t> marks;  ///< scratch memory of the matrix, reused from row to row
};

/// A matrix of -1, 0, +1 whose entries are computed on demand, not stored. Immutable and thread-safe; it
/// shares ownership of what it needs.
class IntegerMatrix {
 public:
  virtual ~IntegerMatrix() = default;

  [[nodiscard]] virtual MatrixKind kind() const = 0;
  [[nodiscard]] virtual int rows() const = 0;
  [[nodiscard]] virtual int columns() const = 0;
  [[nodiscard]] virtual Heading rowHeading(int row) const = 0;
  [[nodiscard]] virtual Heading columnHeading(int column) const = 0;
  /// Cost: O(1), some nanoseconds.
  [[nodiscard]] virtual int entry(int row, int column) const = 0;
  /// The non-zeros of a row in column order, written over `entries`.
  virtual void rowEntries(int row, std::vector<MatrixEntry>& entries) const = 0;
  /// The row as a set of columns, written over `uniform`; false if the rows of this matrix are not uniform.
  /// Faster than rowEntries() for writing whole matrices: nothing is sorted.
  virtual bool uniformRow(int /*row*/, UniformRow& /*uniform*/) const { return false; }
  /// The first column after the dashed line: [G | G*], [T | U], [U | -T^T]; std::nullopt if the matrix has no
  /// parts.
  [[nodiscard]] virtual std::optional<int> partition() const { return std::nullopt; }

 protected:
  IntegerMatrix() = default;
  IntegerMatrix(const IntegerMatrix&) = default;
  IntegerMatrix& operator=(const IntegerMatrix&) = default;
};

using IntegerMatrixPtr = std::shared_ptr<const IntegerMatrix>;

}  // namespace geargraph
