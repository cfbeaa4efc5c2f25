#include "ui/panels/set_preview.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/panels/results_delegate.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kMaxPreviewNames = 16;  // beyond, the wheels would have no room
constexpr int kNameHeight = 18;

/// One row for two names; the last says how many are left out.
int nameRows(int links) {
  return (std::min(links, kMaxPreviewNames) + 1) / 2 + (links > kMaxPreviewNames ? 1 : 0);
}

/// The point on the other side of the axis.
Vector3 mirrored(const Vector3& point, const AxisLine& line) {
  const Vector3 foot = line.point + dot(point - line.point, line.direction) * line.direction;
  return foot + (foot - point);
}

}  // namespace

SetPreview::SetPreview(QWidget* parent) : QWidget(parent), m_mechanism(emptyMechanism()) {
  setMinimumSize(240, 260);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
}

void SetPreview::setMechanism(const Mechanism& mechanism) {
  m_mechanism = mechanism;
  m_placement = placementOf(mechanism);
  m_across = std::any_of(m_placement.meshes.begin(), m_placement.meshes.end(),
                         [](const auto& mesh) { return mesh && hasIntersectingAxes(mesh->kind); });
  update();
}

QPointF SetPreview::projected(const Vector3& point) const {
  return m_across ? QPointF(point[1], -point[2]) : QPointF(point[0], -point[1]);
}

std::pair<QPointF, double> SetPreview::pulley(std::size_t mesh, bool tail) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const GearMesh& belt = m_mechanism.gearMeshes[mesh];
  const AxisLine& line = m_placement.lineOfClass(tail ? geometry.tailClass : geometry.headClass);
  const double teeth = tail ? belt.tailTeeth : belt.headTeeth;
  const std::optional<Number>& diameter = tail ? belt.tailDiameter : belt.headDiameter;
  double radius = belt.pitch ? belt.pitch->value() * teeth / (2 * std::numbers::pi) : 0;
  if (diameter) radius = diameter->value() / 2;
  if (radius == 0) radius = length(geometry.tailToHead) / 3 * teeth / (belt.tailTeeth + belt.headTeeth);
  return {projected(line.point), radius};
}

QRectF SetPreview::extent() const {
  QRectF all;
  const auto add = [&](QPointF centre, double radius) {
    all = all.united(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius));
  };
  for (std::size_t i = 0; i < m_placement.meshes.size(); ++i) {
    const auto& mesh = m_placement.meshes[i];
    if (!mesh) continue;
    for (const bool tail : {true, false}) {
      if (!touches(mesh->kind)) {
        const auto [centre, radius] = pulley(i, tail);
        if (pairKind(mesh->kind).canCross) add(centre, radius);
        continue;
      }
      const AxisLine& line = m_placement.lineOfClass(tail ? mesh->tailClass : mesh->headClass);
      const QPointF a = projected(mesh->pitchPoint);
      const QPointF b = projected(mirrored(mesh->pitchPoint, line));
      add((a + b) / 2, tail ? mesh->tailPitchRadius() : mesh->headPitchRadius());
    }
  }
  return all;
}

/// Two pulleys and the strands that touch both, crossed or not.
void SetPreview::paintBelt(QPainter& painter, std::size_t mesh) const {
  const MeshGeometry& geometry = *m_placement.meshes[mesh];
  const auto [a, first] = pulley(mesh, true);
  const auto [b, second] = pulley(mesh, false);
  QPen pen(qColor(ColorRole::secondary, themeOf(palette())), 1.5);
  pen.setCosmetic(true);
  const QPointF way = b - a;
  const double apart = std::hypot(way.x(), way.y());
  const double turned = m_mechanism.gearMeshes[mesh].crossed ? -second : second;
  if (apart > std::abs(first - turned)) {
    painter.setPen(pen);
    const double along = (first - turned) / apart;
    for (const double side : {1.0, -1.0}) {
      const double across = side * std::sqrt(1 - along * along);
      const QPointF normal = along * way / apart + across * QPointF(-way.y(), way.x()) / apart;
      painter.drawLine(a + first * normal, b + turned * normal);
    }
  }
  for (const bool tail : {true, false}) {
    const auto [centre, radius] = tail ? std::pair(a, first) : std::pair(b, second);
    pen.setColor(qColor(linkColor(m_mechanism.colorNumber(tail ? geometry.tail : geometry.head))));
    pen.setWidthF(2.5);
    QColor fill = pen.color();
    fill.setAlphaF(0.12F);
    painter.setPen(pen);
    painter.setBrush(fill);
    painter.drawEllipse(centre, radius, radius);
  }
}

void SetPreview::paintWheel(QPainter& painter, const MeshGeometry& mesh, bool tail, double lineWidth) const {
  const int link = tail ? mesh.tail : mesh.head;
  const AxisLine& line = m_placement.lineOfClass(tail ? mesh.tailClass : mesh.headClass);
  const double radius = tail ? mesh.tailPitchRadius() : mesh.headPitchRadius();
  const QPointF a = projected(mesh.pitchPoint);
  const QPointF b = projected(mirrored(mesh.pitchPoint, line));
  QPen pen(qColor(linkColor(m_mechanism.colorNumber(link))), lineWidth);
  pen.setCosmetic(true);
  painter.setPen(pen);
  const bool isRing = hasRing(mesh.kind) && radius > std::abs(tail ? mesh.headRadius : mesh.tailRadius);
  QColor fill = pen.color();
  fill.setAlphaF(isRing || !hasParallelAxes(mesh.kind) ? 0.0F : 0.12F);
  painter.setBrush(fill);
  if (hasParallelAxes(mesh.kind)) {
    painter.drawEllipse((a + b) / 2, radius, radius);
    return;
  }
  if (hasSkewAxes(mesh.kind)) {  // as a roll, or a circle where it is seen along its axis
    const QPointF along = projected(line.point + line.direction) - projected(line.point);
    if (std::hypot(along.x(), along.y()) < 0.5) {
      painter.drawEllipse((a + b) / 2, radius, radius);
      return;
    }
    const double half = pairKind(mesh.kind).isThreaded
                            ? std::min(mesh.tailPitchRadius(), mesh.headPitchRadius()) * 2
                            : radius / 2;
    const QPointF way = half / std::hypot(along.x(), along.y()) * along;
    painter.drawPolygon(QPolygonF({a + way, b + way, b - way, a - way}));
    return;
  }
  painter.drawLine(a, b);
  pen.setWidthF(1);
  painter.setPen(pen);
  const AxisLine& other = m_placement.lineOfClass(tail ? mesh.headClass : mesh.tailClass);
  const QPointF apex =
      projected(apexOf(GearPair<double>{line.point, line.direction, other.point, other.direction, 1, 1}));
  painter.drawLine(apex, a);
  painter.drawLine(apex, b);
}

void SetPreview::paintNames(QPainter& painter) const {
  painter.setPen(qColor(ColorRole::ink, themeOf(palette())));
  const int count = std::min(m_mechanism.n(), kMaxPreviewNames);
  const int rows = nameRows(m_mechanism.n());
  for (int link = 1; link <= count; ++link) {
    const int column = (link - 1) % 2;
    const double y = height() - 12 - (rows - 1 - (link - 1) / 2) * kNameHeight;
    const double x = 14 + column * width() / 2.0;
    paintLinkDot(painter, {x, y}, m_mechanism.colorNumber(link));
    const QString name = QString::fromStdString(m_mechanism.links[static_cast<std::size_t>(link)].name);
    painter.drawText(QPointF(x + 12, y + 4), QStringLiteral("%1 %2").arg(link).arg(name));
  }
  if (m_mechanism.n() > count) {
    painter.setPen(qColor(ColorRole::secondary, themeOf(palette())));
    painter.drawText(QPointF(14, height() - 8), tr("and %1 more").arg(m_mechanism.n() - count));
  }
}

void SetPreview::paintSet(QPainter& painter, const QRectF& room, double lineWidth) const {
  const QRectF all = extent();
  const double scale = std::min(room.width() / all.width(), room.height() / all.height());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(room.center());
  painter.scale(scale, scale);
  painter.translate(-all.center());
  for (std::size_t i = 0; i < m_placement.meshes.size(); ++i) {
    const auto& mesh = m_placement.meshes[i];
    if (!mesh) continue;
    if (touches(mesh->kind)) {
      paintWheel(painter, *mesh, true, lineWidth);
      paintWheel(painter, *mesh, false, lineWidth);
    } else if (pairKind(mesh->kind).canCross) {
      paintBelt(painter, i);
    }
  }
}

void SetPreview::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (extent().isEmpty()) return;
  paintNames(painter);
  const int names = nameRows(m_mechanism.n()) * kNameHeight;
  paintSet(painter, QRectF(rect()).adjusted(12, 12, -12, -20 - names), 2.5);
}

QPixmap SetPreview::picture(const Mechanism& mechanism, QSize size, const QPalette& palette,
                            double pixelRatio) {
  QPixmap pixmap((QSizeF(size) * pixelRatio).toSize());
  pixmap.setDevicePixelRatio(pixelRatio);
  pixmap.fill(Qt::transparent);
  SetPreview preview;
  preview.setPalette(palette);
  preview.setMechanism(mechanism);
  if (preview.extent().isEmpty()) return pixmap;
  QPainter painter(&pixmap);
  preview.paintSet(painter, QRectF(QPointF(), QSizeF(size)).adjusted(2, 2, -2, -2), 1.5);
  return pixmap;
}

}  // namespace geargraph

#include "moc_set_preview.cpp"
