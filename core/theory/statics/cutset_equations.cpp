#include "core/theory/statics/cutset_equations.h"

namespace geargraph::inline statics {

CutsetEquations::CutsetEquations(const CoefficientMatrix& matrix)
    : m_starts(static_cast<std::size_t>(matrix.columns()) + 1, 0) {
  std::vector<CoefficientMatrix::Entry> entries;
  std::vector<std::size_t> rows{0};
  for (int mesh = 0; mesh < matrix.rows(); ++mesh) {
    matrix.appendRow(mesh, entries);
    rows.push_back(entries.size());
  }
  for (const CoefficientMatrix::Entry& entry : entries) ++m_starts[static_cast<std::size_t>(entry.joint) + 1];
  for (std::size_t joint = 1; joint < m_starts.size(); ++joint) m_starts[joint] += m_starts[joint - 1];
  m_terms.resize(entries.size());
  std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
  for (int mesh = 0; mesh < matrix.rows(); ++mesh) {
    for (std::size_t i = rows[static_cast<std::size_t>(mesh)]; i < rows[static_cast<std::size_t>(mesh) + 1];
         ++i) {
      const CoefficientMatrix::Entry& entry = entries[i];
      m_terms[next[static_cast<std::size_t>(entry.joint)]++] = {mesh, entry.tail, entry.sign, entry.length};
    }
  }
}

}  // namespace geargraph::inline statics
