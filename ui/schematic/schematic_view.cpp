#include "ui/schematic/schematic_view.h"

#include "core/schematic/sheet_edits.h"
#include "ui/canvas/context_menu.h"

namespace geargraph {

SchematicView::SchematicView(Document* document, Selection* selection, QWidget* parent)
    : DrawingView(document, selection, new DrawingScene, parent),
      m_service(new SchematicService(this)),
      m_sheet(static_cast<DrawingScene*>(scene())) {
  connect(m_service, &SchematicService::drawn, this, &SchematicView::showDrawing);
  showState();
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
  if (m_schematic->isTooLarge) {
    return tr("The schematic shows up to %1 links; this train has %2")
        .arg(kMostDrawnLinks - 1)
        .arg(mechanism().links.size() - 1);
  }
  if (mechanism().links.size() == 1) return tr("Draw the first shaft: L, then drag");
  return tr("No turning joint ties a link to the ground yet. Draw a shaft: L, then drag");
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

// --- drawing in it ----------------------------------------------------------------------------------------

void SchematicView::setTool(ToolKind tool) {
  cancel();
  DrawingView::setTool(tool);
  showState();
}

Pointer SchematicView::meant(Pointer pointer) const {
  if (!pointer.on || pointer.on->kind != ElementKind::turningJoint) return pointer;
  const TurningJoint* joint = mechanism().find(JointId(pointer.on->id));
  if (joint != nullptr) pointer.on = joint->head;
  return pointer;
}

void SchematicView::pressed(const Pointer& pointer) {
  switch (tool()) {
    case ToolKind::select:
    case ToolKind::pan:
      return DrawingView::pressed(pointer);
    case ToolKind::input: {
      const bool can = pointer.on && (pointer.on->kind == ElementKind::turningJoint ||
                                      pointer.on->kind == ElementKind::link);
      const QString why = can ? commands().toggleInputs({*pointer.on}) : QString();
      if (!why.isEmpty()) setHint(why);
      return;
    }
    default:
      return step(Pressed{meant(pointer)});
  }
}

bool SchematicView::cancel() {
  if (isIdle()) return false;
  step(Escaped{});
  return true;
}

void SchematicView::step(const ToolEvent& event) {
  if (isIdle() && !std::holds_alternative<Pressed>(event)) return;
  section_tool::Step next = section_tool::on(m_state, event, tool());
  m_state = std::move(next.next);
  showState();
  if (!next.proposal) return;
  if (const auto* shaft = std::get_if<section_tool::AddShaft>(&*next.proposal)) addShaft(*shaft);
  if (const auto* mesh = std::get_if<section_tool::MeshLinks>(&*next.proposal)) meshLinks(*mesh);
}

void SchematicView::addShaft(const section_tool::AddShaft& shaft) {
  if (!m_schematic) return;
  const DrawnShaft drawn{shaft.from, shaft.to, shaft.carrier};
  const auto reduce = [drawn, schematic = m_schematic](const Mechanism& before) {
    return withShaftOnSheet(before, schematic->frame, drawn);
  };
  if (document().apply({tr("Draw shaft"), reduce, 0})) selection().select({mechanism().links.back().id});
}

void SchematicView::meshLinks(const section_tool::MeshLinks& mesh) {
  if (!m_schematic) return;
  const LinkId head = mesh.head.empty() ? mechanism().links.front().id : mesh.head;
  const DrawnMesh drawn{mesh.tail, head, mesh.from, mesh.to};
  const auto reduce = [drawn, schematic = m_schematic](const Mechanism& before) {
    return withMeshOnSheet(before, schematic->frame, drawn);
  };
  if (document().apply({tr("Draw gear mesh"), reduce, 0})) {
    selection().select({mechanism().gearMeshes.back().id});
  }
}

/// The line that is being drawn, and what the tool expects next.
void SchematicView::showState() {
  setHint(tr(std::string(section_tool::hint(m_state, tool())).c_str()));
  DisplayList list;
  if (const auto draft = section_tool::draft(m_state)) {
    const Dash dash = draft->isShaft ? Dash::solid : Dash::dotted;
    list.marks.push_back({{},
                          MarkRole::ghost,
                          kGhostDepth,
                          Stroke{Polyline{{draft->from, draft->to}, false}, ColorRole::accent, 3, dash}});
  }
  m_sheet->setOverlay(std::move(list));
}

}  // namespace geargraph
