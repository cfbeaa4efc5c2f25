#include "core/teaching/derivation/method_comparison.h"

#include <algorithm>
#include <map>

#include "core/foundations/base/translation.h"
#include "core/theory/ttgraph/tt_solution.h"

namespace geargraph {
namespace {

/// The rows of P over the joints, divided by the radius of the head's gear, and those of engaged couplings.
template <class Value, class RatioOf, class BigInteger>
HandRows<Value> handRows(const CoefficientMatrix& matrix, const KinematicModel& model,
                         const std::vector<int>& equations, const RatioOf& ratioOf, const BigInteger& whole) {
  HandRows<Value> rows;
  for (const int equation : equations) {
    std::vector<Value>& row = rows.emplace_back(static_cast<std::size_t>(model.t()), whole(0));
    if (equation >= model.c()) {
      for (const auto& term : model.heldRow(equation).joints)
        row[static_cast<std::size_t>(term.of)] = whole(term.factor);
      continue;
    }
    for (const CoefficientMatrix::Entry& entry : matrix.row(equation)) {
      const Value size = entry.tail ? ratioOf(equation) : whole(1);
      row[static_cast<std::size_t>(entry.joint)] = entry.sign > 0 ? size : -size;
    }
  }
  return rows;
}

class Comparison {
 public:
  /// @pre the plan of the solution's inputs, which outlives this
  Comparison(const AnalysisSnapshot& snapshot, const SubstitutionPlan& plan)
      : m_mechanism(*snapshot.mechanism),
        m_model(*snapshot.kinematics->model),
        m_placement(snapshot.kinematics->placement()),
        m_matroid(*snapshot.matroid()),
        m_graph(*snapshot.kinematics->ttGraph),
        m_plan(plan),
        m_matrix(m_mechanism, m_model, m_placement) {}

  std::optional<MethodComparison> run(ComparisonDepth depth, const std::stop_token& stop) {
    m_result.links = m_model.n();
    m_result.meshes = m_model.c();
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) m_result.perMesh.push_back(compared(mesh));
    sizeMatroid();
    sizeTtGraph();
    if (stop.stop_requested()) return std::nullopt;
    solveInNumbers();
    if (stop.stop_requested()) return std::nullopt;
    if (depth == ComparisonDepth::symbols) solveInSymbols();
    if (stop.stop_requested()) return std::nullopt;
    return std::move(m_result);
  }

 private:
  /// N_tail / N_head (w_ik - s N_head / N_tail w_jk), with the circuits put in: the terminal equation as a
  /// row over the joints, in the sign of the row of P.
  [[nodiscard]] ComparedMesh compared(MeshOrdinal mesh) const {
    const TerminalPair& pair = *m_graph.terminal(mesh);
    const Rational ratio = m_matrix.ratio(mesh);
    std::map<int, Rational> byTt;
    for (const CircuitTerm& term : m_graph.tailCircuit(mesh))
      byTt[term.joint] += ratio * Rational(term.coefficient);
    for (const CircuitTerm& term : m_graph.headCircuit(mesh))
      byTt[term.joint] -= Rational(pair.sign) * Rational(term.coefficient);
    ComparedMesh result;
    result.mesh = mesh;
    result.sign = pair.sign;
    int turned = 0;  // the sign of the whole row is free: that of the first joint decides
    for (const CoefficientMatrix::Entry& entry : m_matrix.row(mesh)) {
      const Rational size = entry.tail ? ratio : Rational(1);
      ComparedMesh::Term term{entry.joint, entry.sign > 0 ? size : -size, {}};
      const auto found = byTt.find(entry.joint);
      if (found != byTt.end()) {
        term.ttGraph = found->second;
        byTt.erase(found);
      }
      if (turned == 0) turned = term.ttGraph.sign() == term.matroid.sign() ? 1 : -1;
      term.ttGraph = Rational(turned) * term.ttGraph;
      result.terms.push_back(term);
    }
    const bool isSame = std::all_of(result.terms.begin(), result.terms.end(),
                                    [](const auto& term) { return term.matroid == term.ttGraph; });
    const bool isAll =
        std::all_of(byTt.begin(), byTt.end(), [](const auto& rest) { return rest.second.isZero(); });
    result.isEqual = isSame && isAll;
    return result;
  }

  void sizeMatroid() {
    MethodSize& size = m_result.matroid;
    size.unknowns = m_model.t();
    size.equations = m_model.equations();
    size.rows = m_model.equations();
    size.columns = m_model.t();
    for (const ComparedMesh& mesh : m_result.perMesh)
      size.nonZeros += static_cast<long long>(mesh.terms.size());
    for (const KinematicModel::HeldRow& row : m_model.held())
      size.nonZeros += static_cast<long long>(row.joints.size());
    size.setUp = geometryOperations(m_mechanism, m_model, m_placement);
  }

  void sizeTtGraph() {
    MethodSize& size = m_result.ttGraph;
    const int chords = 2 * m_model.c();
    const int held = m_graph.equations() - m_model.c();
    size.unknowns = m_model.t() + chords;
    size.equations = m_model.c() + chords + held;
    size.rows = size.equations;
    size.columns = size.unknowns;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      size.nonZeros += 2;  // the terminal equation
      size.nonZeros += 2 + static_cast<long long>(m_graph.tailCircuit(mesh).size()) +
                       static_cast<long long>(m_graph.headCircuit(mesh).size());
    }
    for (int equation = m_model.c(); equation < m_graph.equations(); ++equation)
      size.nonZeros += static_cast<long long>(m_graph.heldCircuit(equation).terms.size());
    size.setUp.products = m_model.c();
  }

  void solveInNumbers() {
    const LiveSolution& solution = *m_matroid.solution;
    const std::vector<int> equations = m_matroid.independentEquations();
    const auto rows = handRows<Rational>(
        m_matrix, m_model, equations, [this](MeshOrdinal mesh) { return m_matrix.ratio(mesh); },
        [](int value) { return Rational(value); });
    const auto byInverse = solvedByInverse(rows, solution.inputs, solution.outputs);
    auto byChain = solvedBySubstitution(m_graph, m_plan);
    m_together = std::move(byChain.together);
    m_result.matroid.numbers = byInverse.operations;
    m_result.ttGraph.numbers = byChain.operations;
    m_result.isEqual = byInverse.matrix == byChain.matrix;  // both by ascending outputs and the same inputs
  }

  void solveInSymbols() {
    const LiveSolution& solution = *m_matroid.solution;
    const RatioRingPtr ring = ratioRingOf(m_mechanism);
    const auto rows = handRows<RationalFunction>(
        m_matrix, m_model, m_matroid.independentEquations(),
        [&](MeshOrdinal mesh) { return RationalFunction::variable(ring, mesh); },
        [&](int value) { return RationalFunction::fromInteger(ring, value); });
    if (const auto byInverse = solvedByInverse(rows, solution.inputs, solution.outputs, ring))
      m_result.matroid.symbols = byInverse->operations;
    if (const auto byChain = solvedBySubstitution(m_graph, m_plan, m_together, ring))
      m_result.ttGraph.symbols = byChain->operations;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const MatroidAnalysis& m_matroid;
  const TtGraph& m_graph;
  const SubstitutionPlan& m_plan;
  CoefficientMatrix m_matrix;
  std::vector<int> m_together;  ///< equations of the T-T graph that are eliminated together
  MethodComparison m_result;
};

/// In one of two texts that are marked by toTranslate(), by their number, which is %1.
std::string countedWords(long long number, const char* one, const char* many) {
  return filled(translated(number == 1 ? one : many), {std::to_string(number)});
}

std::string sizeInWords(const Operations& operations) {
  return translated("%1 and %2", {productsText(operations), sumsText(operations)});
}

std::string equationsText(const MethodSize& size) {
  return countedWords(size.equations, toTranslate("%1 equation"), toTranslate("%1 equations"));
}

std::string unknownsText(const MethodSize& size) {
  return countedWords(size.unknowns, toTranslate("%1 unknown"), toTranslate("%1 unknowns"));
}

}  // namespace

std::string productsText(const Operations& operations) {
  return countedWords(operations.products, toTranslate("%1 product"), toTranslate("%1 products"));
}

std::string sumsText(const Operations& operations) {
  return countedWords(operations.sums, toTranslate("%1 sum"), toTranslate("%1 sums"));
}

std::vector<ComparedStep> comparedSteps() {
  return {
      {translated("Graph"),
       translated("digraph: a node for each link, an oriented line for each joint and mesh (Figs. 2, 3)"),
       translated("oriented graph: the same nodes and branches, and for each mesh two chords to its carrier "
                  "(Figs. 4 to "
                  "6)"),
       translated("The turning joints are the tree in both, the meshes close its cycles."),
       StepRelation::same},
      {translated("Tree and cycles"),
       translated("incidence matrix (1), (2), path matrix $Z$ (3), spanning tree (4), $C$ (5)"),
       translated("levels of the branches; f-circuits of the chords (31)-(38)"),
       translated("The cycle of a mesh is the circuit of its tail's chord less that of its head's chord."),
       StepRelation::equivalent},
      {translated("Carrier"), translated("not named: it drops out of the moments about the pitch point"),
       translated("transfer vertex: where the level changes on the walk between the gears"),
       translated("The moments of a cycle's joints lie on one line because the carrier holds both axes."),
       StepRelation::equivalent},
      {translated("Mesh"),
       translated("screws about the pitch point (6)-(13), one row of $P$ (16)-(19): $i_c$ on the tail's "
                  "axis, $\\pm 1$ "
                  "on the head's"),
       translated("terminal equation (26)-(30): speeds seen from the carrier, a ratio and a sign"),
       translated("The terminal equation with its two circuits put in is the row of $P$."),
       StepRelation::equivalent},
      {translated("Sign"), translated("comes with the diameters in the reference frame"),
       translated("from the turning senses of the two gears, seen along their axes"),
       translated("The signs agree: both are that of the product of the two moments."),
       StepRelation::equivalent},
      {translated("Freedom and inputs"),
       translated("rank of $P$, $E = t - r$ (21); bases of the dual matroid are the valid inputs"),
       translated("not asked: the inputs are taken as given"),
       translated("What can be driven is read from $P$."), StepRelation::onlyMatroid},
      {translated("Solution"), translated("$-P_r^{-1} P_E$ (22)-(25)"),
       translated("one mesh after the other, substituted (39)-(42), then (43)-(45)"),
       translated("The same matrix, by joint."), StepRelation::same},
      {translated("Relative velocities"),
       translated("of the two gears of a mesh to each other (15), after the solution"),
       translated("of each gear to its carrier: the chords, on the way to the solution"),
       translated("(15) is the difference of the two chords, as vectors."), StepRelation::equivalent},
      {translated("Forces"), translated("columns of $P$ (not in the paper)"),
       translated("complementary terminal variables and f-cutsets (not worked out in the paper)"),
       translated("The cutset matrix $Q$ serves both."), StepRelation::equivalent},
  };
}

std::optional<MethodComparison> compareMethods(const AnalysisSnapshot& snapshot, ComparisonDepth depth,
                                               const std::stop_token& stop) {
  const MatroidAnalysis* const matroid = snapshot.matroid();
  const bool isDefined = matroid != nullptr && matroid->solution && !snapshot.kinematics->model->hasPi() &&
                         snapshot.kinematics->ttGraph->isComplete() &&
                         snapshot.mechanism->n() <= kMaxComparedLinks && snapshot.mechanism->c() > 0;
  if (!isDefined) return std::nullopt;
  const SubstitutionPlan plan = substitutionPlan(*snapshot.kinematics->ttGraph, matroid->solution->inputs);
  if (plan.byLevels) return std::nullopt;
  return Comparison(snapshot, plan).run(depth, stop);
}

std::vector<ComparedClaim> claimsOf(const MethodComparison& comparison) {
  const Operations& inverse = comparison.matroid.numbers;
  const Operations& chain = comparison.ttGraph.numbers;
  ComparedClaim easier{
      translated("\"The kinematic equations can be obtained more easily by the T-T graph method.\""), {}, {}};
  const bool isFewer = chain.products + chain.sums < inverse.products + inverse.sums;
  (isFewer ? easier.evidenceFor : easier.evidenceAgainst)
      .push_back(
          translated("From its equations to the solution of this mechanism the chain of substitutions takes "
                     "%1, the inverse of $P_r$ and its product %2.",
                     {sizeInWords(chain), sizeInWords(inverse)}));
  easier.evidenceFor.push_back(translated(
      "It needs teeth and turning senses; the rows of $P$ need coordinates of axes and pitch points, and "
      "%1 from them.",
      {sizeInWords(comparison.matroid.setUp)}));
  easier.evidenceAgainst.push_back(
      translated("It writes %1 in %2, the Matroid method %3 in %4.",
                 {equationsText(comparison.ttGraph), unknownsText(comparison.ttGraph),
                  equationsText(comparison.matroid), unknownsText(comparison.matroid)}));
  easier.evidenceAgainst.push_back(translated(
      "Once a row of $P$ is divided by a radius it is the terminal equation with its circuits put in: "
      "solved in the same order, both take the same steps."));
  ComparedClaim only{translated("\"The only advantage of the Matroid method is the derivation of the "
                                "relative velocities of the gears "
                                "with respect to the carrier arm.\""),
                     {},
                     {}};
  only.evidenceFor.push_back(translated("(15) gives them as vectors, for skew and meeting axes alike."));
  only.evidenceAgainst.push_back(
      translated("The chords of the T-T graph are velocities relative to the carrier, too."));
  only.evidenceAgainst.push_back(translated(
      "The rank of $P$ gives the degrees of freedom, redundant meshes and every valid set of inputs; the T-T "
      "graph "
      "takes the inputs as given."));
  ComparedClaim sign{
      translated(
          "\"The sign of the gear ratio is obtained directly, without considering the turning direction.\""),
      {},
      {}};
  sign.evidenceFor.push_back(
      translated("The sign of each entry of $P$ is that of a difference of coordinates."));
  const auto turnsAgainst = std::count_if(comparison.perMesh.begin(), comparison.perMesh.end(),
                                          [](const ComparedMesh& mesh) { return mesh.sign < 0; });
  sign.evidenceAgainst.push_back(translated(
      "The senses have to be seen once a mesh: here %1 of %2 turn against each other, seen along their "
      "axes.",
      {countedWords(turnsAgainst, toTranslate("%1 pair"), toTranslate("%1 pairs")),
       std::to_string(comparison.meshes)}));
  return {easier, only, sign};
}

}  // namespace geargraph
