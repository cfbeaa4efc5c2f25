#include "ui/canvas/digraph_view.h"

#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>

#include "ui/canvas/context_menu.h"
#include "ui/canvas/cycle_walk.h"
#include "ui/canvas/mark_painter.h"
#include "ui/canvas/rename_editor.h"

namespace geargraph {
namespace {

bool exists(const Mechanism& mechanism, const ElementId& element) {
  switch (element.kind) {
    case ElementKind::link:
      return mechanism.find(LinkId(element.id)) != nullptr;
    case ElementKind::turningJoint:
      return mechanism.find(JointId(element.id)) != nullptr;
    case ElementKind::gearMesh:
      return mechanism.find(MeshId(element.id)) != nullptr;
    default:
      return true;  // other views' elements are theirs to drop
  }
}

bool isMesh(const ElementId& element) {
  return element.kind == ElementKind::gearMesh;
}

Theme themeOf(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? Theme::dark : Theme::light;
}

}  // namespace

DigraphView::DigraphView(Document* document, Selection* selection, QWidget* parent)
    : QGraphicsView(parent),
      m_document(document),
      m_selection(selection),
      m_scene(new DigraphScene(this)),
      m_placer(new NodePlacer(this)),
      m_controller(new ToolController(*document, *selection, *m_scene, *m_placer, this)) {
  setScene(m_scene);
  setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  setOptimizationFlags(QGraphicsView::DontSavePainterState | QGraphicsView::DontAdjustForAntialiasing);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTransformationAnchor(QGraphicsView::NoAnchor);
  setResizeAnchor(QGraphicsView::AnchorViewCenter);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  viewport()->setMouseTracking(true);
  setAccessibleName(tr("Digraph"));

  connect(document, &Document::changed, this, &DigraphView::rebuild);
  connect(document, &Document::replaced, this, &DigraphView::showAnotherDocument);
  connect(selection, &Selection::selectionChanged, this, &DigraphView::updateEmphases);
  connect(selection, &Selection::hoverChanged, this, &DigraphView::updateEmphases);
  connect(m_placer, &NodePlacer::placesFound, this, [this] {
    rebuild();
    fit();
  });
  connect(m_placer, &NodePlacer::laidOut, this, [this](const NodePositions& positions) {
    m_controller->place(positions);
    fit();
  });
  connect(m_controller, &ToolController::toolChanged, this, [this](ToolKind tool) {
    updateCursor();
    emit toolChanged(tool);
  });
  connect(m_controller, &ToolController::hintChanged, this, &DigraphView::hintChanged);
  connect(m_controller, &ToolController::previewChanged, this, &DigraphView::previewChanged);
  connect(m_controller, &ToolController::panned, this, &DigraphView::panBy);
  applyTheme(themeOf(palette()));
  rebuild();
}

// --- what is shown ----------------------------------------------------------------------------------------

void DigraphView::rebuild() {
  const MechanismPtr& mechanism = m_document->mechanism();
  m_scene->show(*mechanism, m_placer->placesOf(mechanism));
  m_selection->keepOnly([&](const ElementId& element) { return exists(*mechanism, element); });
  updateEmphases();
  const bool bare = mechanism->links.size() == 1 || m_placer->isSeeking();
  if (bare != m_bare) viewport()->update();  // the message comes or goes
  m_bare = bare;
}

void DigraphView::showAnotherDocument() {
  m_placer->forget();
  m_wantedCycle = {};
  m_snapshot.reset();
  rebuild();
  fit();
}

std::optional<CycleWalk> DigraphView::shownCycle() const {
  if (!m_snapshot) return std::nullopt;
  if (!m_wantedCycle.empty()) return cycleWalk(*m_snapshot, m_wantedCycle);
  // Another view that shows a row of C under the mouse hovers all that is on the cycle.
  const std::set<ElementId>& hovered = m_selection->hovered();
  const auto mesh = std::find_if(hovered.begin(), hovered.end(), isMesh);
  if (hovered.size() > 1 && mesh != hovered.end()) {
    std::optional<CycleWalk> walk = cycleWalk(*m_snapshot, MeshId(mesh->id));
    const auto isOn = [&](const ElementId& element) { return walk->emphases.contains(element); };
    if (walk && walk->emphases.size() == hovered.size() &&
        std::all_of(hovered.begin(), hovered.end(), isOn)) {
      return walk;
    }
  }
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1 || !isMesh(*selected.begin())) return std::nullopt;
  return cycleWalk(*m_snapshot, MeshId(selected.begin()->id));
}

void DigraphView::updateEmphases() {
  const std::optional<CycleWalk> walk = shownCycle();
  Emphases emphases = walk ? walk->emphases : Emphases{};
  const std::set<ElementId>& selected = m_selection->selected();
  for (const ElementId& element : selected) emphases[element].selected = true;
  for (const ElementId& element : m_selection->hovered()) emphases[element].hovered = true;
  m_scene->setEmphases(std::move(emphases));
  const QString caption = walk ? walk->caption : QString();
  if (caption == m_caption) return;
  m_caption = caption;
  viewport()->update();
}

void DigraphView::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  updateEmphases();
}

void DigraphView::showCycle(MeshId mesh) {
  m_wantedCycle = mesh;
  updateEmphases();
}

void DigraphView::setDark(bool dark) {
  m_themeChosen = true;
  applyTheme(dark ? Theme::dark : Theme::light);
}

Theme DigraphView::theme() const {
  return m_scene->theme();
}

void DigraphView::applyTheme(Theme theme) {
  m_scene->setTheme(theme);
  viewport()->update();
}

void DigraphView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && !m_themeChosen) applyTheme(themeOf(palette()));
  QGraphicsView::changeEvent(event);
}

DisplayList DigraphView::displayList() const {
  return m_scene->displayList();
}

void DigraphView::drawForeground(QPainter* painter, const QRectF&) {
  painter->save();
  painter->resetTransform();
  if (m_placer->isSeeking()) {
    drawMessage(*painter, tr("Laying out %1 links").arg(m_document->mechanism()->links.size()));
  } else if (m_document->mechanism()->links.size() == 1) {
    drawMessage(*painter, tr("Draw the first link: L, then click"));
  }
  if (!m_caption.isEmpty()) drawCaption(*painter, m_caption);
  painter->restore();
}

void DigraphView::drawMessage(QPainter& painter, const QString& text) const {
  QFont font = this->font();
  font.setPixelSize(15);
  painter.setFont(font);
  painter.setPen(toQColor(colorOf(ColorRole::secondary, theme())));
  const QRect whole = viewport()->rect();
  painter.drawText(whole.adjusted(0, whole.height() / 2 + 60, 0, 0), Qt::AlignHCenter | Qt::AlignTop, text);
}

void DigraphView::drawCaption(QPainter& painter, const QString& text) const {
  constexpr int kMargin = 12;
  QFont font = this->font();
  font.setPixelSize(11);
  painter.setFont(font);
  const QFontMetrics metrics(font);
  const int room = viewport()->width() - 4 * kMargin;
  const QString shown = metrics.elidedText(text, Qt::ElideRight, room);
  const QSize size(metrics.horizontalAdvance(shown) + 2 * kMargin, metrics.height() + kMargin);
  const QRect box(QPoint(kMargin, viewport()->height() - kMargin - size.height()), size);
  painter.setPen(toQColor(colorOf(ColorRole::hairline, theme())));
  painter.setBrush(toQColor(colorOf(ColorRole::sheet, theme())));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(toQColor(colorOf(ColorRole::accent, theme())));
  painter.drawText(box, Qt::AlignCenter, shown);
}

// --- zoom and pan -----------------------------------------------------------------------------------------

void DigraphView::moveView(QPointF pixels) {
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() - qRound(pixels.x()));
  verticalScrollBar()->setValue(verticalScrollBar()->value() - qRound(pixels.y()));
}

void DigraphView::panBy(QPointF sheetUnits) {
  m_fitted = false;
  moveView(scaleNow() * sheetUnits);
}

void DigraphView::zoomAt(QPointF viewportPlace, double factor) {
  constexpr double kSmallest = 0.02;
  constexpr double kLargest = 8;
  const double wanted = std::clamp(scaleNow() * factor, std::min(kSmallest, scaleNow()), kLargest);
  const QPointF anchor = mapToScene(viewportPlace.toPoint());
  setTransform(QTransform::fromScale(wanted, wanted));
  moveView(viewportPlace - QPointF(mapFromScene(anchor)));
  m_fitted = false;
}

void DigraphView::zoomIn() {
  zoomAt(viewport()->rect().center(), 1.25);
}

void DigraphView::zoomOut() {
  zoomAt(viewport()->rect().center(), 1 / 1.25);
}

void DigraphView::resetZoom() {
  zoomAt(viewport()->rect().center(), 1 / scaleNow());
}

void DigraphView::fit() {
  constexpr double kMargin = 24;
  constexpr double kLargest = 1.25;
  const QRectF drawn = m_scene->drawnRect().adjusted(-kMargin, -kMargin, kMargin, kMargin);
  const QSizeF room = viewport()->size();
  const double scale = std::min({kLargest, room.width() / drawn.width(), room.height() / drawn.height()});
  setTransform(QTransform::fromScale(scale, scale));
  centerOn(drawn.center());
  m_fitted = true;
}

void DigraphView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (m_fitted) fit();
}

// --- commands ---------------------------------------------------------------------------------------------

ToolKind DigraphView::tool() const {
  return m_controller->tool();
}

void DigraphView::setTool(ToolKind tool) {
  m_controller->setTool(tool);
}

QString DigraphView::hint() const {
  return m_controller->hint();
}

void DigraphView::selectAll() {
  std::set<ElementId> all;
  const Mechanism& mechanism = *m_document->mechanism();
  for (const Link& link : mechanism.links) all.insert(link.id);
  for (const TurningJoint& joint : mechanism.turningJoints) all.insert(joint.id);
  for (const GearMesh& mesh : mechanism.gearMeshes) all.insert(mesh.id);
  m_selection->select(std::move(all));
}

void DigraphView::deleteSelected() {
  m_controller->removeSelected();
}

void DigraphView::flipSelected() {
  m_controller->flipSelected();
}

void DigraphView::toggleInputs() {
  m_controller->toggleInputs(m_selection->selected());
}

void DigraphView::tidy() {
  m_placer->layOut(m_document->mechanism());
}

void DigraphView::renameSelected() {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1 || selected.begin()->kind != ElementKind::link) return;
  openRenameEditor(LinkId(selected.begin()->id));
}

void DigraphView::openRenameEditor(LinkId link) {
  const Link* found = m_document->mechanism()->find(link);
  const NodePlace* node = m_scene->geometry().node(link);
  if (found == nullptr || node == nullptr) return;
  auto* editor = new RenameEditor(QString::fromStdString(found->name), viewport());
  constexpr QSize kSize(150, 26);
  const QPoint under = mapFromScene(toQPoint(node->center + SheetPoint{0, kNodeRadius + 4}));
  editor->setGeometry(QRect(under - QPoint(kSize.width() / 2, 0), kSize));
  connect(editor, &RenameEditor::taken, this,
          [this, link](const QString& name) { m_controller->rename(link, name); });
  connect(editor, &QObject::destroyed, this, [this] { setFocus(); });
  editor->show();
  editor->setFocus();
}

QMenu* DigraphView::contextMenuAt(QPoint viewportPlace) {
  const std::optional<ElementId> element = elementUnder(viewportPlace);
  if (element && !m_selection->isSelected(*element)) m_selection->select({*element});
  const LinkId link = element ? LinkId(element->id) : LinkId();
  const SheetPoint at = toSheetPoint(mapToScene(viewportPlace));
  ContextActions actions;
  actions.rename = [this, link] { openRenameEditor(link); };
  actions.toggleInput = [this] { toggleInputs(); };
  actions.makeGround = [this, link] { m_controller->makeGround(link); };
  actions.flip = [this] { flipSelected(); };
  actions.remove = [this] { deleteSelected(); };
  actions.addLink = [this, at] { m_controller->addLink(at); };
  actions.selectAll = [this] { selectAll(); };
  actions.tidy = [this] { tidy(); };
  actions.fit = [this] { fit(); };
  auto* menu = new QMenu(this);
  fillContextMenu(*menu, *m_document->mechanism(), element, actions);
  return menu;
}

}  // namespace geargraph
