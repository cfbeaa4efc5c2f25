#include "core/theory/ttgraph/tt_statics.h"

#include <algorithm>
#include <map>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"

namespace geargraph {
namespace {

/// The equations by cutset, or by link where cutsets along a level are subtracted from each other. The
/// unknown of a mesh is m, with M_ik = N_i m and M_jk = -s N_j m by (26*).
class CutsetRows {
 public:
  CutsetRows(const TtGraph& graph, std::span<const TtChord> chords, const RadicalColumns& loads,
             bool byLevels)
      : m_graph(graph), m_byLevels(byLevels), m_rows(static_cast<std::size_t>(graph.graph().t())) {
    const int meshes = graph.graph().c();
    for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
      byLevels ? addPortsByLevel(mesh) : addPorts(mesh);
    }
    int column = meshes;
    for (const TtChord& chord : chords) {
      for (const auto& [joint, coefficient] : chord) add(joint, column, coefficient);
      ++column;
    }
    m_unknowns = column;
    for (const RadicalColumns::Column& load : loads.columns()) {
      for (const auto& [joint, torque] : load.entries) add(joint, column, torque);
      ++column;
    }
    m_columns = column;
  }

  [[nodiscard]] int unknowns() const { return m_unknowns; }
  [[nodiscard]] int columns() const { return m_columns; }

  [[nodiscard]] SparseRows<Rational> take() {
    SparseRows<Rational> rows;
    for (auto& row : m_rows) {
      for (auto& [column, value] : row) {
        if (!value.isZero()) rows.add(column, std::move(value));
      }
      rows.endRow();
    }
    return rows;
  }

 private:
  using Row = std::map<int, Rational>;

  void addTo(int row, int column, const Rational& value) { m_rows[row][column] += value; }

  /// Adds to the cutset of a branch. By levels: the cutset of the branch minus those of the next branches on
  /// its level, outward, is the balance of the link between them.
  void add(JointOrdinal joint, int column, const Rational& value) {
    if (!m_byLevels) return addTo(joint, column, value);
    const LinkOrdinal child = m_graph.tree().child(joint);
    const int sense = m_graph.levels().orientationSign(joint) * -m_graph.tree().directionToGround(joint);
    addAtNode(child, levelOf(joint), column, Rational(sense) * value);
    addAtNode(m_graph.tree().parent(child), levelOf(joint), column, Rational(-sense) * value);
  }

  [[nodiscard]] int levelOf(JointOrdinal joint) const { return m_graph.levels().ofJoint[joint]; }

  /// The balance of a link along a level; the link nearest the ground has none.
  void addAtNode(LinkOrdinal node, int level, int column, const Rational& value) {
    if (node == 0) return;
    const JointOrdinal joint = m_graph.tree().jointToParent(node);
    if (levelOf(joint) == level) addTo(joint, column, value);
  }

  void addPorts(MeshOrdinal mesh) {
    const TerminalPair& pair = *m_graph.terminal(mesh);
    for (const CircuitTerm& term : m_graph.tailCircuit(mesh))
      addTo(term.joint, mesh, Rational(static_cast<std::int64_t>(term.coefficient) * pair.tailTeeth));
    for (const CircuitTerm& term : m_graph.headCircuit(mesh))
      addTo(term.joint, mesh,
            Rational(-static_cast<std::int64_t>(term.coefficient) * pair.sign * pair.headTeeth));
  }

  void addPortsByLevel(MeshOrdinal mesh) {
    const TerminalPair& pair = *m_graph.terminal(mesh);
    const TransferVertex& vertex = *m_graph.transferVertices().ofMesh[mesh];
    addAtNode(pair.tail, vertex.tailLevel, mesh, Rational(pair.tailTeeth));
    addAtNode(pair.carrier, vertex.tailLevel, mesh, Rational(-pair.tailTeeth));
    addAtNode(pair.head, vertex.headLevel, mesh, Rational(-pair.sign * pair.headTeeth));
    addAtNode(pair.carrier, vertex.headLevel, mesh, Rational(pair.sign * pair.headTeeth));
  }

  const TtGraph& m_graph;
  bool m_byLevels;
  ByJoint<Row> m_rows;
  int m_unknowns = 0;
  int m_columns = 0;
};

TtStaticStep stepOf(const Elimination<Rational>::Line& line, int meshes) {
  TtStaticStep step;
  if (line.column < meshes) {
    step.mesh = line.column;
  } else {
    step.chord = line.column - meshes;
  }
  step.coupled = line.core;
  if (!line.core) step.joint = line.row;
  return step;
}

}  // namespace

std::optional<TtTorques> ttTorques(const TtGraph& graph, std::span<const TtChord> chords,
                                   const RadicalColumns& loads, const std::stop_token& stop,
                                   long long mostTerms) {
  const RationalField field;
  const bool byLevels = graph.longestCircuitTerms() > mostTerms;
  CutsetRows rows(graph, chords, loads, byLevels);
  const auto system = eliminate(field, rows.take(), rows.unknowns(), rows.columns(), stop);
  if (!system) return std::nullopt;

  TtTorques result;
  const int meshes = graph.graph().c();
  const auto unknowns = static_cast<std::size_t>(rows.unknowns());
  std::vector<char> determined(unknowns, 1);
  std::vector<Rational> x(static_cast<std::size_t>(rows.columns()));
  for (const int free : system->freeColumns) {
    if (stop.stop_requested()) return std::nullopt;
    std::fill(x.begin(), x.end(), Rational(0));
    x[static_cast<std::size_t>(free)] = 1;
    substitute(field, *system, x);
    for (std::size_t unknown = 0; unknown < unknowns; ++unknown)
      if (!x[unknown].isZero()) determined[unknown] = 0;
  }
  std::vector<std::vector<Rational>> parts(unknowns);
  for (std::size_t k = 0; k < loads.columns().size(); ++k) {
    std::fill(x.begin(), x.end(), Rational(0));
    x[unknowns + k] = 1;
    substitute(field, *system, x);
    for (const auto& check : system->checks)
      result.isBalanced = result.isBalanced && field.isZero(checkValue(field, *system, check, x));
    for (std::size_t unknown = 0; unknown < unknowns; ++unknown) parts[unknown].push_back(x[unknown]);
  }
  result.meshDetermined.assign(determined.begin(), determined.begin() + meshes);
  result.chordDetermined.assign(determined.begin() + meshes, determined.end());
  if (!byLevels)
    for (const auto& line : system->lines) result.steps.push_back(stepOf(line, meshes));
  if (!result.isBalanced) return result;
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
    const TerminalPair& pair = *graph.terminal(mesh);
    const Real perTooth = loads.sumOf(parts[static_cast<std::size_t>(mesh)]);
    result.tailPorts.push_back(Real(pair.tailTeeth) * perTooth);
    result.headPorts.push_back(Real(-pair.sign * pair.headTeeth) * perTooth);
  }
  for (std::size_t chord = static_cast<std::size_t>(meshes); chord < unknowns; ++chord)
    result.chords.push_back(loads.sumOf(parts[chord]));
  return result;
}

}  // namespace geargraph
