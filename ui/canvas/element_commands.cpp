#include "ui/canvas/element_commands.h"

#include <QCoreApplication>

#include "core/mechanism/edits.h"
#include "ui/canvas/canvas_edits.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

}  // namespace

void ElementCommands::apply(const QString& text,
                            std::function<Expected<Mechanism>(const Mechanism&)> reduce) {
  m_document.apply({text, std::move(reduce), 0});
}

void ElementCommands::selectAll() {
  std::set<ElementId> all;
  const Mechanism& mechanism = *m_document.mechanism();
  for (const Link& link : mechanism.links) all.insert(link.id);
  for (const TurningJoint& joint : mechanism.turningJoints) all.insert(joint.id);
  for (const GearMesh& mesh : mechanism.gearMeshes) all.insert(mesh.id);
  m_selection.select(std::move(all));
}

void ElementCommands::removeSelected() {
  const std::set<ElementId> selected = m_selection.selected();
  if (selected.empty()) return;
  const std::vector<ElementId> elements(selected.begin(), selected.end());
  apply(tr("Delete %1").arg(describe(*m_document.mechanism(), selected)),
        [elements](const Mechanism& mechanism) { return withoutElements(mechanism, elements); });
}

void ElementCommands::flipSelected() {
  std::vector<ElementId> arrows;
  for (const ElementId& element : m_selection.selected()) {
    const bool arrow = element.kind == ElementKind::turningJoint || element.kind == ElementKind::gearMesh;
    if (arrow) arrows.push_back(element);
  }
  if (arrows.empty()) return;
  apply(tr("Flip %1").arg(describe(*m_document.mechanism(), {arrows.begin(), arrows.end()})),
        [arrows](Mechanism mechanism) -> Expected<Mechanism> {
          for (const ElementId& arrow : arrows) {
            Expected<Mechanism> next = withFlipped(std::move(mechanism), arrow);
            if (!next) return next.error();
            mechanism = std::move(next).value();
          }
          return mechanism;
        });
}

QString ElementCommands::toggleInputs(const std::set<ElementId>& elements) {
  const Mechanism& now = *m_document.mechanism();
  const std::set<JointId> joints = jointsDrivenBy(now, elements);
  if (joints.empty()) {
    QString why;
    for (const ElementId& element : elements) {
      if (element.kind != ElementKind::link) continue;
      why = tr("Cannot be driven: %1").arg(carryingJoint(now, LinkId(element.id)).why);
    }
    return why;
  }
  apply(tr("Drive or release"), [joints](Mechanism mechanism) -> Expected<Mechanism> {
    for (const JointId joint : joints) {
      Expected<Mechanism> next = withInputToggled(mechanism, joint);
      if (!next) return next.error();
      mechanism = std::move(next).value();
    }
    return mechanism;
  });
  return {};
}

void ElementCommands::rename(LinkId link, const QString& name) {
  const std::string text = name.trimmed().toStdString();
  apply(tr("Rename link"),
        [link, text](const Mechanism& mechanism) { return withName(mechanism, link, text); });
}

void ElementCommands::makeGround(LinkId link) {
  apply(tr("Make ground"), [link](const Mechanism& mechanism) { return withGround(mechanism, link); });
}

}  // namespace geargraph
