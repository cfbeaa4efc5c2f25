#include "ui/canvas/graph_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/notes.h"
#include "ui/canvas/context_menu.h"
#include "ui/canvas/cycle_walk.h"
#include "ui/canvas/in_place_editor.h"
#include "ui/canvas/mark_painter.h"
#include "ui/canvas/note_editor.h"

namespace geargraph {
namespace {

bool isMesh(const ElementId& element) {
  return element.kind == ElementKind::gearMesh;
}

QPixmap gridDot(const QColor& color, double devicePixels) {
  constexpr double kDot = 1.6, kSide = 4;  // px
  QPixmap picture((QSizeF(kSide, kSide) * devicePixels).toSize());
  picture.setDevicePixelRatio(devicePixels);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QPointF(kSide / 2, kSide / 2), kDot / 2, kDot / 2);
  return picture;
}

}  // namespace

GraphView::GraphView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent)
    : DrawingView(document, selection, scene, parent),
      m_sheet(scene),
      m_controller(new ToolController(*document, *selection, *this, this)) {
  connect(m_controller, &ToolController::toolChanged, this, [this](ToolKind tool) {
    updateCursor();
    emit toolChanged(tool);
  });
  connect(m_controller, &ToolController::hintChanged, this, &GraphView::setHint);
  connect(m_controller, &ToolController::previewChanged, this, &GraphView::previewChanged);
  connect(m_controller, &ToolController::noteWanted, this, &GraphView::openNoteEditor);
  connect(m_controller, &ToolController::panned, this, &GraphView::panBy);
  setHint(m_controller->hint());
}

/// A note that is being typed is given up: its editor would hand the text to a view that is no more.
GraphView::~GraphView() {
  for (NoteEditor* editor : viewport()->findChildren<NoteEditor*>()) {
    editor->disconnect(this);
    delete editor;
  }
}

QString GraphView::message() const {
  return mechanism().links.size() == 1 ? tr("Draw the first link: L, then click") : QString();
}

void GraphView::showCycle(MeshId mesh) {
  m_wantedCycle = mesh;
  updateEmphases();
}

void GraphView::setAnswersOpen(bool isOpen) {
  m_showsCircuits = isOpen;
  updateEmphases();
}

MeshId GraphView::chosenMesh() const {
  if (!snapshot() || !m_showsCircuits) return {};
  if (!m_wantedCycle.empty()) return m_wantedCycle;
  // Another view that shows a row of C under the mouse hovers all that is on the cycle.
  const std::set<ElementId>& hovered = selection().hovered();
  const auto mesh = std::find_if(hovered.begin(), hovered.end(), isMesh);
  if (hovered.size() > 1 && mesh != hovered.end()) {
    const std::optional<CycleWalk> walk = cycleWalk(*snapshot(), MeshId(mesh->id));
    const auto isOn = [&](const ElementId& element) { return walk->emphases.contains(element); };
    if (walk && walk->emphases.size() == hovered.size() &&
        std::all_of(hovered.begin(), hovered.end(), isOn)) {
      return MeshId(mesh->id);
    }
  }
  const std::set<ElementId>& selected = selection().selected();
  if (selected.size() != 1 || !isMesh(*selected.begin())) return {};
  return MeshId(selected.begin()->id);
}

std::optional<AxisChoice::Way> GraphView::axisKey(const QKeyEvent& event) const {
  if (!m_controller->isDrawingJoint() || event.modifiers() != Qt::NoModifier) return std::nullopt;
  switch (event.key()) {
    case Qt::Key_X:
      return AxisChoice::Way::alongX;
    case Qt::Key_Y:
      return AxisChoice::Way::alongY;
    case Qt::Key_Z:
      return AxisChoice::Way::alongZ;
    default:
      return std::nullopt;
  }
}

bool GraphView::event(QEvent* event) {
  // While a joint is drawn these keys are no commands of the window.
  if (event->type() == QEvent::ShortcutOverride && axisKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return DrawingView::event(event);
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  const std::optional<AxisChoice::Way> way = axisKey(*event);
  way ? m_controller->setAxisOfStroke(*way) : DrawingView::keyPressEvent(event);
}

void GraphView::toggleInputs() {
  m_controller->toggleInputs(selection().selected());
}

void GraphView::adjustMenu(ContextActions& actions, CanvasPoint at) {
  actions.addLink = [this, at] { m_controller->addLink(at); };
  if (showsNotes()) actions.addNote = [this, at] { openNoteEditor(at); };
  actions.tidy = [this] { tidy(); };
}

void GraphView::pressed(const Pointer& pointer) {
  m_controller->handle(Pressed{pointer}, scaleNow());
}

void GraphView::moved(const Pointer& pointer) {
  m_controller->handle(Moved{pointer}, scaleNow());
}

void GraphView::released(const Pointer& pointer) {
  m_controller->handle(Released{pointer}, scaleNow());
}

bool GraphView::cancel() {
  if (m_controller->isIdle()) return false;
  m_controller->handle(Escaped{}, scaleNow());
  return true;
}

// --- notes ------------------------------------------------------------------------------------------------

Expected<Mechanism> GraphView::withNoteAt(const Mechanism& mechanism, CanvasPoint at,
                                          const std::string& text) const {
  return withNote(mechanism, at, text);
}

void GraphView::openElement(const ElementId& element) {
  const CanvasNote* const note =
      element.kind == ElementKind::note ? mechanism().find(NoteId(element.id)) : nullptr;
  note != nullptr ? openNoteEditor(note->at, note->id) : DrawingView::openElement(element);
}

void GraphView::openNoteEditor(CanvasPoint at, const std::optional<NoteId>& note) {
  const CanvasNote* const known = note ? mechanism().find(*note) : nullptr;
  if (note && known == nullptr) return;
  if (known != nullptr) at = known->at;
  const QString before = known != nullptr ? QString::fromStdString(known->text) : QString();
  auto* editor = new NoteEditor(before, mapFromScene(QPointF(at.x, at.y)), viewport());
  connect(editor, &NoteEditor::limited, this, &GraphView::setHint);
  connect(editor, &NoteEditor::taken, this, [this, at, note, before](const QString& typed) {
    const std::string text = noteText(typed.toStdString());
    if (text != noteText(before.toStdString())) takeNote(at, note, text);
    if (tool() == ToolKind::note) setTool(ToolKind::select);  // the next click is not one more note
  });
  openInPlace(editor, this, document());
}

void GraphView::takeNote(CanvasPoint at, const std::optional<NoteId>& note, const std::string& text) {
  if (!note) {
    const bool done = document().apply(
        {tr("Add note"), [this, at, text](const Mechanism& before) { return withNoteAt(before, at, text); },
         0});
    if (done) selection().select({mechanism().view.notes.back().id});
  } else if (text.empty()) {
    document().apply(
        {tr("Delete note"),
         [note](const Mechanism& before) { return withoutElements(before, std::vector<ElementId>{*note}); },
         0});
  } else {
    document().apply({tr("Change note"),
                      [note, text](const Mechanism& before) { return withNoteText(before, *note, text); },
                      0});
  }
}

void GraphView::setGrid(bool on) {
  m_controller->setGrid(on);
  viewport()->update();
}

void GraphView::drawBackground(QPainter* painter, const QRectF& rect) {
  DrawingView::drawBackground(painter, rect);
  constexpr double kStep = ToolController::kGridStep;
  constexpr double kDensest = 7;  // px between two dots
  if (!m_controller->hasGrid() || kStep * scaleNow() < kDensest) return;
  // Thousands of dots: copies of one picture take a tenth of the time that strokes of round caps take.
  const QPixmap dot = gridDot(toQColor(colorOf(ColorRole::secondary, theme())), devicePixelRatioF());
  const QRectF whole(QPointF(0, 0), QSizeF(dot.size()));
  const double size = 1 / dot.devicePixelRatio();
  const QTransform toView = painter->worldTransform();
  std::vector<QPainter::PixmapFragment> dots;
  for (double x = kStep * std::floor(rect.left() / kStep); x <= rect.right(); x += kStep) {
    for (double y = kStep * std::floor(rect.top() / kStep); y <= rect.bottom(); y += kStep)
      dots.push_back(QPainter::PixmapFragment::create(toView.map(QPointF(x, y)), whole, size, size));
  }
  painter->save();
  painter->resetTransform();  // copies without scaling are the fastest
  painter->drawPixmapFragments(dots.data(), static_cast<int>(dots.size()), dot);
  painter->restore();
}

}  // namespace geargraph

#include "moc_graph_view.cpp"
