#pragma once

#include <memory>
#include <mutex>

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::python {

/// The analysis of a document, in parts that are computed when they are asked for first, then kept. A request
/// that is interrupted leaves nothing. Any thread may ask.
class Snapshot {
 public:
  /// The live part: rank, freedom, matrices, speeds in doubles.
  Snapshot(const Document& document, bool symbolic);

  [[nodiscard]] const SnapshotPtr& live() const { return m_live; }
  [[nodiscard]] const Mechanism& mechanism() const { return *m_live->mechanism; }
  /// With the exact and symbolic solutions of both methods, where there are any.
  [[nodiscard]] SnapshotPtr solved();
  /// With the states, too.
  [[nodiscard]] SnapshotPtr shifted();
  /// With everything, the findings about teeth among it.
  [[nodiscard]] SnapshotPtr full();

  /// What the matroid method found; raises geargraph.Error with the findings where the mechanism leaves
  /// nothing to solve, or `needsSolution` and there is none.
  [[nodiscard]] const MatroidAnalysis& matroid(bool needsSolution) const;
  /// Raises geargraph.Error: the errors found, or "undefined" with this sentence where there are none.
  [[noreturn]] void raiseUndefined(const std::string& what) const;

 private:
  template <class Make>
  SnapshotPtr kept(SnapshotPtr& place, const Make& make);

  SolveOptions m_options;
  SnapshotPtr m_live;
  std::mutex m_mutex;  ///< of the following; never held while something is computed
  SnapshotPtr m_solved;
  SnapshotPtr m_shifted;
  SnapshotPtr m_full;
};

/// A matrix with its labels as a tuple: rows and columns, each heading (label, text, kind, id); the first
/// column after the partition or None; the non-zeros as packed int32 rows, int32 columns and values; and of
/// quantities each entry's text and LaTeX.
struct RawMatrix {
  py::list rows;
  py::list columns;
  std::optional<int> partition;
  std::vector<std::int32_t> rowOf;
  std::vector<std::int32_t> columnOf;

  [[nodiscard]] static py::tuple heading(const Heading& heading, bool hasElement = true);
};

}  // namespace geargraph::python
