#include "ui/canvas/tool_controller.h"

#include <QCoreApplication>
#include <cmath>

#include "core/mechanism/geometry_edits/mesh_snap.h"
#include "core/mechanism/model/drawn_mesh.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/notes.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/hit_test.h"
#include "ui/canvas/drawn_joint.h"
#include "ui/canvas/element_commands.h"

namespace geargraph {
namespace {

constexpr double kSnapReach = 6;  ///< px on screen

QString hintText(std::string_view text) {
  return QCoreApplication::translate("tools", std::string(text).c_str());
}

/// Would the arrow make a joint if it were released here?
Expected<PlacedMechanism> withDraft(const Mechanism& mechanism, const ArrowDraft& draft) {
  if (draft.kind != ElementKind::gearMesh) return withDrawnJoint(mechanism, draft.tail, draft.head);
  const Expected<PlacedMechanism> drawn = unplaced(withDrawnMesh(mechanism, draft.tail, draft.head));
  if (!drawn) return drawn;
  return withMeshSnapped(*drawn, drawn->mechanism().gearMeshes.back().id);
}

}  // namespace

ToolController::ToolController(Document& document, Selection& selection, NodeSheet& sheet, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_sheet(sheet) {
  m_hint = hintText(m_machine.hint());
}

void ToolController::setTool(ToolKind tool) {
  if (tool == m_machine.tool()) return;
  handle(Escaped{}, m_scale);
  m_machine = ToolMachine(tool);
  showState();
  emit toolChanged(tool);
}

void ToolController::handle(const ToolEvent& event, double scale) {
  m_scale = scale;
  if (!std::holds_alternative<Moved>(event) && !std::holds_alternative<Released>(event)) m_notice.clear();
  for (const Proposal& proposal : m_machine.on(event)) carryOut(proposal);
  showState();
}

void ToolController::carryOut(const Proposal& proposal) {
  struct Visitor {
    ToolController& self;
    /// An edit may have removed what was under the mouse when it was pressed.
    [[nodiscard]] bool isThere(const ElementId& element) const {
      return self.m_document.elements().contains(element);
    }
    void operator()(const SelectOnly& p) const {
      if (isThere(p.element)) self.m_selection.select({p.element});
    }
    void operator()(const ToggleSelected& p) const {
      if (isThere(p.element)) self.m_selection.toggle(p.element);
    }
    void operator()(const ClearSelection&) const { self.m_selection.clear(); }
    void operator()(const SelectInside& p) const { self.selectInside(p); }
    void operator()(const MoveSelected& p) const { self.moveSelected(p); }
    void operator()(const MoveEnded&) const { self.m_drag.reset(); }
    void operator()(const MoveCancelled&) const { self.cancelMove(); }
    void operator()(const AddLink& p) const { self.addLink(p.at); }
    void operator()(const AddJoint& p) const { self.addJoint(p); }
    void operator()(const ToggleInput& p) const { self.toggleInputs({p.element}); }
    void operator()(const WriteNote& p) const { self.writeNote(p); }
    void operator()(const PanBy& p) const { emit self.panned({p.dx, p.dy}); }
  };
  std::visit(Visitor{*this}, proposal);
}

void ToolController::apply(const QString& text, Reduce reduce, quint64 gesture) {
  m_document.apply({text, std::move(reduce), gesture});
}

// --- moving -----------------------------------------------------------------------------------------------

ToolController::Drag ToolController::beginDrag() {
  Drag drag{m_document.newGesture(), m_document.mechanism(), {}, {}, {}};
  for (const auto& [link, place] : m_sheet.positions()) {
    if (m_selection.isSelected(link)) {
      drag.moving.emplace_back(link, place);
    } else {
      drag.resting.push_back(place);
    }
  }
  if (!m_sheet.showsNotes()) return drag;
  for (const CanvasNote& note : drag.before->view.notes) {
    if (m_selection.isSelected(note.id)) drag.notes.emplace_back(note.id, note.at);
  }
  return drag;
}

void ToolController::moveSelected(const MoveSelected& move) {
  if (!m_drag) m_drag = beginDrag();
  std::vector<CanvasPoint> from;
  for (const auto& [link, place] : m_drag->moving) from.push_back(place);
  for (const auto& [note, place] : m_drag->notes) from.push_back(place);
  const double reach = move.unsnapped ? 0 : kSnapReach / m_scale;
  const bool toGrid = m_grid && !move.unsnapped && !from.empty();
  if (toGrid) {
    const CanvasPoint place = onGrid(from.front() + CanvasPoint{move.dx, move.dy}, kGridStep);
    m_snap = Snap{place.x - from.front().x, place.y - from.front().y, {}, {}};
  } else {
    m_snap =
        reach > 0 ? snapped(from, m_drag->resting, move.dx, move.dy, reach) : Snap{move.dx, move.dy, {}, {}};
  }
  NodeMoves places = m_drag->moving;
  for (auto& [link, place] : places) place = place + CanvasPoint{m_snap.dx, m_snap.dy};
  NoteMoves notes = m_drag->notes;
  for (auto& [note, place] : notes) place = place + CanvasPoint{m_snap.dx, m_snap.dy};
  const QString text = places.empty()       ? tr("Move note")
                       : places.size() == 1 ? tr("Move link")
                                            : tr("Move links");
  moveTo(text, std::move(places), std::move(notes), m_drag->gesture);
}

void ToolController::moveTo(const QString& text, NodeMoves places, NoteMoves notes, quint64 gesture) {
  apply(
      text,
      [this, places = std::move(places),
       notes = std::move(notes)](const Mechanism& mechanism) -> Expected<Mechanism> {
        if (places.empty()) return withNotesMoved(mechanism, notes);
        Expected<Mechanism> moved = m_sheet.withMoved(mechanism, places);
        if (!moved || notes.empty()) return moved;
        return withNotesMoved(*std::move(moved), notes);
      },
      gesture);
}

void ToolController::cancelMove() {
  if (!m_drag) return;
  // Back to the very value it had: the step merges with the drag's and both are gone.
  const MechanismPtr before = m_drag->before;
  apply(
      tr("Move links"), [before](const Mechanism&) -> Expected<Mechanism> { return *before; },
      m_drag->gesture);
  m_drag.reset();
}

void ToolController::nudge(double dx, double dy, bool repeated) {
  const Drag drag = beginDrag();
  if (drag.moving.empty() && drag.notes.empty()) return;
  if (!repeated || m_nudge == 0) m_nudge = drag.gesture;
  NodeMoves places = drag.moving;
  for (auto& [link, place] : places) place = place + CanvasPoint{dx, dy};
  NoteMoves notes = drag.notes;
  for (auto& [note, place] : notes) place = place + CanvasPoint{dx, dy};
  moveTo(tr("Nudge"), std::move(places), std::move(notes), m_nudge);
}

void ToolController::place(const NodePositions& positions) {
  const NodeMoves places(positions.begin(), positions.end());
  apply(tr("Tidy the drawing"),
        [this, places](const Mechanism& mechanism) { return m_sheet.withMoved(mechanism, places); });
}

// --- making and removing ----------------------------------------------------------------------------------

void ToolController::addLink(CanvasPoint at) {
  if (m_grid) at = onGrid(at, kGridStep);
  const std::size_t before = m_document.mechanism()->links.size();
  apply(tr("Add link"), [this, at](const Mechanism& mechanism) { return m_sheet.withLinkAt(mechanism, at); });
  const auto& links = m_document.mechanism()->links;
  if (links.size() > before) m_selection.select({links.back().id});
}

void ToolController::writeNote(const WriteNote& note) {
  if (!m_sheet.showsNotes()) {
    m_notice = tr("Notes are written on the sheet of the digraph");
    return;
  }
  emit noteWanted(m_grid ? onGrid(note.at, kGridStep) : note.at, note.note);
}

void ToolController::addJoint(const AddJoint& joint) {
  const bool mesh = joint.kind == ElementKind::gearMesh;
  const ArrowDraft draft{joint.kind, joint.tail, joint.head, {}};
  const auto reduce = [draft, way = m_axisOfStroke](const Mechanism& before) -> Expected<PlacedMechanism> {
    Expected<PlacedMechanism> drawn = withDraft(before, draft);
    if (!drawn || !way) return drawn;
    return withAxisChosen(*drawn, drawn->mechanism().turningJoints.back().axis, {*way});
  };
  const bool done = m_document.apply({mesh ? tr("Add gear mesh") : tr("Add turning joint"), reduce, 0});
  if (!done) return;
  const Mechanism& mechanism = *m_document.mechanism();
  m_selection.select(
      {mesh ? ElementId(mechanism.gearMeshes.back().id) : ElementId(mechanism.turningJoints.back().id)});
}

void ToolController::toggleInputs(const std::set<ElementId>& elements) {
  m_notice = ElementCommands(m_document, m_selection).toggleInputs(elements);
  showState();
}

void ToolController::selectInside(const SelectInside& band) {
  std::set<ElementId> elements;
  if (band.add) elements = m_selection.selected();
  for (const ElementId& element : elementsInside(m_sheet.outlines(), Extent::spanning(band.from, band.to))) {
    elements.insert(element);
  }
  m_selection.select(std::move(elements));
}

bool ToolController::isDrawingJoint() const {
  const std::optional<ArrowDraft> draft = m_machine.arrowDraft();
  return draft && draft->kind == ElementKind::turningJoint;
}

void ToolController::setAxisOfStroke(AxisChoice::Way way) {
  if (!isDrawingJoint()) return;
  m_axisOfStroke = way;
  showState();
}

// --- what is shown meanwhile ------------------------------------------------------------------------------

void ToolController::showState() {
  if (!isDrawingJoint()) m_axisOfStroke.reset();
  std::optional<JointPreview> preview;
  QString hint = previewAndHint(preview);
  if (!m_notice.isEmpty()) hint = m_notice;
  if (preview != m_preview) {
    m_preview = preview;
    emit previewChanged(preview);
  }
  m_sheet.setOverlay(overlay());
  if (hint == m_hint) return;
  m_hint = hint;
  emit hintChanged(hint);
}

/// What can be said of the axis meanwhile, behind the hint of the tool.
QString ToolController::withAxisOfStroke(const QString& hint) const {
  if (!isDrawingJoint()) return hint;
  if (!m_axisOfStroke) return tr("%1; X, Y or Z lays its axis along x, y or z").arg(hint);
  const int letter = 'x' + static_cast<int>(*m_axisOfStroke) - static_cast<int>(AxisChoice::Way::alongX);
  return tr("%1; its axis lies along %2").arg(hint, QChar(letter));
}

QString ToolController::previewAndHint(std::optional<JointPreview>& preview) const {
  const QString hint = withAxisOfStroke(hintText(m_machine.hint()));
  const std::optional<ArrowDraft> draft = m_machine.arrowDraft();
  if (!draft) return hint;
  preview = JointPreview{draft->kind, draft->tail, draft->head, false};
  if (draft->head.empty()) return hint;
  if (m_preview && m_preview->valid &&
      *m_preview == JointPreview{draft->kind, draft->tail, draft->head, true}) {
    preview->valid = true;  // known already; the check is not free
    return hint;
  }
  // Guesses, which need the places of all axes, reject nothing.
  const Mechanism& now = *m_document.mechanism();
  const Expected<PlacedMechanism> next =
      isDrawingJoint() ? unplaced(withTurningJoint(now, draft->tail, draft->head)) : withDraft(now, *draft);
  preview->valid = next.has_value();
  return next ? hint : QString::fromStdString(next.error().front().message);
}

Curve ToolController::guide(const std::function<bool(CanvasPoint)>& isOnLine) const {
  constexpr double kBeyond = 40;
  std::optional<Extent> span;
  for (const auto& [link, place] : m_sheet.positions()) {
    if (!isOnLine(place)) continue;
    const Extent point{place, 0, 0};
    span = span ? span->united(point) : point;
  }
  const Extent line = span.value_or(Extent{});
  const double beyondX = line.halfWidth > 0 ? kBeyond : 0;
  const double beyondY = line.halfHeight > 0 ? kBeyond : 0;
  return Curve::straight({line.left() - beyondX, line.top() - beyondY},
                         {line.right() + beyondX, line.bottom() + beyondY});
}

DisplayList ToolController::overlay() const {
  DisplayList list;
  const double hair = 1 / m_scale;
  const auto put = [&](const Shape& shape, Dash dash) {
    list.marks.push_back(
        {{}, MarkRole::preview, kPreviewDepth, Stroke{shape, ColorRole::accent, hair, dash}});
  };
  if (const auto band = m_machine.rubberBand()) {
    put(Box{Extent::spanning(band->from, band->to), 0}, Dash::solid);
  }
  if (const auto link = m_machine.linkDraft()) list.append(linkPreview(*link));
  if (const auto draft = m_machine.arrowDraft()) {
    const auto tail = m_sheet.positions().find(draft->tail);
    const auto head = m_sheet.positions().find(draft->head);
    if (tail != m_sheet.positions().end()) {
      const bool ends = head != m_sheet.positions().end();
      const Curve course = previewCourse(tail->second, ends ? head->second : draft->cursor, ends);
      list.append(arrowPreview(draft->kind, course, m_preview && m_preview->valid));
    }
  }
  if (m_drag && m_snap.column)
    put(guide([&](CanvasPoint p) { return std::abs(p.x - *m_snap.column) < 1e-6; }), Dash::solid);
  if (m_drag && m_snap.row)
    put(guide([&](CanvasPoint p) { return std::abs(p.y - *m_snap.row) < 1e-6; }), Dash::solid);
  return list;
}

}  // namespace geargraph

#include "moc_tool_controller.cpp"
