#include "ui/view3d/measure_layer.h"

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/view3d/overlay_layer.h"
#include "ui/workbench/measured_ink.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {

constexpr double kPointReach = 12;  ///< logical pixels
constexpr double kAxisReach = 7;

Eigen::Vector3d wide(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

bool isAtReference(const SceneView& view) {
  const bool isTurned =
      std::any_of(view.turned.begin(), view.turned.end(), [](double angle) { return angle != 0; });
  return view.time == 0 && !isTurned && view.explosion == 0 && !view.trajectory;
}

double fromSegment(const QPointF& place, const QLineF& line) {
  const QPointF way = line.p2() - line.p1();
  const double square = QPointF::dotProduct(way, way);
  const double along =
      square > 0 ? std::clamp(QPointF::dotProduct(place - line.p1(), way) / square, 0.0, 1.0) : 0;
  return QLineF(place, line.p1() + along * way).length();
}

}  // namespace

MeasureLayer::MeasureLayer(Viewer* viewer, Measuring* measuring)
    : QObject(viewer), m_viewer(viewer), m_measuring(measuring), m_layer(new OverlayLayer(viewer, false)) {
  connect(measuring, &Measuring::changed, this, &MeasureLayer::renew);
  viewer->setProbe([this](const QPointF& place, const std::optional<Hit>& hit, bool isClick) {
    return probe(place, hit, isClick);
  });
}

const Spot* MeasureLayer::spotAt(const QPointF& place, const std::optional<Hit>& hit) {
  if (m_viewer->stage() == nullptr) return nullptr;
  const MeasureSpots& spots = m_measuring->spots();
  const auto onScreen = [this](const Eigen::Vector3d& point) -> std::optional<QPointF> {
    const ScreenPoint at = m_viewer->camera().project(point, m_viewer->viewport());
    if (at.depth <= 0) return std::nullopt;
    return QPointF(at.x, at.y) / m_viewer->pixelRatio();
  };
  // Where an axis is drawn in the picture: as far as the train reaches.
  double reach = 1;
  for (const Spot& spot : spots.all()) {
    for (const Spot& other : spots.all()) reach = std::max(reach, length(spot.point - other.point));
  }
  const Spot* nearest = nullptr;
  double least = kPointReach;
  for (const Spot& spot : spots.all()) {
    const auto at = spot.isPoint() ? onScreen(wide(spot.point)) : std::nullopt;
    const double away = at ? QLineF(*at, place).length() : least;
    if (away < least) nearest = &spot;
    least = std::min(least, away);
  }
  if (nearest != nullptr) return nearest;
  least = kAxisReach;
  for (const Spot& spot : spots.all()) {
    if (spot.isPoint()) continue;
    const auto from = onScreen(wide(spot.point - reach * spot.direction));
    const auto to = onScreen(wide(spot.point + reach * spot.direction));
    const double away = from && to ? fromSegment(place, {*from, *to}) : least;
    if (away < least) nearest = &spot;
    least = std::min(least, away);
  }
  if (nearest != nullptr || !hit) return nearest;
  return spots.of(hit->element, Vector3{hit->point.x(), hit->point.y(), hit->point.z()});
}

bool MeasureLayer::probe(const QPointF& place, const std::optional<Hit>& hit, bool isClick) {
  if (!m_measuring->isOn()) return false;
  const Spot* const spot = spotAt(place, hit);
  if (isClick) {
    m_over.reset();
    if (spot != nullptr)
      m_measuring->take(spot->element, spot->isPoint() ? std::optional(spot->point) : std::nullopt);
    return true;
  }
  const bool isSame =
      spot == nullptr ? !m_over : m_over && m_over->point == spot->point && m_over->kind == spot->kind;
  if (!isSame) {
    m_over = spot == nullptr ? std::nullopt : std::optional(*spot);
    renew();
  }
  emit hintChanged(m_over
                       ? tr("Measure: %1").arg(QString::fromStdString(m_measuring->spots().nameOf(*m_over)))
                       : m_measuring->hint());
  return false;
}

/// All that is painted is copied: it is painted on another thread.
void MeasureLayer::renew() {
  if (!m_measuring->isOn()) {
    m_over.reset();
    return m_layer->setPainting({});
  }
  std::vector<Vector3> points, axes;
  const auto mark = [&](const Spot& spot) {
    if (spot.isPoint()) return;
    const double half = m_viewer->stage() ? m_viewer->camera().distance() / 6 : 1;
    axes.push_back(spot.point - half * spot.direction);
    axes.push_back(spot.point + half * spot.direction);
  };
  for (const Measuring::Taken& each : m_measuring->taken()) mark(each.spot);
  const Measurement& result = m_measuring->result();
  if (!m_measuring->taken().empty()) points.push_back(result.from);
  if (m_measuring->taken().size() == 2) points.push_back(result.to);
  if (m_over) mark(*m_over);
  m_layer->setPainting([points, axes, lines = m_measuring->lines(), over = m_over](
                           QPainter& painter, const OverlayPlace& place) {
    if (!isAtReference(place.view)) return;
    const auto at = [&](const Vector3& point) {
      const Eigen::Vector2d on = place.ground.project(wide(point));
      return QPointF(on.x(), on.y());
    };
    const double ratio = place.ground.pixelRatio;
    const QRectF seen(0, place.ground.above, place.ground.viewport.width / ratio,
                      place.ground.viewport.height / ratio - place.ground.above - place.ground.below);
    const QPen dashes(measuredInk(place.isDark), 1.6, Qt::DashDotLine);
    painter.setPen(dashes);
    for (std::size_t i = 0; i + 1 < axes.size(); i += 2) painter.drawLine(at(axes[i]), at(axes[i + 1]));
    if (over && over->isPoint()) paintMeasured(painter, {at(over->point)}, {}, seen, place.isDark);
    std::vector<QPointF> ends;
    for (const Vector3& point : points) ends.push_back(at(point));
    paintMeasured(painter, ends, lines, seen, place.isDark);
  });
}

}  // namespace geargraph

#include "moc_measure_layer.cpp"
