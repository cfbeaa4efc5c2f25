#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/derivation/comparison_families.h"
#include "core/theory/ttgraph/notation.h"

namespace geargraph {
namespace {

/// Both methods side by side [AU, section 5], counted on this mechanism.
class ComparisonPart : private ReportPart {
 public:
  ComparisonPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop)
      : ReportPart(report, stop), m_snapshot(snapshot), m_graph(*snapshot.graph), m_token(stop) {}

  void add() {
    if (!m_snapshot.solved || !m_snapshot.solved->agreement) return;
    heading(1, kComparisonHeading);
    addAgreement(*m_snapshot.solved->agreement);
    const auto comparison = compareMethods(m_snapshot, ComparisonDepth::symbols, m_token);
    if (!comparison) return;
    addSteps();
    addMeshes(*comparison);
    addCounts(*comparison);
    if (isStopped()) return;
    addFamilies();
    addClaims(*comparison);
  }

 private:
  void addAgreement(const Agreement& agreement) {
    if (agreement.equal) {
      return paragraph(translated("Both methods give the same fractions: all %1 entries agree.",
                                  {std::to_string(agreement.compared)}));
    }
    paragraph(
        translated("The two methods differ by up to %1.", {readableNumber(agreement.largestDifference)}));
  }

  void addSteps() {
    heading(2, toTranslate("Step by step"));
    ReportTable table{
        {"", translated("Matroid method"), translated("T-T graph method"), translated("Relation")}, {}};
    for (const ComparedStep& step : comparedSteps()) {
      table.rows.push_back({plainWords(step.name), reportWords(step.matroid), reportWords(step.ttGraph),
                            reportWords(step.relationWords)});
    }
    put(std::move(table));
  }

  void addMeshes(const MethodComparison& comparison) {
    heading(2, toTranslate("Mesh by mesh"));
    paragraph(translated(
        "For each mesh, above: its row of $P$, divided by the radius of the head's gear. Below: its terminal "
        "equation with both circuits put in, times $N_{tail} / N_{head}$."));
    int listed = 0;
    for (const ComparedMesh& mesh : comparison.perMesh) {
      if (isStopped() || ++listed > kMaxListed) return;
      equation(texLines({row(mesh, true), row(mesh, false)}), std::nullopt,
               {m_snapshot.mechanism->gearMeshes[mesh.mesh].id});
    }
  }

  [[nodiscard]] std::string label(int edge) const { return std::to_string(m_graph.edgeLabel(edge)); }

  /// "i_{15} \dot{\theta}_8 + \dot{\theta}_{10} = 0"; a coefficient that is no ratio is 1.
  [[nodiscard]] std::string row(const ComparedMesh& mesh, bool ofMatroid) const {
    std::string text;
    for (const ComparedMesh::Term& term : mesh.terms) {
      const Rational& value = ofMatroid ? term.matroid : term.ttGraph;
      if (value.isZero()) continue;
      const bool isNegative = value.sign() < 0;
      if (!text.empty() || isNegative) text += isNegative ? (text.empty() ? "-" : " - ") : " + ";
      if (onTail(mesh, term)) text += "i_{" + label(m_graph.t() + mesh.mesh) + "} ";
      text += ofMatroid ? rateName(m_graph, term.joint) : branchName(m_graph, term.joint).toLatex();
    }
    return text + " = 0";
  }
  [[nodiscard]] bool onTail(const ComparedMesh& mesh, const ComparedMesh::Term& term) const {
    const Placement& placement = m_snapshot.kinematics->placement();
    const MeshGeometry& geometry = *placement.meshes[mesh.mesh];
    return placement.classes->classOf[term.joint] == geometry.tailClass;
  }

  static double countOf(const Operations& operations) {
    return static_cast<double>(operations.products + operations.sums);
  }
  static std::string countText(const Operations& operations) {
    return productsText(operations) + ", " + sumsText(operations);
  }
  static std::string countText(const std::optional<Operations>& operations) {
    return operations ? countText(*operations) : translated("too long to write");
  }

  void addCounts(const MethodComparison& comparison) {
    heading(2, toTranslate("Counted"));
    paragraph(translated(
        "Products and quotients, sums and differences of the calculation by hand for this mechanism; those "
        "with "
        "$0$ and $\\pm 1$ cost nothing."));
    const MethodSize& matroid = comparison.matroid;
    const MethodSize& ttGraph = comparison.ttGraph;
    ReportTable table{{"", translated("Matroid method"), translated("T-T graph method")}, {}};
    const auto add = [&](const char* what, const std::string& left, const std::string& right) {
      table.rows.push_back({plainWords(translated(what)), reportWords(left), reportWords(right)});
    };
    const auto number = [](long long value) { return "$" + std::to_string(value) + "$"; };
    const auto size = [](const MethodSize& of) {
      return "$" + std::to_string(of.rows) + " \\times " + std::to_string(of.columns) + "$";
    };
    add(toTranslate("Unknowns"), number(matroid.unknowns), number(ttGraph.unknowns));
    add(toTranslate("Equations"), number(matroid.equations), number(ttGraph.equations));
    add(toTranslate("Matrix of the equations"), size(matroid), size(ttGraph));
    add(toTranslate("Entries that are not 0"), number(matroid.nonZeros), number(ttGraph.nonZeros));
    add(toTranslate("From the drawing to the equations"), countText(matroid.setUp), countText(ttGraph.setUp));
    add(toTranslate("From the equations to the solution"), countText(matroid.numbers),
        countText(ttGraph.numbers));
    add(toTranslate("The same in gear ratios"), countText(matroid.symbols), countText(ttGraph.symbols));
    put(std::move(table));
  }

  void addFamilies() {
    heading(2, toTranslate("With more links"));
    paragraph(translated(
        "The same counted on larger trains. The chain of substitutions grows with the number of meshes times "
        "that of the inputs; the inverse of $P_r$ holds all products along the way and grows with its "
        "square."));
    ReportTable table{{translated("Train"), translated("Moving links"), translated("Meshes"),
                       translated("Inverse and product"), translated("Substitution")},
                      {}};
    for (const FamilyCount& count : familyCounts()) {
      table.rows.push_back({plainWords(familyText(count.family, count.size)),
                            plainWords(std::to_string(count.links)), plainWords(std::to_string(count.meshes)),
                            reportWords(countText(count.matroid)), reportWords(countText(count.ttGraph))});
    }
    put(std::move(table));
    put(ReportCurves{familyCharts(),
                     translated("Multiplications and additions from the equations to the solution")});
  }

  /// A chart for each family, over the number of moving links.
  static std::vector<CurveChart> familyCharts() {
    std::vector<CurveChart> charts;
    for (const TrainFamily family : {TrainFamily::chain, TrainFamily::stack, TrainFamily::wrist}) {
      CurveChart chart{familyName(family),
                       translated("moving links"),
                       {{translated("Inverse and product"), {}}, {translated("Substitution"), {}}}};
      for (const FamilyCount& count : familyCounts()) {
        if (count.family != family) continue;
        const double links = count.links;
        chart.curves[0].points.push_back({links, countOf(count.matroid)});
        chart.curves[1].points.push_back({links, countOf(count.ttGraph)});
      }
      charts.push_back(std::move(chart));
    }
    return charts;
  }

  void addClaims(const MethodComparison& comparison) {
    heading(2, toTranslate("What the paper concludes"));
    for (const ComparedClaim& claim : claimsOf(comparison)) {
      paragraph(claim.claim);
      ReportList evidence;
      for (const std::string& each : claim.evidenceFor)
        evidence.items.push_back(reportWords(translated("For it: %1", {each})));
      for (const std::string& each : claim.evidenceAgainst)
        evidence.items.push_back(reportWords(translated("Against it: %1", {each})));
      put(std::move(evidence));
    }
  }

  const AnalysisSnapshot& m_snapshot;
  const Digraph& m_graph;
  std::stop_token m_token;
};

}  // namespace

void addComparisonPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  if (!stop.stop_requested()) ComparisonPart(report, snapshot, stop).add();
}

}  // namespace geargraph
