#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/model/validate.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {
namespace {

/// XML has no control characters but three, and no two others.
bool isInXml(const std::string& text) {
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') return false;
  }
  return text.find("\xEF\xBF\xBE") == std::string::npos && text.find("\xEF\xBF\xBF") == std::string::npos;
}

bool hasOnlyXml(const Mechanism& mechanism) {
  if (!isInXml(mechanism.name) || !isInXml(mechanism.notes) || !isInXml(mechanism.unit)) return false;
  for (const Link& link : mechanism.links) {
    if (!isInXml(link.id.text()) || !isInXml(link.name)) return false;
  }
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (!isInXml(joint.id.text()) || !isInXml(joint.axis.text())) return false;
  }
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    if (!isInXml(mesh.id.text())) return false;
    if (mesh.tailWheel && !isInXml(mesh.tailWheel->text())) return false;
    if (mesh.headWheel && !isInXml(mesh.headWheel->text())) return false;
  }
  return true;
}

}  // namespace

bool checkGraph(const std::string& text) {
  const auto found = graphFormOf(text);
  // DOT may begin with anything that is no graph.
  const GraphForm form = found.value_or(GraphForm::dot);
  const auto first = readMechanismGraph(text, form);
  if (!first) {
    for (const Diagnostic& diagnostic : first.error()) {
      if (diagnostic.message.empty() || diagnostic.severity() != Severity::error || diagnostic.line < 1 ||
          diagnostic.column < 1)
        lawFailed("A finding has no sentence or no place", text);
    }
    return false;
  }
  for (const std::string& note : first->notes) {
    if (note.empty() || note.back() != '.') lawFailed("A note is no sentence", text);
  }
  if (!wellFormedDiagnostics(first->mechanism).empty()) lawFailed("Read, but not well formed", text);
  const auto opened = readMechanism(writeMechanism(first->mechanism));
  if (!opened || !(*opened == first->mechanism))
    lawFailed("What was read is not saved and opened again", text);
  const Mechanism whole = tablePart(first->mechanism).mechanism;
  for (const GraphForm other : {GraphForm::dot, GraphForm::graphMl, GraphForm::nodeLink}) {
    if (other == GraphForm::graphMl && !hasOnlyXml(whole)) continue;
    const std::string written = digraphFile(whole, other);
    if (graphFormOf(written) != other) lawFailed("What was written is not known by its beginning", text);
    const auto second = readMechanismGraph(written, other);
    if (!second || !(second->mechanism == whole)) lawFailed("What was written is not read back", text);
    if (!second->notes.empty()) lawFailed("What was written is read with notes", text);
    if (digraphFile(second->mechanism, other) != written) lawFailed("Writing is not canonical", text);
  }
  return true;
}

}  // namespace geargraph::test
