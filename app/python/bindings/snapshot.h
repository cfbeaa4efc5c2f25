#pragma once

#include <memory>
#include <mutex>

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::python {

/// The analysis of a document, in parts that are computed on first use, then cached. An interrupted request
/// caches nothing. Thread-safe.
class Snapshot {
 public:
  /// Computes the live part: rank, degrees of freedom, matrices, speeds as doubles.
  Snapshot(const Document& document, bool symbolic);

  [[nodiscard]] const SnapshotPtr& live() const { return m_live; }
  [[nodiscard]] const Mechanism& mechanism() const { return *m_live->mechanism; }
  /// With the exact and symbolic solutions of both methods, if there are any.
  [[nodiscard]] SnapshotPtr solved();
  /// Also with the states.
  [[nodiscard]] SnapshotPtr shifted();
  /// The complete analysis, including the diagnostics about teeth.
  [[nodiscard]] SnapshotPtr full();

  /// The results of the matroid method. Raises geargraph.Error with the diagnostics if the mechanism cannot
  /// be analysed, or if `needsSolution` and there is no solution.
  [[nodiscard]] const MatroidAnalysis& matroid(bool needsSolution) const;
  /// Raises geargraph.Error with the errors of the analysis, or with "undefined" and this sentence if there
  /// are none.
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

/// The labels and the non-zero pattern of a matrix for Python: a heading (label, text, kind, id) per row and
/// column, the first column after the partition, and the row and column of each non-zero entry. The functions
/// that use it add the values, and for quantities the text and LaTeX of each entry.
struct RawMatrix {
  py::list rows;
  py::list columns;
  std::optional<int> partition;
  std::vector<std::int32_t> rowOf;
  std::vector<std::int32_t> columnOf;

  [[nodiscard]] static py::tuple heading(const Heading& heading, bool hasElement = true);
};

}  // namespace geargraph::python
