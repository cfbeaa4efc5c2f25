#include <algorithm>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/theory/statics/statics_report.h"
#include "core/theory/ttgraph/notation.h"
#include "core/theory/ttgraph/tt_statics.h"

namespace geargraph {
namespace {

class StaticsPart : private ReportPart {
 public:
  StaticsPart(Report& report, const AnalysisSnapshot& snapshot, const StaticsReport& statics,
              const std::stop_token& stop)
      : ReportPart(report, stop),
        m_snapshot(snapshot),
        m_mechanism(*snapshot.mechanism),
        m_model(*snapshot.kinematics->model),
        m_placement(snapshot.kinematics->placement()),
        m_graph(*snapshot.graph),
        m_ttGraph(*snapshot.kinematics->ttGraph),
        m_statics(statics) {}

  void add() {
    heading(1, toTranslate("Statics"));
    paragraph(translated(
        "What holds the loads follows from the same matrices, read down their columns. A starred number "
        "belongs to the equation of the kinematics beside it. A torque $\\tau_e$ acts in joint $e$, by its "
        "tail on its head, about the direction of its axis; $\\ell_e$ is the power of the loads on links "
        "beyond the joint for its rate $1$; $F_c$ is the tangential force of mesh $c$, by the tail's gear "
        "on the head's."));
    addCutsets();
    if (isStopped()) return;
    addTransposed();
    addTorques();
    if (!isStopped() && m_ttGraph.isComplete()) addTtGraphMethod();
    addAgreement();
  }

 private:
  [[nodiscard]] std::string label(JointOrdinal joint) const {
    return std::to_string(m_graph.edgeLabel(joint));
  }
  [[nodiscard]] std::string torque(JointOrdinal joint) const { return "\\tau_{" + label(joint) + "}"; }
  [[nodiscard]] std::string force(MeshOrdinal mesh) const {
    return "F_{" + std::to_string(m_mechanism.meshLabel(mesh)) + "}";
  }
  [[nodiscard]] ElementId jointId(JointOrdinal joint) const { return m_mechanism.turningJoints[joint].id; }
  [[nodiscard]] ElementId meshId(MeshOrdinal mesh) const { return m_mechanism.gearMeshes[mesh].id; }
  [[nodiscard]] std::string torqueColumn(std::span<const int> joints) const {
    std::vector<std::string> names;
    for (const JointOrdinal joint : joints) names.push_back(torque(joint));
    return texColumn(names);
  }
  [[nodiscard]] static std::string number(const Real& value) {
    return value.isExact() ? readableLatex(*value.fraction()) : spokenTexNumber(shortDecimal(value.number()));
  }
  /// " + 3 x", " - x" for a sum; the first term without a plus.
  static void addTerm(std::string& sum, bool negative, const std::string& term) {
    sum += negative ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += term;
  }

  /// Is there a load or a balance on a link, so that some ell is not 0?
  [[nodiscard]] bool hasLinkLoads() const {
    const auto onLink = [](const auto& each) { return !each.inJoint(); };
    const StaticsProblem& problem = m_statics.problem;
    return !problem.forces.empty() ||
           std::any_of(problem.torques.begin(), problem.torques.end(),
                       [&](const AppliedTorque& load) { return onLink(load.place); }) ||
           std::any_of(problem.balances.begin(), problem.balances.end(), onLink);
  }

  /// "T_{A}" of an engaged coupling; by its position where its name is no word of a formula.
  [[nodiscard]] std::string couplingName(ShiftElementOrdinal coupling) const {
    const std::string& id = m_mechanism.couplings[coupling].id.text();
    const bool isWord = !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    });
    return "T_{" + (isWord ? id : std::to_string(coupling + 1)) + "}";
  }
  /// What is added to the torque in a joint: the loads and balances on links beyond it, and the engaged
  /// couplings whose circuit it is on. " + \\ell_{8} - T_{A}"
  [[nodiscard]] std::string besides(JointOrdinal joint) const {
    std::string sum = hasLinkLoads() ? " + \\ell_{" + label(joint) + "}" : "";
    for (const HeldPart& part : m_statics.held) {
      if (part.coupling < 0) continue;
      for (const auto& [at, factor] : part.byJoint)
        if (at == joint) sum += (factor.sign() < 0 ? " - " : " + ") + couplingName(part.coupling);
    }
    return sum;
  }

  void addCutsets() {
    heading(2, toTranslate("Cutset equations"));
    paragraph(translated(
        "Without joint $e$ the tree falls into two parts. The edges that lead from one to the other are its "
        "fundamental cutset. It crosses each cycle as often along the cycle as against it:"));
    dualEquation("C = \\left[ T \\mid U \\right] \\quad " + cited(PaperEquation::cycleBasisMatrix) +
                     " , \\quad Q = \\left[ U \\mid -T^T \\right] , \\quad Q \\, C^T = 0",
                 PaperEquation::cycleBasisMatrix);
    paragraph(translated(
        "So the part beyond a joint is in equilibrium if the torque in the joint and the loads hold the "
        "forces "
        "of the meshes that cross the cutset. Their moments about the joint's axis are the entries of its "
        "column of $P$; forces along the line of centres or along an axis do no work and are in no "
        "equation:"));
    dualEquation("P \\, \\dot{\\theta}_t = 0 \\quad " + cited(PaperEquation::meshEquations) +
                     " , \\quad \\tau + \\ell = P^T F",
                 PaperEquation::meshEquations);
    if (m_graph.t() > kMaxListed) {
      return paragraph(translated(
          "There are too many to print: \"export --to csv --matrix cutset-equations\" writes them."));
    }
    if (!m_statics.problem.engaged.empty())
      paragraph(translated("An engaged coupling is a further edge of the graph, with its torque $T$."));
    paragraph(
        translated("With lengths in %1, so that torques are in N %1, joint by joint,", {m_mechanism.unit}));
    const CutsetEquations cutsets(CoefficientMatrix(m_mechanism, m_model, m_placement));
    std::vector<std::string> lines;
    std::vector<ElementId> joints;
    for (JointOrdinal joint = 0; joint < cutsets.count(); ++joint) {
      std::string sum;
      for (const CutsetEquations::Term& term : cutsets.terms(joint))
        addTerm(sum, term.length < 0,
                spokenTexNumber(shortDecimal(std::abs(term.length))) + " " + force(term.mesh));
      lines.push_back(torque(joint) + besides(joint) + " = " + (sum.empty() ? "0" : sum));
      joints.push_back(jointId(joint));
    }
    dualEquation(texLines(lines), PaperEquation::coefficientsInNumbers, std::move(joints));
  }

  void addTransposed() {
    if (!m_statics.matrix || m_statics.balancedJoints.empty()) return;
    heading(2, toTranslate("The transposed solution"));
    paragraph(translated(
        "The torques in the balanced joints, $\\tau_E$, hold those in the others, $\\tau_r$. With the "
        "columns of $P$ in the same order as for the speeds,"));
    dualEquation("\\dot{\\theta}_r = K_r \\, \\dot{\\theta}_E \\quad " +
                     cited(PaperEquation::solutionByInverse) + " , \\quad \\tau_E = -K_r^T \\, \\tau_r",
                 PaperEquation::solutionByInverse);
    const TorqueMatrix& matrix = *m_statics.matrix;
    const std::size_t columns = matrix.loaded.size();
    if (columns == 0 || columns > kMaxReportColumns || m_statics.balancedJoints.size() > kMaxReportRows)
      return;
    const std::string left = torqueColumn(m_statics.balancedJoints) + " =\n";
    const std::string right = " " + torqueColumn(matrix.loaded);
    const auto rows = [&](const auto& entry) {
      std::vector<std::vector<std::string>> texts(m_statics.balancedJoints.size());
      for (std::size_t row = 0; row < texts.size(); ++row)
        for (std::size_t column = 0; column < columns; ++column)
          texts[row].push_back(entry(row * columns + column));
      return texts;
    };
    if (m_statics.symbolic && m_statics.symbolic->skipped == 0) {
      paragraph(translated("which in ratios is (25) transposed, with the opposite sign:"));
      dualEquation(
          left + texMatrix(rows([&](std::size_t at) { return m_statics.symbolic->matrix[at]->toLatex(); })) +
              right,
          PaperEquation::matroidSolution);
    }
    paragraph(translated("With the teeth of this mechanism:"));
    equation(left + texMatrix(rows([&](std::size_t at) { return readableLatex(matrix.entries[at]); })) +
             right);
  }

  void addTorques() {
    heading(2, toTranslate("Torques under the loads"));
    if (!m_statics.lossless.isBalanced()) {
      for (const Diagnostic& each : m_statics.diagnostics)
        if (each.code == Code::unbalanced) put(ReportParagraph{plainWords(each.message)});
      return;
    }
    std::vector<std::string> lines;
    std::vector<ElementId> elements;
    for (std::size_t part = 0; part < m_statics.held.size(); ++part) {
      const int balance = m_statics.held[part].balance;
      const auto unknown = static_cast<std::size_t>(m_model.c()) + part;
      if (balance < 0 || static_cast<int>(lines.size()) >= kMaxListed) continue;
      const TorquePlace& place = m_statics.problem.balances[static_cast<std::size_t>(balance)];
      if (!place.inJoint() || m_statics.lossless.determined[unknown] == 0) continue;
      lines.push_back(torque(place.joint) + " = " + number(m_statics.lossless.values[unknown]));
      elements.push_back(jointId(place.joint));
    }
    if (!lines.empty()) {
      paragraph(translated(
          "The loads of the document are held by these torques, in N m, in a train without losses:"));
      equation(texLines(lines), std::nullopt, std::move(elements));
    }
    addForces();
  }

  void addForces() {
    std::vector<std::string> lines;
    std::vector<ElementId> elements;
    for (MeshOrdinal mesh = 0; mesh < m_model.c() && mesh < kMaxListed; ++mesh) {
      if (m_statics.forces.meshes.empty() || !m_statics.lossless.isDetermined(mesh)) continue;
      lines.push_back(force(mesh) + " = " +
                      spokenTexNumber(shortDecimal(m_statics.forces.meshes[mesh].tangential)));
      elements.push_back(meshId(mesh));
    }
    if (lines.empty()) return;
    paragraph(translated("The tangential forces of the meshes, in N, are"));
    equation(texLines(lines), std::nullopt, std::move(elements));
  }

  /// "M_{51}''": the torque where the velocity is called so.
  [[nodiscard]] static std::string torqueName(const VelocityName& velocity) {
    std::string name = velocity.toLatex();
    name.replace(0, std::string("\\omega").size(), "M");
    return name;
  }
  [[nodiscard]] std::string branch(JointOrdinal joint) const {
    return torqueName(branchName(m_graph, joint));
  }

  void addTtGraphMethod() {
    heading(2, toTranslate("The same by the T-T graph"));
    const EquationNumbers numbers(m_ttGraph, 0);
    const std::vector<RatioNames> names = ratioNames(m_graph);
    if (m_graph.c() > kMaxListed || m_graph.t() > kMaxListed || m_graph.c() == 0) return;
    paragraph(translated(
        "A mesh loses no power at its two ports, so the torques on its gears, seen from the carrier, are in "
        "the inverse ratio of their speeds:"));
    for (MeshOrdinal mesh = 0; mesh < m_graph.c(); ++mesh) {
      const TerminalPair& pair = *m_ttGraph.terminal(mesh);
      dualEquation(torqueName(headChordName(pair)) + " = " + (pair.sign > 0 ? "-" : "") +
                       names[static_cast<std::size_t>(mesh)].inverseLatex + " " +
                       torqueName(tailChordName(pair)),
                   numbers.terminal(mesh), {meshId(mesh)});
    }
    paragraph(translated(
        "Each branch of the tree has a fundamental cutset, with the coefficients of the circuits that "
        "the branch belongs to:"));
    std::vector<std::string> cutsets(static_cast<std::size_t>(m_graph.t()));
    for (MeshOrdinal mesh = 0; mesh < m_graph.c(); ++mesh) {
      const TerminalPair& pair = *m_ttGraph.terminal(mesh);
      const auto add = [&](std::span<const CircuitTerm> circuit, const VelocityName& chord) {
        for (const CircuitTerm& term : circuit)
          addTerm(cutsets[static_cast<std::size_t>(term.joint)], term.coefficient < 0, torqueName(chord));
      };
      add(m_ttGraph.tailCircuit(mesh), tailChordName(pair));
      add(m_ttGraph.headCircuit(mesh), headChordName(pair));
    }
    const int first = numbers.terminal(m_graph.c() - 1) + 1;
    for (JointOrdinal joint = 0; joint < m_graph.t() && !isStopped(); ++joint) {
      const std::string& chords = cutsets[static_cast<std::size_t>(joint)];
      const std::string sum = chords.empty() ? "" : (chords.front() == '-' ? " " : " + ") + chords;
      dualEquation(branch(joint) + sum + besides(joint) + " = 0", first + joint, {jointId(joint)});
    }
    if (!isStopped()) addCutsetMatrices();
    if (m_statics.lossless.isBalanced()) addChain(first, std::max(numbers.step(0), first + m_graph.t()));
  }

  /// The cutset matrices of both graphs, one below the other; their columns are named by what they act on.
  void addCutsetMatrices() {
    const IntegerMatrixPtr& q = m_snapshot.matrix(MatrixKind::cutset);
    const int columns = m_graph.t() + 2 * m_graph.c();
    if (!q || columns > kMaxReportColumns || m_graph.t() > kMaxReportRows) return;
    std::vector<std::string> torques;
    std::vector<std::vector<std::string>> rows(static_cast<std::size_t>(m_graph.t()));
    for (JointOrdinal joint = 0; joint < m_graph.t(); ++joint) {
      torques.push_back(branch(joint));
      auto& row = rows[static_cast<std::size_t>(joint)];
      row.assign(static_cast<std::size_t>(columns), "0");
      row[static_cast<std::size_t>(joint)] = "1";
    }
    for (MeshOrdinal mesh = 0; mesh < m_graph.c(); ++mesh) {
      const TerminalPair& pair = *m_ttGraph.terminal(mesh);
      for (const bool isTail : {true, false}) {
        for (const CircuitTerm& term : isTail ? m_ttGraph.tailCircuit(mesh) : m_ttGraph.headCircuit(mesh))
          rows[static_cast<std::size_t>(term.joint)][torques.size()] = term.coefficient < 0 ? "-1" : "1";
        torques.push_back(torqueName(isTail ? tailChordName(pair) : headChordName(pair)));
      }
    }
    paragraph(translated(
        "These cutsets as the rows of a matrix, the torques in the branches before the line, those of the "
        "chords after it; loads and engaged couplings come in addition:"));
    equation(texMatrix(rows, m_graph.t()) + " " + texColumn(torques));
    paragraph(translated(
        "The Matroid method's $Q$ has the same rows. A mesh is one edge there and has a chord to each gear "
        "here, so its column of $Q$ is that of the chord of the head's gear less that of the tail's:"));
    std::vector<std::vector<std::string>> texts(static_cast<std::size_t>(q->rows()));
    std::vector<std::string> edges;
    for (int column = 0; column < q->columns(); ++column) {
      edges.push_back("W_{" + std::to_string(q->columnHeading(column).label) + "}");
      for (int row = 0; row < q->rows(); ++row)
        texts[static_cast<std::size_t>(row)].push_back(std::to_string(q->entry(row, column)));
    }
    equation("Q \\, W = " + texMatrix(texts, q->partition()) + " " + texColumn(edges));
  }

  /// The chain from the loads back to the motors.
  void addChain(int firstCutset, int firstStep) {
    const LoadPower power = LoadPower::of(m_mechanism, m_model, m_placement, m_statics.problem);
    const auto torques = ttTorques(m_ttGraph, chordsOf(m_statics.held), power.byJoint);
    if (!torques || !torques->isBalanced || torques->steps.empty()) return;
    paragraph(translated(
        "The chain runs from the loads back to the motors: a cutset with one unknown left gives it, the "
        "terminal equation of its mesh the other torque."));
    int place = 0;
    for (const TtStaticStep& step : torques->steps) {
      if (isStopped() || place >= kMaxListed) return;
      const std::string by =
          step.joint < 0 ? "" : " \\quad (" + std::to_string(firstCutset + step.joint) + "^*)";
      if (step.mesh >= 0) {
        const auto at = static_cast<std::size_t>(step.mesh);
        if (torques->meshDetermined[at] == 0) continue;
        const TerminalPair& pair = *m_ttGraph.terminal(step.mesh);
        dualEquation(torqueName(tailChordName(pair)) + " = " + number(torques->tailPorts[at]) + " , \\quad " +
                         torqueName(headChordName(pair)) + " = " + number(torques->headPorts[at]) + by,
                     firstStep + place++, {meshId(step.mesh)});
        continue;
      }
      const auto chord = static_cast<std::size_t>(step.chord);
      const HeldPart& part = m_statics.held[chord];
      if (part.balance < 0 || torques->chordDetermined[chord] == 0) continue;
      const TorquePlace& at = m_statics.problem.balances[static_cast<std::size_t>(part.balance)];
      if (!at.inJoint()) continue;
      dualEquation(torque(at.joint) + " = " + number(torques->chords[chord]) + by, firstStep + place++,
                   {jointId(at.joint)});
    }
  }

  void addAgreement() {
    if (!m_statics.agreement) return;
    const std::optional<bool> inSymbols = m_statics.agreesInSymbols();
    paragraph(
        m_statics.agreement->equal
            ? translated("Torque by torque, both methods give the same fractions: all %1 entries agree.",
                         {std::to_string(m_statics.agreement->compared)})
            : translated("The two methods differ by up to %1 N m.",
                         {localizedNumber(shortDecimal(m_statics.agreement->largestDifference.number()))}));
    if (!inSymbols) return;
    paragraph(
        *inSymbols
            ? translated("In symbols, too: eliminated in the gear ratios, the cutsets of the T-T graph give "
                         "the torque matrix of (25) transposed, entry by entry.")
            : translated("In symbols the two torque matrices differ."));
  }

  const AnalysisSnapshot& m_snapshot;
  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const Digraph& m_graph;
  const TtGraph& m_ttGraph;
  const StaticsReport& m_statics;
};

}  // namespace

void addStaticsPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  if (snapshot.matroid() == nullptr || snapshot.mechanism->loads.empty() || stop.stop_requested()) return;
  if (hasErrors(snapshot.diagnostics)) return;
  const auto statics =
      analyzeStatics(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                     *snapshot.kinematics->ttGraph, *snapshot.matroid(), StaticsOptions{}, stop);
  if (!statics || !statics->isSolved) return;
  StaticsPart(report, snapshot, *statics, stop).add();
}

}  // namespace geargraph
