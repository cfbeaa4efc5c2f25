#include <unordered_map>

#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/derivation/matrix_text.h"

namespace geargraph::inline report {
namespace {

std::string counted(int count, const char* one, const char* many) {
  return "$" + std::to_string(count) + "$ " + (count == 1 ? one : many);
}

class DigraphPart : private ReportPart {
 public:
  DigraphPart(Report& report, const AnalysisSnapshot& snapshot)
      : ReportPart(report), m_snapshot(snapshot), m_mechanism(*snapshot.mechanism) {
    for (int i = 0; i <= m_mechanism.n(); ++i) {
      m_labels[m_mechanism.links[static_cast<std::size_t>(i)].id] = std::to_string(m_mechanism.linkLabel(i));
    }
  }

  void addMechanism() {
    heading(1, "The mechanism");
    if (!m_mechanism.notes.empty()) put(ReportParagraph{plainWords(m_mechanism.notes)});
    const int n = m_mechanism.n(), t = m_mechanism.t(), c = m_mechanism.c();
    paragraph("It has " + counted(n, "moving link", "moving links") + " ($n = " + std::to_string(n) + "$), " +
              counted(t, "turning joint", "turning joints") + " ($t = " + std::to_string(t) + "$) and " +
              counted(c, "gear mesh", "gear meshes") + " ($c = " + std::to_string(c) +
              "$), $k = t + c = " + std::to_string(t + c) +
              "$ joints in all. The ground is link 0; the other links, the turning joints and the meshes are "
              "numbered on from there.");
    addLinks();
    addJoints();
    addMeshes();
    put(ReportFigure{ReportDrawing::schematic, "Functional schematic"});
  }

  void addMatrices() {
    heading(1, "Digraph and matrices");
    paragraph(
        "Each link becomes a node, each turning joint a solid arrow from its tail to its head, each gear "
        "mesh a "
        "dashed one.");
    put(ReportFigure{ReportDrawing::digraph, "Digraph"});
    matrix(MatrixKind::incidence, "\\Gamma^0",
           "In the incidence matrix an edge's column holds $-1$ in the row of the link that it leaves and "
           "$1$ in "
           "the row of the link that it reaches.");
    matrix(
        MatrixKind::reducedIncidence, "\\Gamma = \\left[ G \\mid G^* \\right]",
        "Without the row of the ground its rows are independent: $G$ for the turning joints, $G^*$ for the "
        "meshes.");
    if (m_snapshot.tree == nullptr) {
      return paragraph(
          "The turning joints are no spanning tree of this digraph, so there is nothing more to derive: see "
          "the "
          "findings above.");
    }
    matrix(MatrixKind::path, "Z",
           "The turning joints are a spanning tree. The path matrix holds, for each link, the joints on its "
           "path to the ground: $1$ where the path follows the arrow, $-1$ where it runs against it.");
    matrix(
        MatrixKind::spanningTree, "T = G^{*T} Z^T",
        "Each mesh closes a fundamental cycle with the joints between its two links. They follow from both "
        "matrices.");
    matrix(MatrixKind::cycleBasis, "C = \\left[ T \\mid U \\right]",
           "With the meshes themselves, each once, this is the cycle-basis matrix.");
  }

 private:
  void addLinks() {
    ReportTable table{{"Link", "Name"}, {}};
    for (int i = 0; i <= m_mechanism.n(); ++i) {
      const Link& link = m_mechanism.links[static_cast<std::size_t>(i)];
      table.rows.push_back({plainWords(std::to_string(m_mechanism.linkLabel(i))),
                            plainWords(link.name.empty() ? link.id.text() : link.name)});
    }
    put(std::move(table));
  }

  void addJoints() {
    ReportTable table{{"Turning joint", "From", "To", "Axis"}, {}};
    for (int i = 0; i < m_mechanism.t(); ++i) {
      const TurningJoint& joint = m_mechanism.turningJoints[static_cast<std::size_t>(i)];
      table.rows.push_back({plainWords(std::to_string(m_mechanism.jointLabel(i))),
                            plainWords(m_labels[joint.tail]), plainWords(m_labels[joint.head]),
                            plainWords(joint.axis.text())});
    }
    if (!table.rows.empty()) put(std::move(table));
  }

  void addMeshes() {
    ReportTable table{{"Gear mesh", "From", "To", "Teeth", "Kind"}, {}};
    for (int i = 0; i < m_mechanism.c(); ++i) {
      const GearMesh& mesh = m_mechanism.gearMeshes[static_cast<std::size_t>(i)];
      table.rows.push_back(
          {plainWords(std::to_string(m_mechanism.meshLabel(i))), plainWords(m_labels[mesh.tail]),
           plainWords(m_labels[mesh.head]),
           plainWords(std::to_string(mesh.tailTeeth) + " : " + std::to_string(mesh.headTeeth)),
           plainWords(mesh.kind ? std::string(meshKindName(*mesh.kind)) : std::string())});
    }
    if (!table.rows.empty()) put(std::move(table));
  }

  void matrix(MatrixKind kind, const std::string& symbol, const std::string& text) {
    const IntegerMatrixPtr& matrix = m_snapshot.matrix(kind);
    if (matrix == nullptr || matrix->rows() == 0 || matrix->columns() == 0) return;
    if (matrix->rows() > kMostReportRows || matrix->columns() > kMostReportColumns) {
      return paragraph(text + " It has $" + std::to_string(matrix->rows()) + " \\times " +
                       std::to_string(matrix->columns()) +
                       "$ entries, too many to print: \"export --to csv --matrix " +
                       std::string(matrixCommandName(kind)) + "\" writes them.");
    }
    paragraph(text);
    equation(symbol + " =\n" + matrixLatex(*matrix), matrixEquation(kind));
  }

  const AnalysisSnapshot& m_snapshot;
  const Mechanism& m_mechanism;
  std::unordered_map<LinkId, std::string> m_labels;
};

}  // namespace

void addDigraphPart(Report& report, const AnalysisSnapshot& snapshot) {
  DigraphPart part(report, snapshot);
  part.addMechanism();
  part.addMatrices();
}

}  // namespace geargraph::inline report
