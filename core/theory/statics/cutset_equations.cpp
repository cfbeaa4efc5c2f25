#include "core/theory/statics/cutset_equations.h"

namespace geargraph {

CutsetEquations::CutsetEquations(const CoefficientMatrix& matrix)
    : m_starts(static_cast<std::size_t>(matrix.columns()) + 1, 0) {
  std::vector<CoefficientMatrix::Entry> entries;
  std::vector<std::size_t> rows{0};
  for (MeshOrdinal mesh = 0; mesh < matrix.rows(); ++mesh) {
    matrix.appendRow(mesh, entries);
    rows.push_back(entries.size());
  }
  for (const CoefficientMatrix::Entry& entry : entries) ++m_starts[static_cast<std::size_t>(entry.joint) + 1];
  for (std::size_t joint = 1; joint < m_starts.size(); ++joint) m_starts[joint] += m_starts[joint - 1];
  m_terms.resize(entries.size());
  ByJoint<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
  for (MeshOrdinal mesh = 0; mesh < matrix.rows(); ++mesh) {
    for (std::size_t i = rows[static_cast<std::size_t>(mesh)]; i < rows[static_cast<std::size_t>(mesh) + 1];
         ++i) {
      const CoefficientMatrix::Entry& entry = entries[i];
      m_terms[next[entry.joint]++] = {mesh, entry.tail, entry.sign, entry.length};
    }
  }
}

CutsetEquations::CutsetEquations(const TtGraph& graph)
    : m_starts(static_cast<std::size_t>(graph.graph().t()) + 1, 0) {
  // M_ik = i f, M_jk = -s f; the cutset of a branch has the coefficients of the circuits through it.
  ByJoint<std::vector<Term>> byJoint(static_cast<std::size_t>(graph.graph().t()));
  for (MeshOrdinal mesh = 0; mesh < graph.graph().c(); ++mesh) {
    const int sign = graph.terminal(mesh)->sign;
    for (const CircuitTerm& term : graph.tailCircuit(mesh))
      byJoint[term.joint].push_back({mesh, true, term.coefficient, 0});
    for (const CircuitTerm& term : graph.headCircuit(mesh))
      byJoint[term.joint].push_back({mesh, false, -sign * term.coefficient, 0});
  }
  for (std::size_t joint = 0; joint < byJoint.size(); ++joint) {
    m_terms.insert(m_terms.end(), byJoint[joint].begin(), byJoint[joint].end());
    m_starts[joint + 1] = m_terms.size();
  }
}

}  // namespace geargraph
