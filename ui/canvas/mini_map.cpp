#include "ui/canvas/mini_map.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/canvas/drawing_scene.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/mark_painter.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kEdge = 10;        // px to the corner of the view
constexpr double kInside = 8;    // px between the map's border and the drawing
constexpr int kLeastView = 300;  // px: a smaller view has no room for a map
constexpr double kHidden = 4;    // px that may lie outside before the map is shown

const DrawingScene& sceneOf(const DrawingView& view) {
  return static_cast<const DrawingScene&>(*view.scene());
}

}  // namespace

MiniMap::MiniMap(DrawingView* view) : QWidget(view), m_view(view) {
  setObjectName(QStringLiteral("miniMap"));
  setToolTip(tr("All of the drawing: click or drag to move what is in sight"));
  setAccessibleName(tr("Map of the drawing"));
  setFocusPolicy(Qt::NoFocus);
  setCursor(Qt::PointingHandCursor);
  hide();
  view->viewport()->installEventFilter(this);
}

/// Whatever moves, zooms or changes the drawing paints it.
bool MiniMap::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Paint || event->type() == QEvent::Resize) m_turn.request();
  return QWidget::eventFilter(watched, event);
}

QRectF MiniMap::sight() const {
  return m_view->mapToScene(m_view->viewport()->rect()).boundingRect();
}

void MiniMap::follow() {
  const QRectF all = sceneOf(*m_view).drawnRect();
  const QRectF now = sight();
  const double slack = kHidden / m_view->transform().m11();
  const bool fits = all.isEmpty() || now.adjusted(-slack, -slack, slack, slack).contains(all);
  const QRect room = m_view->viewport()->rect();
  const bool isShown = !fits && room.width() >= kLeastView && room.height() >= kLeastView / 2;
  if (isShown) {
    const QSize size = sizeHint();
    setGeometry(
        QRect(QPoint(room.width() - size.width() - kEdge, room.height() - size.height() - kEdge), size));
  }
  setVisible(isShown);
  if (!isShown) return;
  m_all = all;
  m_sight = now;
  update();
}

QTransform MiniMap::toMap() const {
  const QRectF inside = QRectF(rect()).adjusted(kInside, kInside, -kInside, -kInside);
  const double scale = std::min(inside.width() / m_all.width(), inside.height() / m_all.height());
  QTransform map;
  map.translate(inside.center().x(), inside.center().y());
  map.scale(scale, scale);
  map.translate(-m_all.center().x(), -m_all.center().y());
  return map;
}

QRectF MiniMap::frame() const {
  return toMap().mapRect(m_sight).intersected(QRectF(rect()).adjusted(1, 1, -1, -1));
}

/// Elements as dots and lines of their outlines: the marks of a large drawing would take too long.
void MiniMap::paintEvent(QPaintEvent* /*event*/) {
  const DrawingScene& scene = sceneOf(*m_view);
  const Theme theme = m_view->theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = toQColor(colorOf(ColorRole::panel, theme));
  ground.setAlphaF(0.94F);
  painter.setPen(toQColor(colorOf(ColorRole::hairline, theme)));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  const QTransform map = toMap();
  const QColor ink = toQColor(colorOf(ColorRole::secondary, theme));
  for (const Outline& outline : scene.outlines()) {
    if (const auto* curve = std::get_if<Curve>(&outline.shape)) {
      painter.setPen(QPen(ink, 0.8));
      QPolygonF line{map.map(QPointF(curve->from.x, curve->from.y))};
      forEachChord(*curve, [&](CanvasPoint, CanvasPoint to) { line << map.map(QPointF(to.x, to.y)); });
      painter.drawPolyline(line);
    } else if (outline.element.kind == ElementKind::link) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(ink);
      const Extent extent = extentOf(outline.shape);
      painter.drawEllipse(map.map(QPointF(extent.center.x, extent.center.y)), 2.2, 2.2);
    }
  }
  const QColor accent = toQColor(colorOf(ColorRole::accent, theme));
  QColor tint = accent;
  tint.setAlphaF(0.12F);
  painter.setPen(QPen(accent, 1.4));
  painter.setBrush(tint);
  painter.drawRect(frame());
}

void MiniMap::showPlace(QPointF place) {
  m_view->centerOn(toMap().inverted().map(place));
  m_turn.request();
}

void MiniMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) showPlace(event->position());
}

void MiniMap::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) showPlace(event->position());
}

}  // namespace geargraph

#include "moc_mini_map.cpp"
