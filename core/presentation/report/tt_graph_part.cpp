#include <algorithm>
#include <map>
#include <numeric>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/theory/ttgraph/equations.h"
#include "core/theory/ttgraph/mesh_words.h"

namespace geargraph {
namespace {

class TtGraphPart : private ReportPart {
 public:
  TtGraphPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop)
      : ReportPart(report, stop),
        m_snapshot(snapshot),
        m_graph(*snapshot.kinematics->ttGraph),
        m_digraph(m_graph.graph()) {}

  void add() {
    heading(1, toTranslate("T-T graph method"));
    addLevels();
    addCarriers();
    if (!m_graph.isComplete() || m_graph.equations() == 0) return;
    addEquations();
    addHeld();
    if (m_snapshot.solved && m_snapshot.solved->ttSteps) addSteps();
  }

 private:
  [[nodiscard]] ElementId meshId(MeshOrdinal mesh) const { return m_snapshot.mechanism->gearMeshes[mesh].id; }
  [[nodiscard]] ElementId jointId(JointOrdinal joint) const {
    return m_snapshot.mechanism->turningJoints[joint].id;
  }
  [[nodiscard]] const SolvedKinematics& solved() const { return *m_snapshot.solved; }

  void addLevels() {
    heading(2, toTranslate("Levels"));
    paragraph(translated(
        "The turning joints are the branches of the graph's tree. Each carries the letter of its axis, its "
        "level."));
    const AxisLevels& levels = m_graph.levels();
    std::map<int, std::vector<std::string>> joints;
    for (JointOrdinal joint = 0; joint < m_digraph.t(); ++joint) {
      joints[levels.ofJoint[joint]].push_back(std::to_string(m_digraph.edgeLabel(joint)));
    }
    ReportTable table{{translated("Level"), translated("Turning joints")}, {}};
    for (const auto& [level, labels] : joints) {
      table.rows.push_back({plainWords(levels.name(level)), plainWords(listed(labels, kAllNames))});
    }
    put(std::move(table));
    put(ReportFigure{ReportDrawing::ttGraph, translated("T-T graph")});
  }

  void addCarriers() {
    if (m_digraph.c() == 0) return;
    heading(2, toTranslate("Carriers"));
    paragraph(translated(
        "From one gear of a mesh through the branches to the other, the level changes at one link: the "
        "transfer "
        "vertex, which carries both gears. A mesh is written as its gear pair and its carrier."));
    ReportTable table{{translated("Mesh"), translated("Walk"), translated("Pair and carrier")}, {}};
    for (MeshOrdinal mesh = 0; mesh < m_digraph.c(); ++mesh) {
      const std::string label = std::to_string(m_digraph.edgeLabel(m_digraph.t() + mesh));
      if (const auto words = meshWords(m_graph, mesh)) {
        table.rows.push_back({plainWords(label), plainWords(words->path), plainWords(words->set)});
      } else {
        table.rows.push_back({plainWords(label), plainWords(translated("no transfer vertex")), {}});
      }
    }
    put(std::move(table));
  }

  void addEquations() {
    const SubstitutionPlan none;
    const TtEquations equations(m_graph, m_snapshot.solved ? solved().ttPlan : none, RatioNaming::ttGraph,
                                FormulaStyle::latex);
    const EquationNumbers numbers(m_graph, unknowns());
    if (m_digraph.c() == 0) return;
    heading(2, toTranslate("Terminal equations"));
    paragraph(translated(
        "Seen from its carrier, one gear of a pair turns as fast as the other times the ratio of their "
        "teeth, with "
        "a plus sign where both turn the same way, each seen along its own axis:"));
    equation(
        "\\omega_{ik} = \\pm n_{ji} \\, \\omega_{jk} , \\quad n_{ji} = \\frac{N_j}{N_i} = \\frac{1}{n_{ij}}",
        PaperEquation::gearRelation);
    for (MeshOrdinal mesh = 0; mesh < m_digraph.c(); ++mesh)
      equation(equations.terminal(mesh), numbers.terminal(mesh), {meshId(mesh)});
    heading(2, toTranslate("Fundamental circuits"));
    paragraph(translated(
        "Each of these velocities closes a circuit with branches of the tree, and is the sum along the "
        "branches:"));
    std::map<int, std::pair<std::string, int>> circuits;  // by number: those of several branches come first
    for (MeshOrdinal mesh = 0; mesh < m_digraph.c() && !isStopped(); ++mesh) {
      circuits[numbers.tailCircuit(mesh)] = {equations.tailCircuit(mesh), mesh};
      circuits[numbers.headCircuit(mesh)] = {equations.headCircuit(mesh), mesh};
    }
    for (auto& [number, circuit] : circuits) {
      equation(std::move(circuit.first), number, {meshId(circuit.second)});
    }
  }

  void addHeld() {
    if (m_graph.held().empty()) return;
    const SubstitutionPlan none;
    const TtEquations equations(m_graph, m_snapshot.solved ? solved().ttPlan : none, RatioNaming::ttGraph,
                                FormulaStyle::latex);
    const EquationNumbers numbers(m_graph, unknowns());
    heading(2, toTranslate("Engaged couplings"));
    paragraph(translated(
        "An engaged brake or clutch is one more edge of the graph, from the link that it holds to the ground "
        "or to the other link. Its velocity is zero, so the branches of its fundamental circuit add up to "
        "zero, once for each direction of their axes:"));
    for (int place = 0; place < static_cast<int>(m_graph.held().size()); ++place) {
      const auto coupling =
          static_cast<std::size_t>(m_graph.held()[static_cast<std::size_t>(place)].coupling);
      equation(equations.heldCircuit(place), numbers.heldCircuit(place),
               {m_snapshot.mechanism->couplings[coupling].id});
    }
  }

  [[nodiscard]] int unknowns() const {
    return m_snapshot.solved ? static_cast<int>(solved().ttPlan.outputs.size()) : 0;
  }

  void addSteps() {
    heading(2, toTranslate("Solution by substitution"));
    const TtEquations equations(m_graph, solved().ttPlan, RatioNaming::ttGraph, FormulaStyle::latex);
    std::vector<std::string> given;
    for (const JointOrdinal joint : solved().ttPlan.inputs) given.push_back("$" + branch(joint) + "$");
    if (!given.empty()) {
      const std::string names = listed(given, kAllNames);
      paragraph(
          (given.size() == 1 ? translated("Given is %1.", {names}) : translated("Given are %1.", {names})) +
          ' ' +
          (m_graph.held().empty() ? translated("Mesh by mesh, the equations give the others.")
                                  : translated("One after the other, the equations give the others.")));
    }
    for (const SubstitutionStep& step : *solved().ttSteps) {
      if (isStopped()) return;
      const std::string unknown = "$" + branch(step.joint) + "$";
      paragraph(step.coupled ? filled(translated(coupledText(step)), {unknown}) : citing(step, unknown));
      equation(texStages(equations.stages(step)), step.number, {jointId(step.joint)});
    }
    addMatrices();
  }

  [[nodiscard]] static std::string citing(const SubstitutionStep& step, const std::string& unknown) {
    const std::string cited = citedEquations(step.uses);
    return step.uses.size() == 1 ? translated("Equation %1 gives %2:", {cited, unknown})
                                 : translated("Equations %1 give %2:", {cited, unknown});
  }

  [[nodiscard]] const char* coupledText(const SubstitutionStep& step) const {
    const bool held = !step.equations.empty() && step.equations.back() >= m_digraph.c();
    return held ? toTranslate("The equations of several meshes and couplings, solved together, give %1:")
                : toTranslate("The equations of several meshes, solved together, give %1:");
  }

  /// Eqs. (43)-(45).
  void addMatrices() {
    const SubstitutionPlan& plan = solved().ttPlan;
    if (plan.inputs.empty() || plan.outputs.size() > static_cast<std::size_t>(kMaxReportRows) ||
        plan.inputs.size() > static_cast<std::size_t>(kMaxReportColumns)) {
      return;
    }
    const EquationNumbers numbers(m_graph, unknowns());
    const std::vector<std::size_t> order = rowsByLink();
    std::vector<int> outputs;
    for (const std::size_t row : order) outputs.push_back(plan.outputs[row]);
    const std::string left = branches(outputs) + " =\n";
    const std::string right = " " + branches(plan.inputs);
    if (const auto matrix = stepMatrix(outputs)) {
      paragraph(translated("Together:"));
      equation(left + texMatrix(*matrix) + right, numbers.matrix());
    }
    if (!solved().ttSymbolic) return;
    std::vector<std::vector<std::string>> rows;
    for (const std::size_t row : order) {
      rows.emplace_back();
      for (const auto& entry : solved().ttSymbolic->entries[row]) {
        if (!entry || isStopped()) return;
        rows.back().push_back(entry->toLatex());
      }
    }
    paragraph(translated("With the names of the ratios that the matroid method uses,"));
    std::vector<std::string> same;
    for (const RatioNames& names : ratioNames(m_digraph)) {
      same.push_back(names.latex + " = i_{" + names.matroid.substr(1) + "}");
    }
    equation(texLines(same), numbers.names());
    paragraph(translated("this is"));
    equation(left + texMatrix(rows) + right, numbers.result());
  }

  /// The rows of (43) and (45) are by link, as in the paper; the outputs of the plan are by joint.
  [[nodiscard]] std::vector<std::size_t> rowsByLink() const {
    const std::vector<int>& outputs = solved().ttPlan.outputs;
    std::vector<std::size_t> rows(outputs.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::ranges::stable_sort(rows, {},
                             [&](std::size_t row) { return m_digraph.turningEdge(outputs[row]).head; });
    return rows;
  }

  /// The last sides of the steps, a row for each output; none where one of them went over the budget.
  [[nodiscard]] std::optional<std::vector<std::vector<std::string>>> stepMatrix(
      const std::vector<int>& outputs) const {
    std::map<int, const SubstitutionStep*> of;
    for (const SubstitutionStep& step : *solved().ttSteps) of[step.joint] = &step;
    std::vector<std::vector<std::string>> rows;
    for (const int output : outputs) {
      const auto step = of.find(output);
      if (step == of.end()) return std::nullopt;
      rows.emplace_back();
      for (const auto& entry : step->second->after) {
        if (!entry || isStopped()) return std::nullopt;
        rows.back().push_back(entry->toLatex());
      }
    }
    return rows;
  }

  [[nodiscard]] std::string branch(JointOrdinal joint) const {
    return branchName(m_digraph, joint).toLatex();
  }
  [[nodiscard]] std::string branches(const std::vector<int>& joints) const {
    std::vector<std::string> names;
    for (const JointOrdinal joint : joints) names.push_back(branch(joint));
    return texColumn(names);
  }

  const AnalysisSnapshot& m_snapshot;
  const TtGraph& m_graph;
  const Digraph& m_digraph;
};

}  // namespace

void addTtGraphPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const bool isDefined = snapshot.kinematics && snapshot.mechanism->t() > 0;
  if (isDefined && !stop.stop_requested()) TtGraphPart(report, snapshot, stop).add();
}

}  // namespace geargraph
