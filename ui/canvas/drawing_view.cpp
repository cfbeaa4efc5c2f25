#include "ui/canvas/drawing_view.h"

#include <QEvent>
#include <QMenu>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>
#include <utility>

#include "core/presentation/drawing/captions.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/context_menu.h"
#include "ui/canvas/in_place_editor.h"
#include "ui/canvas/mark_painter.h"
#include "ui/canvas/rename_editor.h"
#include "ui/canvas/weld_edits.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {

Theme currentTheme(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? Theme::dark : Theme::light;
}

}  // namespace

DrawingView::DrawingView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent)
    : QGraphicsView(parent),
      m_document(document),
      m_selection(selection),
      m_scene(scene),
      m_commands(*document, *selection) {
  scene->setParent(this);
  setScene(scene);
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

  connect(document, &Document::changed, this, &DrawingView::showDocument);
  connect(document, &Document::replaced, this, &DrawingView::showAnotherDocument);
  connect(selection, &Selection::selectionChanged, this, &DrawingView::updateEmphases);
  connect(selection, &Selection::hoverChanged, this, &DrawingView::updateEmphases);
  connect(this, &DrawingView::redrawn, this, &DrawingView::captionLater);
  applyTheme(currentTheme(palette()));
}

// --- what is shown ----------------------------------------------------------------------------------------

void DrawingView::showDocument() {
  rebuild();
  m_selection->keepOnly(
      [this](const ElementId& element) { return m_document->elements().contains(element); });
  updateEmphases();
  updateMessage();
  captionLater();
}

void DrawingView::showAnotherDocument() {
  m_snapshot.reset();
  forgetDocument();
  showDocument();
  m_fitsCaptions = true;
  fit();
}

void DrawingView::setCaptioned(bool on) {
  if (on == m_isCaptioned) return;
  m_isCaptioned = on;
  m_fitsCaptions = true;
  m_captionTurn.request();
}

void DrawingView::captionLater() {
  if (m_isCaptioned) m_captionTurn.request();
}

void DrawingView::updateCaptions() {
  std::vector<Mark> captions;
  if (m_isCaptioned && mechanism().n() <= kMaxCaptionedLinks) {
    DisplayList drawing = m_scene->underlay();
    drawing.append(m_scene->drawing()({}));
    captions = captionsOf(drawing, mechanism(), captionSize());
  }
  m_scene->setCaptions(std::move(captions));
  // Not after every edit: the sheet would move under the mouse.
  if (std::exchange(m_fitsCaptions, false) && m_fitted && !isDrawing()) fit();
}

void DrawingView::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  updateEmphases();
}

/// A hidden drawing gets them when it is shown: those of a large selection take ms in each drawing.
void DrawingView::updateEmphases() {
  m_areEmphasesBehind = !isVisible();
  if (!m_areEmphasesBehind) showEmphases();
}

void DrawingView::showEvent(QShowEvent* event) {
  QGraphicsView::showEvent(event);
  if (m_areEmphasesBehind) updateEmphases();
}

/// With what is selected and what is under the mouse.
DrawingView::Highlight DrawingView::wantedHighlight() const {
  Highlight wanted = highlight();
  for (const ElementId& element : m_selection->selected()) wanted.emphases[element].selected = true;
  for (const ElementId& element : m_selection->hovered()) wanted.emphases[element].hovered = true;
  return wanted;
}

void DrawingView::showEmphases() {
  Highlight shown = wantedHighlight();
  m_scene->setEmphases(std::move(shown.emphases));
  if (shown.caption == m_caption && shown.colors == m_captionColors) return;
  m_caption = std::move(shown.caption);
  m_captionColors = std::move(shown.colors);
  viewport()->update();
}

void DrawingView::updateMessage() {
  const QString text = message();
  if (text == m_message) return;
  m_message = text;
  viewport()->update();
}

void DrawingView::setNotice(const QStringList& lines) {
  if (lines == m_notice) return;
  m_notice = lines;
  if (m_fitted) fit();
  viewport()->update();
}

void DrawingView::setHint(const QString& hint) {
  if (hint == m_hint) return;
  m_hint = hint;
  emit hintChanged(hint);
}

void DrawingView::setTheme(Theme theme) {
  m_themeChosen = true;
  applyTheme(theme);
}

Theme DrawingView::theme() const {
  return m_scene->theme();
}

void DrawingView::applyTheme(Theme theme) {
  m_scene->setTheme(theme);
  viewport()->update();
}

void DrawingView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && !m_themeChosen) applyTheme(currentTheme(palette()));
  QGraphicsView::changeEvent(event);
}

QStringList DrawingView::caption() const {
  return m_areEmphasesBehind ? wantedHighlight().caption : m_caption;
}

DisplayList DrawingView::displayList() const {
  DisplayList all = m_scene->underlay();
  all.append(m_areEmphasesBehind ? m_scene->drawing()(wantedHighlight().emphases) : m_scene->displayList());
  all.marks.insert(all.marks.end(), m_scene->captions().begin(), m_scene->captions().end());
  return all;
}

void DrawingView::setUnderlay(DisplayList underlay) {
  if (underlay == m_scene->underlay()) return;
  m_scene->setUnderlay(std::move(underlay));
  captionLater();
  if (m_fitted && !isLoadDragged()) fit();  // else the sheet would move under the mouse that pulls
}

std::function<DisplayList()> DrawingView::pictureMaker() {
  catchUp();
  return [underlay = m_scene->underlay(), drawing = m_scene->drawing(),
          named = m_isCaptioned ? m_document->mechanism() : nullptr, size = captionSize()] {
    DisplayList all = underlay;
    all.append(drawing({}));
    return named ? withCaptions(std::move(all), *named, size) : all;
  };
}

void DrawingView::paintEvent(QPaintEvent* event) {
  m_scene->beginPainting(event->region());
  QGraphicsView::paintEvent(event);
  m_scene->endPainting();
}

void DrawingView::drawForeground(QPainter* painter, const QRectF&) {
  painter->save();
  painter->resetTransform();
  if (!m_message.isEmpty()) drawMessage(*painter, m_message);
  if (!m_notice.isEmpty()) {
    const std::vector<ColorRole> quiet(static_cast<std::size_t>(m_notice.size()), ColorRole::secondary);
    drawLines(*painter, boxOf(m_notice, Qt::TopLeftCorner), quiet);
  }
  if (!m_caption.isEmpty()) drawLines(*painter, boxOf(m_caption, Qt::BottomLeftCorner), m_captionColors);
  if (m_measuring != nullptr && m_measuring->isOn()) drawMeasured(*painter);
  if (m_showsFocus) {
    painter->setPen(QPen(toQColor(colorOf(ColorRole::accent, theme())), 2));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(viewport()->rect().adjusted(1, 1, -1, -1));
  }
  painter->restore();
}

void DrawingView::drawMessage(QPainter& painter, const QString& text) const {
  QFont font = this->font();
  font.setPixelSize(QFontInfo(font).pixelSize() * 15 / 13);
  painter.setFont(font);
  painter.setPen(toQColor(colorOf(ColorRole::secondary, theme())));
  const QRect whole = viewport()->rect();
  painter.drawText(whole.adjusted(24, whole.height() / 2 + 60, -24, 0),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text);
}

QFont DrawingView::lineFont() const {
  QFont font = this->font();
  font.setPixelSize(QFontInfo(font).pixelSize() * 11 / 13);
  return font;
}

DrawingView::LineBox DrawingView::boxOf(const QStringList& lines, Qt::Corner corner) const {
  constexpr int kMargin = 12;
  const QFontMetrics metrics(lineFont());
  const int room = viewport()->width() - 4 * kMargin;
  LineBox shown;
  int width = 0;
  for (const QString& line : lines) {
    shown.lines << metrics.elidedText(line, Qt::ElideRight, room);
    width = std::max(width, metrics.horizontalAdvance(shown.lines.back()));
  }
  const int height = static_cast<int>(lines.size()) * metrics.lineSpacing() + kMargin;
  const int top = corner == Qt::BottomLeftCorner ? viewport()->height() - kMargin - height : kMargin;
  shown.box = QRect(kMargin, top, width + 2 * kMargin, height);
  return shown;
}

void DrawingView::drawLines(QPainter& painter, const LineBox& shown,
                            const std::vector<ColorRole>& colors) const {
  constexpr int kMargin = 12;
  painter.setFont(lineFont());
  painter.setPen(toQColor(colorOf(ColorRole::hairline, theme())));
  painter.setBrush(toQColor(colorOf(ColorRole::sheet, theme())));
  painter.drawRoundedRect(shown.box, 5, 5);
  const int step = painter.fontMetrics().lineSpacing();
  QRect line = shown.box.adjusted(kMargin, kMargin / 2, 0, 0);
  for (qsizetype i = 0; i < shown.lines.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const ColorRole color = at < colors.size() ? colors[at] : ColorRole::accent;
    painter.setPen(toQColor(colorOf(color, theme())));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignTop, shown.lines[i]);
    line.translate(0, step);
  }
}

// --- zoom and pan -----------------------------------------------------------------------------------------

void DrawingView::moveView(QPointF pixels) {
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() - qRound(pixels.x()));
  verticalScrollBar()->setValue(verticalScrollBar()->value() - qRound(pixels.y()));
}

void DrawingView::panBy(QPointF sheetUnits) {
  m_fitted = false;
  moveView(scaleNow() * sheetUnits);
}

void DrawingView::zoomAt(QPointF viewportPlace, double factor) {
  constexpr double kSmallest = 0.02;
  constexpr double kLargest = 8;
  const double wanted = std::clamp(scaleNow() * factor, std::min(kSmallest, scaleNow()), kLargest);
  const QPointF anchor = mapToScene(viewportPlace.toPoint());
  setTransform(QTransform::fromScale(wanted, wanted));
  moveView(viewportPlace - QPointF(mapFromScene(anchor)));
  m_fitted = false;
}

void DrawingView::zoomIn() {
  zoomAt(viewport()->rect().center(), 1.25);
}

void DrawingView::zoomOut() {
  zoomAt(viewport()->rect().center(), 1 / 1.25);
}

void DrawingView::resetZoom() {
  zoomAt(viewport()->rect().center(), 1 / scaleNow());
}

void DrawingView::fitTo(const QRectF& area) {
  constexpr double kMargin = 24;
  const QRectF shown = area.adjusted(-kMargin, -kMargin, kMargin, kMargin);
  // The notice on top hides nothing of what is fitted.
  const int taken = m_notice.isEmpty() ? 0 : boxOf(m_notice, Qt::TopLeftCorner).box.bottom();
  const QSizeF room = viewport()->size() - QSize(0, std::min(taken, viewport()->height() / 2));
  const double scale = std::min({m_largest, room.width() / shown.width(), room.height() / shown.height()});
  setTransform(QTransform::fromScale(scale, scale));
  centerOn(shown.center() - QPointF(0, (viewport()->height() - room.height()) / (2 * scale)));
  viewport()->update();  // a scrolled viewport keeps pieces of what has just been removed
}

void DrawingView::fit() {
  fitTo(m_scene->drawnRect());
  m_fitted = true;
}

void DrawingView::setLargestFit(double scale) {
  if (std::exchange(m_largest, scale) == scale) return;
  if (m_fitted) fit();
}

void DrawingView::fitSelected() {
  QRectF area;
  for (const Outline& outline : m_scene->outlines()) {
    if (m_selection->isSelected(outline.element)) area |= toQRect(extentOf(outline.shape).grown(1));
  }
  if (area.isNull()) return fit();
  fitTo(area);
  m_fitted = false;
}

void DrawingView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (m_fitted && !isLoadDragged()) fit();
}

// --- commands ---------------------------------------------------------------------------------------------

void DrawingView::setTool(ToolKind tool) {
  if (tool == m_tool) return;
  m_tool = tool;
  updateCursor();
  emit toolChanged(tool);
}

void DrawingView::selectAll() {
  m_commands.selectAll(showsNotes());
}

void DrawingView::deleteSelected() {
  m_commands.removeSelected(showsNotes());  // none that is not seen
}

void DrawingView::flipSelected() {
  m_commands.flipSelected();
}

QString DrawingView::whyNoGear() const {
  const auto& selected = m_selection->selected();
  if (selected.size() != 1 || selected.begin()->kind != ElementKind::link) return {};
  const QString why = carryingJoint(mechanism(), LinkId(selected.begin()->id)).why;
  return why.isEmpty() ? why : tr("No gear can be attached: %1.").arg(why);
}

void DrawingView::attachGear() {
  const auto& selected = m_selection->selected();
  if (selected.size() != 1 || selected.begin()->kind != ElementKind::link) return;
  const QString why = m_commands.attachGear(LinkId(selected.begin()->id));
  if (!why.isEmpty()) setHint(why);
}

QString DrawingView::whyNoWeld() const {
  return geargraph::whyNoWeld(mechanism(), m_selection->selected());
}

QString DrawingView::whyNoSplit() const {
  return geargraph::whyNoSplit(mechanism(), m_selection->selected());
}

void DrawingView::weldSelected() {
  const QString why = m_commands.weldSelected();
  if (!why.isEmpty()) setHint(why);
}

void DrawingView::splitSelected() {
  const QString why = m_commands.splitSelected();
  if (!why.isEmpty()) setHint(why);
}

void DrawingView::toggleInputs() {
  const QString why = m_commands.toggleInputs(m_selection->selected());
  if (!why.isEmpty()) setHint(why);
}

void DrawingView::toggleBrake() {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1 || selected.begin()->kind != ElementKind::link) return;
  m_commands.toggleBrake(LinkId(selected.begin()->id));
}

void DrawingView::renameSelected() {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1) return;
  const ElementId element = *selected.begin();
  if (element.kind == ElementKind::note) return openElement(element);
  if (element.kind == ElementKind::link) openRenameEditor(LinkId(element.id));
}

void DrawingView::openRenameEditor(LinkId link) {
  const Link* found = mechanism().find(link);
  const std::vector<Outline>& outlines = m_scene->outlines();
  const auto drawn = std::find_if(outlines.begin(), outlines.end(),
                                  [&](const Outline& outline) { return outline.element == ElementId(link); });
  if (found == nullptr || drawn == outlines.end()) return;
  auto* editor = new RenameEditor(QString::fromStdString(found->name), viewport());
  constexpr QSize kSize(150, 26);
  const Extent extent = extentOf(drawn->shape);
  const QPoint under = mapFromScene(QPointF(extent.center.x, extent.bottom() + 3));
  editor->setGeometry(QRect(under - QPoint(kSize.width() / 2, 0), kSize));
  connect(editor, &RenameEditor::taken, this,
          [this, link](const QString& name) { m_commands.rename(link, name); });
  openInPlace(editor, this, *m_document);
}

void DrawingView::openElement(const ElementId& element) {
  if (element.kind == ElementKind::link) {
    openRenameEditor(LinkId(element.id));
  } else {
    emit propertiesWanted(element);
  }
}

QMenu* DrawingView::contextMenuAt(QPoint viewportPlace) {
  return contextMenuFor(elementUnder(viewportPlace), toSheetPoint(mapToScene(viewportPlace)));
}

QMenu* DrawingView::contextMenuFor(const std::optional<ElementId>& element, CanvasPoint at) {
  if (element && !m_selection->isSelected(*element)) m_selection->select({*element});
  const LinkId link = element ? LinkId(element->id) : LinkId();
  const MeshId mesh = element ? MeshId(element->id) : MeshId();
  ContextActions actions;
  actions.rename = [this, link] { openRenameEditor(link); };
  actions.open = [this, element] { openElement(*element); };
  actions.toggleInput = [this] { toggleInputs(); };
  actions.makeGround = [this, link] { m_commands.makeGround(link); };
  actions.flip = [this] { flipSelected(); };
  actions.attachGear = [this, link] { m_commands.attachGear(link); };
  actions.selected = m_selection->selected();
  actions.kindOf = [this](MeshId which) { return shownKind(m_document->placed(), which); };
  actions.pin = [this](const ElementId& which, bool on) { m_commands.pin(which, on); };
  actions.placeAxis = [this](AxisId axis, const AxisChoice& choice) { m_commands.placeAxis(axis, choice); };
  actions.setMeshKind = [this, mesh](MeshKind kind) { m_commands.setMeshKind(mesh, kind); };
  actions.flipSide = [this, mesh](bool ofTail) { m_commands.flipSide(mesh, ofTail); };
  actions.addBrake = [this, link] { m_commands.addBrake(link); };
  actions.addClutch = [this](LinkId one, LinkId other) { m_commands.addClutch(one, other); };
  actions.addFreewheel = [this](LinkId one, LinkId other) { m_commands.addFreewheel(one, other); };
  actions.engage = [this](ShiftElementId coupling, bool engaged) { m_commands.engage(coupling, engaged); };
  actions.removeCoupling = [this](const ElementId& coupling) { m_commands.removeCoupling(coupling); };
  actions.weld = [this] { weldSelected(); };
  actions.split = [this] { splitSelected(); };
  actions.remove = [this] { deleteSelected(); };
  actions.selectAll = [this] { selectAll(); };
  actions.fit = [this] { fit(); };
  adjustMenu(actions, at);
  auto* menu = new QMenu(this);
  fillContextMenu(*menu, mechanism(), element, actions);
  fillMenuFurther(*menu, element, at);
  emit menuOpening(menu, element);
  return menu;
}

QString DrawingView::toolTipFor(const ElementId& element) const {
  return describeFully(mechanism(), element);
}

}  // namespace geargraph

#include "moc_drawing_view.cpp"
