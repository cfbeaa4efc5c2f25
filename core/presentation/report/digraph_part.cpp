#include <unordered_map>

#include "core/foundations/base/translation.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/derivation/result_text.h"

namespace geargraph {
namespace {

/// In one of two texts that are marked by toTranslate(), by their number, which is %1.
std::string countedElements(int count, const char* one, const char* many) {
  return filled(translated(count == 1 ? one : many), {std::to_string(count)});
}

class DigraphPart : private ReportPart {
 public:
  DigraphPart(Report& report, const SnapshotPtr& snapshot)
      : ReportPart(report), m_snapshot(snapshot), m_mechanism(*snapshot->mechanism) {
    for (int i = 0; i <= m_mechanism.n(); ++i) {
      m_labels[m_mechanism.links[i].id] = std::to_string(m_mechanism.linkLabel(i));
    }
  }

  void addMechanism() {
    heading(1, toTranslate("The mechanism"));
    if (!m_mechanism.notes.empty()) put(ReportParagraph{plainWords(m_mechanism.notes)});
    const int n = m_mechanism.n(), t = m_mechanism.t(), c = m_mechanism.c();
    paragraph(translated(
        "It has %1, %2 and %3, $k = t + c = %4$ joints in all. The ground is link 0; the other links, the "
        "turning "
        "joints and the meshes are numbered on from there.",
        {countedElements(n, toTranslate("$%1$ moving link ($n = %1$)"),
                         toTranslate("$%1$ moving links ($n = %1$)")),
         countedElements(t, toTranslate("$%1$ turning joint ($t = %1$)"),
                         toTranslate("$%1$ turning joints ($t = %1$)")),
         countedElements(c, toTranslate("$%1$ gear mesh ($c = %1$)"),
                         toTranslate("$%1$ gear meshes ($c = %1$)")),
         std::to_string(t + c)}));
    addLinks();
    addJoints();
    addMeshes();
    put(ReportFigure{ReportDrawing::schematic, translated("Functional schematic")});
  }

  void addMatrices() {
    heading(1, toTranslate("Digraph and matrices"));
    paragraph(translated(
        "Each link becomes a node, each turning joint a solid arrow from its tail to its head, each gear "
        "mesh a "
        "dashed one."));
    put(ReportFigure{ReportDrawing::digraph, translated("Digraph")});
    for (const NamedResult* result : namedResults()) {
      if (result->reportText.empty()) continue;
      const ResultTablePtr table = exactTable(*result, {m_snapshot});
      if (table == nullptr && m_snapshot->tree == nullptr) {
        return paragraph(
            translated("The turning joints are no spanning tree of this digraph, so there is nothing more to "
                       "derive: see the findings above."));
      }
      if (table != nullptr) matrix(*table);
    }
  }

 private:
  void addLinks() {
    ReportTable table{{translated("Link"), translated("Name")}, {}};
    for (int i = 0; i <= m_mechanism.n(); ++i) {
      const Link& link = m_mechanism.links[i];
      table.rows.push_back({plainWords(std::to_string(m_mechanism.linkLabel(i))),
                            plainWords(link.name.empty() ? link.id.text() : link.name)});
    }
    put(std::move(table));
  }

  void addJoints() {
    ReportTable table{{translated("Turning joint"), translated("From"), translated("To"), translated("Axis")},
                      {}};
    for (int i = 0; i < m_mechanism.t(); ++i) {
      const TurningJoint& joint = m_mechanism.turningJoints[i];
      table.rows.push_back({plainWords(std::to_string(m_mechanism.jointLabel(i))),
                            plainWords(m_labels[joint.tail]), plainWords(m_labels[joint.head]),
                            plainWords(joint.axis.text())});
    }
    if (!table.rows.empty()) put(std::move(table));
  }

  void addMeshes() {
    ReportTable table{{translated("Gear mesh"), translated("From"), translated("To"), translated("Teeth"),
                       translated("Kind")},
                      {}};
    for (int i = 0; i < m_mechanism.c(); ++i) {
      const GearMesh& mesh = m_mechanism.gearMeshes[i];
      table.rows.push_back(
          {plainWords(std::to_string(m_mechanism.meshLabel(i))), plainWords(m_labels[mesh.tail]),
           plainWords(m_labels[mesh.head]),
           plainWords(std::to_string(mesh.tailTeeth) + " : " + std::to_string(mesh.headTeeth)),
           plainWords(mesh.kind ? kindWord(*mesh.kind) : std::string())});
    }
    if (!table.rows.empty()) put(std::move(table));
  }

  void matrix(const ResultTable& table) {
    if (table.rows() == 0 || table.columns() == 0) return;
    const NamedResult& result = table.result();
    const std::string text = translated(result.reportText);
    if (table.rows() > kMaxReportRows || table.columns() > kMaxReportColumns)
      return paragraph(text + ' ' + tooManyEntries(table.rows(), table.columns(), result.name));
    paragraph(text);
    equation(std::string(result.reportFormula) + " =\n" + readableLatex(table),
             result.equation(table.form()));
  }

  const SnapshotPtr& m_snapshot;
  const Mechanism& m_mechanism;
  std::unordered_map<LinkId, std::string> m_labels;
};

}  // namespace

void addDigraphPart(Report& report, const SnapshotPtr& snapshot) {
  DigraphPart part(report, snapshot);
  part.addMechanism();
  part.addMatrices();
}

}  // namespace geargraph
