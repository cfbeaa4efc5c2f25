#include "ui/canvas/schematic_view.h"

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/presentation/diagrams/power_drawing.h"
#include "core/presentation/diagrams/torque_marks.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/schematic/sheet_edits.h"
#include "ui/canvas/context_menu.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

SchematicView::SchematicView(Document* document, Selection* selection, QWidget* parent)
    : DrawingView(document, selection, new DrawingScene, parent),
      m_service(new SchematicService(this)),
      m_sheet(static_cast<DrawingScene*>(scene())),
      m_axisDrag(new AxisDrag(document, this)) {
  setAccessibleName(tr("Schematic"));
  connect(m_axisDrag, &AxisDrag::hintChanged, this, &SchematicView::setHint);
  connect(m_axisDrag, &AxisDrag::ended, this, &SchematicView::endDrag);
  m_service->onAnswer(this, [this](const SchematicPtr& schematic) { showDrawing(schematic); });
  showState();
  rebuild();
}

void SchematicView::rebuild() {
  m_behind = !isVisible();
  if (!m_behind) m_service->request(document().geometry());
}

void SchematicView::catchUp() {
  constexpr std::chrono::milliseconds kMoment{30};
  if (std::exchange(m_behind, false)) m_service->request(document().geometry());
  m_service->await(kMoment);
}

void SchematicView::showEvent(QShowEvent* event) {
  DrawingView::showEvent(event);
  if (!m_behind) return;
  catchUp();
  if (isUpToDate()) return;
  m_schematic.reset();  // nobody is shown what the document was long ago
  m_sheet->show([](const Emphases&) { return DisplayList{}; });
  updateMessage();
}

void SchematicView::showDrawing(const SchematicPtr& schematic) {
  m_schematic = schematic;
  m_sheet->show([schematic](const Emphases& emphases) { return schematicDrawing(*schematic, emphases); });
  updateEmphases();
  updateMessage();
  emit redrawn();
  if (m_drag || m_rim) return emit drawn();  // the sheet stays put under the mouse
  if (m_fitNext || (isFitted() && !isDrawing())) fit();
  m_fitNext = false;
  emit drawn();
}

DrawingView::PowerDraw SchematicView::powerDraw() const {
  if (!isUpToDate() || !m_schematic) return {};
  return [schematic = m_schematic](const PowerPicture& picture, const std::vector<ShownTorque>& torques,
                                   const Mechanism& mechanism) {
    DisplayList under = schematicPower(picture, mechanism, *schematic);
    under.append(schematicTorques(torques, *schematic, under));
    return under;
  };
}

QString SchematicView::whyNoPicture() const {
  return isUpToDate() ? QString() : tr("The schematic is still being laid out. Try again in a moment.");
}

QString SchematicView::message() const {
  constexpr std::size_t kMany = 60;  ///< take more than a moment
  if (!m_schematic) {
    return mechanism().links.size() > kMany ? tr("Finding places for %1 links …").arg(mechanism().n())
                                            : QString();
  }
  if (!m_schematic->isEmpty()) return {};
  if (m_schematic->isTooLarge) {
    return tr("The schematic shows up to %1 links; this train has %2. Digraph and T–T graph show all of them")
        .arg(kMaxDrawnLinks - 1)
        .arg(mechanism().links.size() - 1);
  }
  if (hasSlides(mechanism()) && !m_schematic->notes.empty())
    return QString::fromStdString(m_schematic->notes.front());
  if (mechanism().links.size() == 1) return tr("Draw the first shaft: L, then drag");
  return tr("No turning joint ties a link to the ground yet. Draw a shaft: L, then drag");
}

void SchematicView::adjustMenu(ContextActions& actions, CanvasPoint) {
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
  if (joint == nullptr) return pointer;
  if (tool() == ToolKind::select) {
    pointer.on = joint->axis;
  } else {
    pointer.on = joint->head;
  }
  return pointer;
}

void SchematicView::pressed(const Pointer& pointer) {
  switch (tool()) {
    case ToolKind::pan:
      return DrawingView::pressed(pointer);
    case ToolKind::select:
      DrawingView::pressed(pointer);
      if (grabRim(pointer)) return;
      return step(Pressed{meant(pointer)});
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

void SchematicView::moved(const Pointer& pointer) {
  m_rim ? dragRim(pointer) : step(Moved{meant(pointer)});
}

void SchematicView::released(const Pointer& pointer) {
  m_rim ? endRim() : step(Released{meant(pointer)});
}

bool SchematicView::cancel() {
  if (isIdle()) return false;
  if (m_rim) {
    if (m_rim->teeth)
      document().apply({tr("Change teeth"),
                        [before = m_rim->before](const PlacedMechanism&) { return before; }, m_rim->gesture});
    endRim();
    return true;
  }
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
  if (const auto* drag = std::get_if<section_tool::DragAxis>(&*next.proposal)) dragAxis(*drag);
  if (std::holds_alternative<section_tool::AxisDropped>(*next.proposal)) m_axisDrag->drop();
  if (std::holds_alternative<section_tool::AxisPutBack>(*next.proposal)) m_axisDrag->putBack();
}

// --- dragging a rim ---------------------------------------------------------------------------------------

/// At the pitch line of a gear, or where two of them mesh.
bool SchematicView::grabRim(const Pointer& pointer) {
  constexpr double kReach = 6;  ///< px on screen
  if (!m_schematic || !isUpToDate() || !pointer.on || pointer.add) return false;
  std::vector<LinkId> links;
  if (pointer.on->kind == ElementKind::link) links.emplace_back(pointer.on->id);
  const GearMesh* const mesh =
      pointer.on->kind == ElementKind::gearMesh ? mechanism().find(MeshId(pointer.on->id)) : nullptr;
  if (mesh != nullptr) links = {mesh->tail, mesh->head};
  const SheetRim* const rim = rimNear(m_schematic->rims, links, pointer.at, kReach / scaleNow());
  if (rim == nullptr) return false;
  m_rim = RimDrag{document().newGesture(), document().placed(), *rim, pointer.at};
  return true;
}

/// Every edit of the drag begins where the drag did, so that what follows the teeth comes back with them.
void SchematicView::dragRim(const Pointer& pointer) {
  const double wandered = distance(pointer.at, m_rim->from);
  if (!m_rim->teeth && wandered <= pointer.slop) return;
  const auto teeth = teethDragged(m_rim->before, m_rim->rim, m_rim->from, pointer.at);
  if (!teeth) return;
  m_rim->at = pointer.at;
  if (m_rim->teeth != teeth) {
    m_rim->teeth = teeth;
    const bool done = document().apply({tr("Change teeth"),
                                        [before = m_rim->before, to = *teeth](const PlacedMechanism&) {
                                          return withTeethFitted(before, to.mesh, to.tailTeeth, to.headTeeth);
                                        },
                                        m_rim->gesture});
    if (done) m_rim->shown = teeth->teeth;
    if (done) setHint(tr("z = %1. Esc puts back").arg(teeth->teeth));
  }
  showState();
}

void SchematicView::endRim() {
  m_rim.reset();
  if (isFitted()) fit();
  showState();
}

/// "z = 36" on a plate beside the mouse.
DisplayList SchematicView::rimLabel() const {
  DisplayList list;
  if (!m_rim || m_rim->shown == 0) return list;
  constexpr double kSize = 13, kBeside = 22;  // px on screen
  const double size = kSize / scaleNow();
  const std::string text = tr("z = %1").arg(m_rim->shown).toStdString();
  const double halfWidth = textWidth(text, size, true) / 2 + size / 2;
  const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
  const double besideIt = kBeside / scaleNow();
  CanvasPoint middle = m_rim->at + CanvasPoint{halfWidth + besideIt, -besideIt};
  if (middle.x + halfWidth > seen.right()) middle.x = m_rim->at.x - halfWidth - besideIt;
  if (middle.y - size < seen.top()) middle.y = m_rim->at.y + besideIt;
  const geargraph::Box plate{{middle, halfWidth, 0.9 * size}, size / 3};
  list.marks.push_back({{}, MarkRole::preview, kPreviewDepth, Fill{plate, ColorRole::sheet}});
  list.marks.push_back(
      {{}, MarkRole::preview, kPreviewDepth, Stroke{plate, ColorRole::accent, 1 / scaleNow(), Dash::solid}});
  list.marks.push_back(
      {{}, MarkRole::preview, kPreviewDepth, Text{text, middle, size, true, ColorRole::accent}});
  return list;
}

// --- dragging an axis -------------------------------------------------------------------------------------

void SchematicView::dragAxis(const section_tool::DragAxis& drag) {
  if (!m_schematic) return;
  if (!m_drag) m_drag = DraggedOn{m_schematic, drag.axis};
  m_axisDrag->begin(drag.axis);
  const DraggedAxis dragged{drag.axis, drag.from, drag.to, !drag.unsnapped};
  m_axisDrag->move([dragged, sheet = m_drag->schematic](const PlacedMechanism& before) {
    return withAxisOnSheet(before, sheet->frame, dragged);
  });
}

void SchematicView::nudge(double dx, double dy, bool /*repeated*/) {
  const std::optional<ElementId> current = currentElement();
  if (!current || !isIdle() || !isUpToDate()) return;  // what the drawing shows is what is moved
  const TurningJoint* joint =
      current->kind == ElementKind::turningJoint ? mechanism().find(JointId(current->id)) : nullptr;
  if (joint == nullptr && current->kind != ElementKind::axis) return;
  const AxisId axis = joint != nullptr ? joint->axis : AxisId(current->id);
  dragAxis({axis, {0, 0}, {dx, dy}, true});
  m_axisDrag->end();
}

std::optional<Pointer> SchematicView::keyStrokeEnd(const Pointer& begin) const {
  constexpr double kShaft = 120;
  if (tool() != ToolKind::link && tool() != ToolKind::turningJoint) return std::nullopt;
  Pointer end = begin;
  end.on.reset();
  end.at = tool() == ToolKind::link ? begin.at + CanvasPoint{kShaft, 0} : freePlace();
  return end;
}

std::optional<Vector3> SchematicView::spaceAt(CanvasPoint place) const {
  return m_schematic ? std::optional(m_schematic->frame.spaceOf(place)) : std::nullopt;
}

void SchematicView::endDrag() {
  m_drag.reset();
  if (isFitted()) fit();
  showState();
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
  if (!m_drag && !(m_rim && m_rim->teeth))
    setHint(tr(std::string(section_tool::hint(m_state, tool())).c_str()));
  DisplayList list = rimLabel();
  if (const auto draft = section_tool::draft(m_state)) {
    using Style = section_tool::Draft::Style;
    const Dash dash = draft->style == Style::shaft ? Dash::solid : Dash::dotted;
    if (draft->style != Style::axis) {
      list.marks.push_back({{},
                            MarkRole::preview,
                            kPreviewDepth,
                            Stroke{Polyline{{draft->from, draft->to}, false}, ColorRole::accent, 3, dash}});
    } else if (const auto preview = axisPreview(draft->to - draft->from)) {
      list.marks.push_back(*preview);
    }
  }
  m_sheet->setOverlay(std::move(list));
}

/// The dragged axis under the mouse.
std::optional<Mark> SchematicView::axisPreview(CanvasPoint moved) const {
  if (!m_drag) return std::nullopt;
  const CanvasFrame::Line* line = m_drag->schematic->frame.line(m_drag->axis);
  const auto& outlines = m_drag->schematic->outlines;
  const auto drawn = std::find_if(outlines.begin(), outlines.end(), [&](const Outline& outline) {
    return outline.element == ElementId(m_drag->axis) && std::holds_alternative<Curve>(outline.shape);
  });
  if (line == nullptr || drawn == outlines.end()) return std::nullopt;
  const CanvasPoint out = turned(line->along);
  const CanvasPoint way = dot(moved, out) * out;
  const Curve& course = std::get<Curve>(drawn->shape);
  return Mark{{},
              MarkRole::preview,
              kPreviewDepth,
              Stroke{Polyline{{course.at(0) + way, course.at(1) + way}, false}, ColorRole::accent, 1.6,
                     Dash::dashDotted}};
}

ViewEntry schematicView() {
  return {.id = QStringLiteral("schematic"),
          .title = SchematicView::tr("Schematic"),
          .tip = tipOf(Term::functionalSchematic),
          .purpose = SchematicView::tr("The mechanism in section, as in textbooks. You can draw here, too."),
          .helpPage = QStringLiteral("drawing#in-the-schematic"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* drawing = new SchematicView(views.document(), views.selection(), parent);
            drawing->setMeasuring(&views.workbench().measuring());
            QObject::connect(drawing, &SchematicView::drawn, &views, &Views::settled);
            return drawing;
          }};
}

}  // namespace geargraph

#include "moc_schematic_view.cpp"
