#include "core/theory/statics/symbolic_statics.h"

#include <algorithm>
#include <utility>

#include "core/theory/matroid/symbolic_solution.h"

namespace geargraph {
namespace {

constexpr int kMaxTermsOfTheCore = 600;

/// The cutset equations with a column for each f of a mesh, each balanced and each loaded joint.
class CutsetSystem {
 public:
  CutsetSystem(const CutsetEquations& cutsets, int meshCount, std::span<const int> meshes,
               std::span<const int> balanced, std::span<const int> loaded)
      : m_cutsets(cutsets),
        m_meshes(meshes.begin(), meshes.end()),
        m_balanced(balanced.begin(), balanced.end()),
        m_loaded(loaded.begin(), loaded.end()),
        m_columnOfMesh(static_cast<std::size_t>(meshCount), -1),
        m_columnOfJoint(static_cast<std::size_t>(cutsets.count()), -1) {
    int column = 0;
    for (const MeshOrdinal mesh : meshes) m_columnOfMesh[mesh] = column++;
    for (const JointOrdinal joint : balanced) m_columnOfJoint[joint] = column++;
    for (const JointOrdinal joint : loaded) m_columnOfJoint[joint] = column++;
  }

  [[nodiscard]] int unknowns() const { return static_cast<int>(m_meshes.size() + m_balanced.size()); }
  [[nodiscard]] int columns() const { return unknowns() + static_cast<int>(m_loaded.size()); }
  [[nodiscard]] int firstBalance() const { return static_cast<int>(m_meshes.size()); }

  /// sum of P^T f - tau = 0; columns marked in `left` are left out.
  template <class Field, class Ratio>
  [[nodiscard]] SparseRows<typename Field::Value> rows(const Field& field, const Ratio& ratio,
                                                       const std::vector<char>& left) const {
    SparseRows<typename Field::Value> result;
    const auto isLeft = [&](int column) { return left[static_cast<std::size_t>(column)] != 0; };
    for (JointOrdinal joint = 0; joint < m_cutsets.count(); ++joint) {
      for (const CutsetEquations::Term& term : m_cutsets.terms(joint)) {
        const int column = m_columnOfMesh[term.mesh];
        if (column < 0 || isLeft(column)) continue;
        const auto value = term.tail ? ratio(term.mesh) : field.one();
        result.add(column, term.sign > 0 ? value : field.negated(value));
      }
      const int own = m_columnOfJoint[joint];
      if (own >= 0 && !isLeft(own)) result.add(own, field.fromInteger(-1));
      result.endRow();
    }
    return result;
  }

  [[nodiscard]] SymbolicStatics::Line line(const Elimination<RationalFunction>& system,
                                           const Elimination<RationalFunction>::Line& from) const {
    const auto& rows = system.matrixOf(from.core);
    const RationalFunction& pivot = pivotOf(rows, from.row, from.column);
    SymbolicStatics::Line line;
    std::tie(line.mesh, line.joint) = nameOf(from.column);
    if (!from.core) line.cutset = from.row;
    for (int entry = rows.begin(from.row); entry < rows.end(from.row); ++entry) {
      if (rows.column(entry) == from.column) continue;
      SymbolicStatics::Term& term = line.terms.emplace_back();
      std::tie(term.mesh, term.joint) = nameOf(rows.column(entry));
      term.coefficient = -rows.value(entry);
      if (!pivot.isOne()) term.coefficient /= pivot;
    }
    return line;
  }

 private:
  [[nodiscard]] std::pair<int, int> nameOf(int column) const {
    const auto at = static_cast<std::size_t>(column);
    if (at < m_meshes.size()) return {m_meshes[at], -1};
    if (column < unknowns()) return {-1, m_balanced[at - m_meshes.size()]};
    return {-1, m_loaded[at - static_cast<std::size_t>(unknowns())]};
  }

  const CutsetEquations& m_cutsets;
  std::vector<int> m_meshes;
  std::vector<int> m_balanced;
  std::vector<int> m_loaded;
  ByMesh<int> m_columnOfMesh;
  ByJoint<int> m_columnOfJoint;
};

/// By loaded joint, then by column: identically 0, found at ratios drawn at random modulo a prime. None where
/// the unknowns are not determined at those, or `stop` was requested.
std::optional<std::vector<std::vector<char>>> zerosOf(const CutsetSystem& cutsets, int meshes,
                                                      const std::stop_token& stop) {
  const ModularDoubleField field;
  ResidueStream random(field.prime(), 0x726174696f73U);
  ByMesh<ModularDouble> ratios;
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) ratios.push_back({1, random.next()});
  const auto ratio = [&](MeshOrdinal mesh) { return ratios[mesh]; };
  const auto columns = static_cast<std::size_t>(cutsets.columns());
  const auto system = eliminate(field, cutsets.rows(field, ratio, std::vector<char>(columns, 0)),
                                cutsets.unknowns(), cutsets.columns(), stop);
  if (!system || !system->freeColumns.empty()) return std::nullopt;
  std::vector<std::vector<char>> zeros;
  std::vector<ModularDouble> x(columns);
  for (std::size_t given = static_cast<std::size_t>(cutsets.unknowns()); given < columns; ++given) {
    if (stop.stop_requested()) return std::nullopt;
    std::fill(x.begin(), x.end(), ModularDouble());
    x[given] = field.one();
    substitute(field, *system, x);
    for (const auto& check : system->checks)
      if (!field.isZero(checkValue(field, *system, check, x))) return std::nullopt;
    std::vector<char>& vanishing = zeros.emplace_back();
    for (const ModularDouble& value : x) vanishing.push_back(field.isZero(value) ? 1 : 0);
  }
  return zeros;
}

}  // namespace

std::optional<SymbolicStatics> solveStaticsSymbolic(const Mechanism& mechanism,
                                                    const CutsetEquations& cutsets,
                                                    std::span<const int> meshes,
                                                    std::span<const int> balanced,
                                                    std::span<const int> loaded, const std::stop_token& stop,
                                                    ExpansionBudget budget) {
  const CutsetSystem equations(cutsets, mechanism.c(), meshes, balanced, loaded);
  const auto zeros = zerosOf(equations, mechanism.c(), stop);
  if (!zeros) return std::nullopt;

  SymbolicStatics result;
  result.ring = ratioRingOf(mechanism);
  result.balanced.assign(balanced.begin(), balanced.end());
  result.loaded.assign(loaded.begin(), loaded.end());
  const auto unknowns = static_cast<std::size_t>(equations.unknowns());
  std::vector<char> left(static_cast<std::size_t>(equations.columns()), 0);
  for (std::size_t column = 0; column < unknowns; ++column) {
    left[column] = std::all_of(zeros->begin(), zeros->end(),
                               [&](const std::vector<char>& vanishing) { return vanishing[column] != 0; })
                       ? 1
                       : 0;
  }
  std::stop_source enough;  // the caller's request, or the core's size
  const std::stop_callback forward(stop, [&] { enough.request_stop(); });
  const RationalFunctionField bounded(result.ring, kMaxTermsOfTheCore, enough);
  const RationalFunctionField field(result.ring);
  const auto ratio = [&](MeshOrdinal mesh) { return RationalFunction::variable(result.ring, mesh); };
  const auto system = eliminate(bounded, equations.rows(bounded, ratio, left), equations.unknowns(),
                                equations.columns(), enough.get_token());
  if (!system) return std::nullopt;
  for (const auto& line : system->lines) result.lines.push_back(equations.line(*system, line));

  result.matrix.resize(balanced.size() * loaded.size());
  std::vector<std::optional<RationalFunction>> x(left.size(), RationalFunction());
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    auto& given = x[unknowns + k];
    given = field.one();
    if (!expand(field, *system, (*zeros)[k], x, budget, stop)) return std::nullopt;
    given = RationalFunction();
    for (std::size_t row = 0; row < balanced.size(); ++row) {
      auto& value = x[static_cast<std::size_t>(equations.firstBalance()) + row];
      if (!value) ++result.skipped;
      result.matrix[row * loaded.size() + k] = value;
    }
    for (std::size_t column = 0; column < unknowns; ++column) x[column] = RationalFunction();
  }
  return result;
}

}  // namespace geargraph
