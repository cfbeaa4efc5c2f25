#include <cstdlib>
#include <numeric>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/derivation/result_text.h"
#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {
namespace {

/// "\frac{5}{2 \pi}" and the like. @pre a single term
std::string latexOfRatio(const PiNumber& ratio) {
  if (ratio.isRational()) return readableLatex(ratio.rational());
  const PiNumber::Term& term = ratio.terms().front();
  const int power = std::abs(term.power);
  const std::string pi = power == 1 ? "\\pi" : "\\pi^{" + std::to_string(power) + "}";
  const std::string factor = readableLatex(term.factor);
  return term.power > 0 ? factor + " " + pi : factor + " \\frac{1}{" + pi + "}";
}

class MatroidPart : private ReportPart {
 public:
  MatroidPart(Report& report, const SnapshotPtr& snapshot, const std::stop_token& stop)
      : ReportPart(report, stop),
        m_pointer(snapshot),
        m_snapshot(*snapshot),
        m_graph(*snapshot->graph),
        m_matroid(*snapshot->matroid()) {}

  void add() {
    heading(1, toTranslate("Matroid method"));
    addScrews();
    if (!isStopped()) addCoefficients();
    addFreedom();
    if (m_matroid.solution && !isStopped()) addSolution();
  }

 private:
  [[nodiscard]] std::string label(int edge) const { return std::to_string(m_graph.edgeLabel(edge)); }

  [[nodiscard]] ElementId elementOf(JointOrdinal joint) const {
    return m_snapshot.mechanism->turningJoints[joint].id;
  }
  [[nodiscard]] std::vector<ElementId> elementsOf(const std::vector<int>& joints) const {
    std::vector<ElementId> elements;
    for (const JointOrdinal joint : joints) elements.push_back(elementOf(joint));
    return elements;
  }

  [[nodiscard]] std::vector<int> allJoints() const {
    std::vector<int> joints(static_cast<std::size_t>(m_graph.t()));
    std::iota(joints.begin(), joints.end(), 0);
    return joints;
  }

  /// The best form that is there: fractions, else decimals.
  [[nodiscard]] ResultTablePtr numbers(std::string_view name) const {
    return exactTable(*resultNamed(name), {m_pointer});
  }
  [[nodiscard]] ResultTablePtr inRatios(std::string_view name) const {
    return resultTable(*resultNamed(name), {m_pointer}, EntryForm::symbols);
  }
  static bool fits(const ResultTable& table) {
    return table.rows() > 0 && table.rows() <= kMaxReportRows && table.columns() > 0 &&
           table.columns() <= kMaxReportColumns;
  }
  void addTable(const ResultTablePtr& table, const std::string& before, const std::string& after,
                PaperEquation number) {
    if (table == nullptr || table->rows() == 0) return;
    if (fits(*table)) {
      return equation(before + (after.empty() ? readableLatex(*table) : texMatrix(*table)) + after, number);
    }
    paragraph(tooManyEntries(table->rows(), table->columns(), table->result().name));
  }

  void addScrews() {
    heading(2, toTranslate("Screws"));
    paragraph(translated(
        "The screw of joint $k$ about the pitch point of mesh $c$ is the unit vector along the joint's axis, "
        "$u_k$, "
        "with its moment about that point, $r_{c,k} = l_{c,k} \\times u_k$, where $l_{c,k}$ leads from the "
        "pitch "
        "point to the axis:"));
    equation(
        "\\hat{u}_{c,k} = \\begin{pmatrix} u_k \\\\ r_{c,k} \\end{pmatrix} = \\begin{pmatrix} L_k & M_k & "
        "N_k & "
        "P_{c,k} & Q_{c,k} & R_{c,k} \\end{pmatrix}^T",
        PaperEquation::screw);
    addDirections();
    addMoments();
    const ResultTablePtr screws = numbers("screw");
    if (screws == nullptr || screws->rows() == 0) return;
    paragraph(translated("For the joints of each cycle, lengths in %1:", {m_snapshot.mechanism->unit}));
    addTable(screws, "", "", PaperEquation::none);
  }

  /// Are all axes parallel to the plane of y and z, so that offset angles about x describe them? [AU, Eq.
  /// (8)]
  [[nodiscard]] bool hasOffsetAngles() const {
    const Placement& placement = m_snapshot.kinematics->placement();
    const int classes = static_cast<int>(placement.classes->classes.size());
    for (AxisGroupOrdinal axisGroup = 0; axisGroup < classes; ++axisGroup)
      if (!exactLineOfClass(*m_snapshot.mechanism, placement, axisGroup).direction[0].isZero()) return false;
    return true;
  }

  /// Eqs. (7)-(9).
  void addDirections() {
    const bool hasAngles = hasOffsetAngles();
    paragraph(
        hasAngles
            ? translated("Each direction is the $z$ axis, turned about $x$ by the offset angle $\\varphi_k$:")
            : translated("Each direction is the $z$ axis, turned by a rotation $D_{0,k}$:"));
    equation("u_k = D_{0,k} \\begin{pmatrix} 0 & 0 & 1 \\end{pmatrix}^T", PaperEquation::jointDirection);
    if (!hasAngles) return equation("L_k^2 + M_k^2 + N_k^2 = 1", PaperEquation::directionComponents);
    equation(
        "D_{0,k} = \\left[ \\begin{array}{ccc} 1 & 0 & 0 \\\\ 0 & \\cos\\varphi_k & -\\sin\\varphi_k \\\\ 0 "
        "& "
        "\\sin\\varphi_k & \\cos\\varphi_k \\end{array} \\right]",
        PaperEquation::offsetRotation);
    equation("L_k = 0 , \\quad M_k = -\\sin\\varphi_k , \\quad N_k = \\cos\\varphi_k",
             PaperEquation::directionComponents);
  }

  /// Eqs. (10)-(12), the last for any direction.
  void addMoments() {
    paragraph(translated("The moment needs the way from the pitch point to a point of the axis:"));
    equation("r_{c,k} = l_{c,k} \\times u_k", PaperEquation::moment);
    equation("l_{c,k} = \\begin{pmatrix} x_k - x_c & y_k - y_c & z_k - z_c \\end{pmatrix}^T",
             PaperEquation::offsetVector);
    equation(
        "P_{c,k} = y_{c,k} N_k - z_{c,k} M_k , \\quad Q_{c,k} = z_{c,k} L_k - x_{c,k} N_k , \\quad R_{c,k} = "
        "x_{c,k} M_k - y_{c,k} L_k",
        PaperEquation::momentComponents);
  }

  void addCoefficients() {
    heading(2, toTranslate("Equations of the meshes"));
    paragraph(translated("The twist of a joint is its screw times its rate:"));
    equation("\\hat{s}_k = \\hat{u}_{c,k} \\, \\dot{\\theta}_k", PaperEquation::twist);
    paragraph(translated("Along each cycle the twists, with their signs in $C$, add up to zero:"));
    equation("\\left[ C \\circ \\hat{s}_k \\right] = 0_c", PaperEquation::twistSums);
    paragraph(translated(
        "Their directions give the velocity of one gear of each mesh relative to the other. The mesh "
        "has no moment about its own pitch point, so the moments of the turning joints alone add up "
        "to zero:"));
    equation("\\dot{\\theta}_c = -\\left[ T \\circ u_t \\right] \\dot{\\theta}_t",
             PaperEquation::meshVelocities);
    equation("\\left[ T \\circ r_{c,t} \\right] \\dot{\\theta}_t = 0_c", PaperEquation::momentSums);
    paragraph(translated(
        "They all point along one line: the normal of the plane that holds both axes of the mesh. One number "
        "of each "
        "is enough, its component $P_{c,t}$ along that normal, and each mesh gives one equation:"));
    equation("\\left[ P_{c,t} \\right] \\dot{\\theta}_t = 0_c", PaperEquation::meshEquations);
    equation("P_{c,t} = \\left[ T \\circ P_{c,t} \\right]", PaperEquation::coefficientMatrix);
    paragraph(translated("With lengths in %1,", {m_snapshot.mechanism->unit}));
    addTable(numbers("p"), "", " " + rateColumn(m_graph, allJoints()) + " = 0",
             PaperEquation::coefficientsInNumbers);
    addRatios();
  }

  void addRatios() {
    if (m_graph.c() == 0) return;
    paragraph(translated(
        "The entries of a row are the radii of its two gears. Divided by the radius of the head's gear, the "
        "ratios "
        "are left:"));
    const CoefficientMatrix matrix(*m_snapshot.mechanism, *m_snapshot.kinematics->model,
                                   m_snapshot.kinematics->placement());
    std::vector<std::string> lines;
    std::vector<ElementId> meshes;
    for (MeshOrdinal mesh = 0; mesh < m_graph.c() && mesh < kMaxListed; ++mesh) {
      const GearMesh& teeth = m_snapshot.mechanism->gearMeshes[mesh];
      meshes.emplace_back(teeth.id);
      const DigraphEdge& gears = m_graph.meshEdge(mesh);
      if (slides(saidKind(teeth))) {
        lines.push_back("i_{" + label(m_graph.t() + mesh) + "} = " + latexOfRatio(matrix.piRatio(mesh)));
        continue;
      }
      const std::string counts =
          "\\frac{" + std::to_string(teeth.tailTeeth) + "}{" + std::to_string(teeth.headTeeth) + "}";
      const std::string ratio = readableLatex(matrix.ratio(mesh));
      lines.push_back("i_{" + label(m_graph.t() + mesh) + "} = \\frac{N_{" + std::to_string(gears.tail) +
                      "}}{N_{" + std::to_string(gears.head) + "}} = " + counts +
                      (ratio == counts ? "" : " = " + ratio));
    }
    equation(texLines(lines), PaperEquation::gearRatios, std::move(meshes));
  }

  /// "brake A: \dot{\theta}_{14} = 0", a line for each equation of the engaged couplings.
  void addHeld() {
    const std::vector<KinematicModel::HeldRow>& held = m_snapshot.kinematics->model->held();
    if (held.empty()) return;
    heading(2, toTranslate("Engaged couplings"));
    paragraph(translated(
        "An engaged brake holds its link against the ground, an engaged clutch makes two links turn as one. "
        "The rates of the joints between them add up to zero, once for each direction of their axes: rows "
        "below those of the meshes, which stay as they are."));
    ReportTable table{{translated("Coupling"), translated("Equation")}, {}};
    for (const KinematicModel::HeldRow& row : held) {
      const ShiftElement& coupling = m_snapshot.mechanism->couplings[row.coupling];
      std::string sum;
      for (const KinematicModel::HeldRow::Term& term : row.joints) {
        sum += term.factor < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
        sum += rateName(m_graph, term.of);
      }
      table.rows.push_back(
          {plainWords(couplingName(coupling.kind, coupling.id.text())), reportWords("$" + sum + " = 0$")});
    }
    put(std::move(table));
  }

  static const char* inputsText(bool isOne, bool areGiven) {
    if (areGiven)
      return isOne ? toTranslate("The input is joint %1.") : toTranslate("The inputs are joints %1.");
    return isOne
               ? toTranslate("The input is joint %1, chosen by the program because the document names none.")
               : toTranslate(
                     "The inputs are joints %1, chosen by the program because the document names none.");
  }

  void addFreedom() {
    addHeld();
    heading(2, toTranslate("Freedom and inputs"));
    const bool isHeld = !m_snapshot.kinematics->model->held().empty();
    const std::string rank = std::to_string(m_matroid.rank);
    paragraph(
        isHeld
            ? translated("The rank of $P$ with the rows of the couplings, in exact arithmetic, is $r = %1$. "
                         "The mechanism therefore has",
                         {rank})
            : translated("The rank of $P$, in exact arithmetic, is $r = %1$. The mechanism therefore has",
                         {rank}));
    equation("E = t - r = " + std::to_string(m_graph.t()) + " - " + std::to_string(m_matroid.rank) + " = " +
                 std::to_string(m_matroid.dof),
             PaperEquation::freedom);
    if (m_matroid.kutzbachDof != m_matroid.dof) {
      const int equations = m_snapshot.kinematics->model->equations();
      const std::string count = std::to_string(m_matroid.kutzbachDof);
      const std::string following = std::to_string(equations - m_matroid.rank);
      paragraph(
          isHeld ? translated("degrees of freedom. Kutzbach's count $n - c - h = %1$, with the $h$ rows of "
                              "couplings, differs, because %2 of the equations follow from the others.",
                              {count, following})
                 : translated("degrees of freedom. Kutzbach's count $n - c = %1$ differs, because the "
                              "equations of %2 of the meshes follow from the others.",
                              {count, following}));
    } else {
      paragraph(translated("degrees of freedom: as many inputs have to be given."));
    }
    if (!m_matroid.solution) return;
    std::vector<std::string> names;
    for (const JointOrdinal joint : m_matroid.solution->inputs) names.push_back(label(joint));
    if (names.empty()) return;
    paragraph(
        filled(translated(inputsText(names.size() == 1, m_matroid.inputsGiven)), {listed(names, kAllNames)}));
  }

  void addSolution() {
    heading(2, toTranslate("Solution"));
    const LiveSolution& solution = *m_matroid.solution;
    if (solution.outputs.empty()) return;
    const bool symbols = m_snapshot.solved && m_snapshot.solved->symbolic;
    if (!solution.inputs.empty()) {
      paragraph(translated(
          "With the inputs first, the equations are parted into columns of the inputs and of the outputs:"));
      equation(
          "\\left[ \\begin{array}{c|c} P_E & P_r \\end{array} \\right] \\begin{pmatrix} \\dot{\\theta}_E "
          "\\\\ "
          "\\dot{\\theta}_r \\end{pmatrix} = 0",
          PaperEquation::partedEquations);
    }
    paragraph(translated("Solved for the outputs,"));
    equation("\\dot{\\theta}_r = -P_r^{-1} P_E \\, \\dot{\\theta}_E", PaperEquation::solutionByInverse);
    if (isStopped()) return;
    if (!solution.inputs.empty() && symbols) {
      paragraph(translated("With the inputs first, and in gear ratios, the equations are"));
      std::vector<int> joints = solution.inputs;
      joints.insert(joints.end(), solution.outputs.begin(), solution.outputs.end());
      addTable(inRatios("p"), "", " " + rateColumn(m_graph, joints) + " = 0",
               PaperEquation::equationsInRatios);
    }
    if (solution.inputs.empty()) {
      return paragraph(translated("there is nothing that turns: without a freedom all rates are $0$."));
    }
    const std::string left = rateColumn(m_graph, solution.outputs) + " =\n";
    const std::string right = " " + rateColumn(m_graph, solution.inputs);
    if (const auto table = inRatios("solution")) {
      paragraph(translated("and their solution is"));
      addTable(table, left, right, PaperEquation::matroidSolution);
    } else if (symbols) {
      addRecurrence();
    }
    if (isStopped()) return;
    paragraph(translated("With the teeth of this mechanism:"));
    addTable(numbers("solution"), left, right, PaperEquation::none);
    addRates();
  }

  /// Where whole entries are too long to read.
  void addRecurrence() {
    paragraph(
        translated("Written out, some entries are too long to read. One joint after the other they are"));
    std::vector<std::string> lines;
    std::vector<ElementId> joints;
    for (const SymbolicLine& line : m_snapshot.solved->symbolic->lines) {
      if (isStopped()) return;
      std::string sum;
      for (const SymbolicLine::Term& term : line.terms) {
        std::string factor = term.coefficient.toLatex();
        const bool negative = factor.front() == '-';
        const bool isSum =
            factor.find(' ', 1) != std::string::npos && factor.find_first_of("+-", 1) != std::string::npos;
        if (isSum) factor = "\\left( " + factor + " \\right)";
        if (factor == "1") factor.clear();
        if (factor == "-1") factor = "-";
        sum += (sum.empty() || (negative && !isSum) ? " " : " + ") + factor + " " +
               rateName(m_graph, term.joint);
      }
      joints.push_back(elementOf(line.joint));
      lines.push_back(rateName(m_graph, line.joint) + " =" + (sum.empty() ? " 0" : sum));
    }
    equation(texLines(lines), PaperEquation::matroidSolution, std::move(joints));
  }

  void addRates() {
    if (!m_snapshot.solved || !m_snapshot.solved->exact) return;
    const ExactSolution& exact = *m_snapshot.solved->exact;
    if (exact.outputs.size() > static_cast<std::size_t>(kMaxListed)) return;
    const auto lines = [&](const std::vector<int>& joints) {
      std::vector<std::string> texts;
      for (const JointOrdinal joint : joints) {
        texts.push_back(rateName(m_graph, joint) + " = " + readableLatex(exact.rates[joint]));
      }
      return texts;
    };
    paragraph(translated("At these speeds of the inputs, in rad/s,"));
    equation(texLines(lines(exact.inputs)), PaperEquation::none, elementsOf(exact.inputs));
    paragraph(translated("the outputs turn at"));
    equation(texLines(lines(exact.outputs)), PaperEquation::none, elementsOf(exact.outputs));
  }

  SnapshotPtr m_pointer;
  const AnalysisSnapshot& m_snapshot;
  const Digraph& m_graph;
  const MatroidAnalysis& m_matroid;
};

}  // namespace

void addMatroidPart(Report& report, const SnapshotPtr& snapshot, const std::stop_token& stop) {
  if (snapshot->matroid() != nullptr && !stop.stop_requested()) MatroidPart(report, snapshot, stop).add();
}

}  // namespace geargraph
