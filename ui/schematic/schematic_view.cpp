#include "ui/schematic/schematic_view.h"

#include "ui/canvas/context_menu.h"

namespace geargraph {

SchematicView::SchematicView(Document* document, Selection* selection, QWidget* parent)
    : DrawingView(document, selection, new DrawingScene, parent),
      m_service(new SchematicService(this)),
      m_sheet(static_cast<DrawingScene*>(scene())) {
  connect(m_service, &SchematicService::drawn, this, &SchematicView::showDrawing);
  rebuild();
}

void SchematicView::rebuild() {
  m_service->request(document().mechanism());
}

void SchematicView::showDrawing(const SchematicPtr& schematic) {
  m_schematic = schematic;
  m_sheet->show([schematic](const Emphases& emphases) { return schematicDrawing(*schematic, emphases); });
  updateEmphases();
  updateMessage();
  if (m_fitNext || isFitted()) fit();
  m_fitNext = false;
  emit drawn();
}

QString SchematicView::message() const {
  if (!m_schematic || !m_schematic->isEmpty()) return {};
  if (mechanism().links.size() == 1) return tr("Draw the first link: L, then click");
  return tr("The schematic needs turning joints: T, then drag from a link to the one it carries");
}

void SchematicView::adjustMenu(ContextActions& actions, SheetPoint) {
  actions.addLink = nullptr;
  actions.tidy = nullptr;
}

void SchematicView::openElement(const ElementId& element) {
  if (element.kind != ElementKind::axis) return DrawingView::openElement(element);
  for (const TurningJoint& joint : mechanism().turningJoints) {
    if (ElementId(joint.axis) == element) return emit propertiesWanted(joint.id);
  }
}

}  // namespace geargraph
