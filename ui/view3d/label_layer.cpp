#include "ui/view3d/label_layer.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr std::size_t kMostLabels = 60;  // beyond, discs would hide the train
constexpr double kRadius = 11.5;
constexpr double kGap = 5;         // between a part and its disc
constexpr double kCrossed = 0.25;  // of the part's radius beyond the middle: the disc changes sides
constexpr int kRounds = 12;
constexpr int kTextSize = 12;

QColor colorOf(const Rgb& rgb) {
  return QColor::fromRgbF(rgb.red, rgb.green, rgb.blue);
}

/// Moves touching discs apart, a little in each round, and all of them into the picture.
void pushApart(std::vector<PlacedLabel>& labels, double width, double height) {
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t a = 0; a < labels.size(); ++a) {
      for (std::size_t b = a + 1; b < labels.size(); ++b) {
        QPointF away = labels[b].centre - labels[a].centre;
        const double distance = std::hypot(away.x(), away.y());
        const double wanted = labels[a].radius + labels[b].radius + 2;
        if (distance >= wanted) continue;
        away = distance > 1e-3 ? away / distance : QPointF(0, 1);
        labels[a].centre -= 0.5 * (wanted - distance) * away;
        labels[b].centre += 0.5 * (wanted - distance) * away;
      }
    }
    for (PlacedLabel& label : labels) {
      const double edge = label.radius + 2;
      label.centre.setX(std::clamp(label.centre.x(), edge, std::max(edge, width - edge)));
      label.centre.setY(std::clamp(label.centre.y(), edge, std::max(edge, height - edge)));
    }
  }
}

/// A link is a disc as in the digraph, a joint a square, an axis a rounded plate without a border.
QImage plateImage(const StageLabel& label, QFont font, bool dark, double ratio) {
  const QString text = QString::fromStdString(label.text);
  const int side = 2 * static_cast<int>(std::ceil((kRadius + 2) * ratio));
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF whole({}, QSizeF(side, side) / ratio);
  painter.setPen(label.kind == LabelKind::axis ? QPen(Qt::NoPen) : QPen(colorOf(label.colour), 2.2));
  painter.setBrush(dark ? QColor(0x26, 0x2B, 0x31) : QColor(Qt::white));
  const QRectF plate = whole.adjusted(2, 2, -2, -2);
  if (label.kind == LabelKind::link) painter.drawEllipse(whole.center(), kRadius, kRadius);
  if (label.kind == LabelKind::joint) painter.drawRect(plate.adjusted(1, 1, -1, -1));
  if (label.kind == LabelKind::axis) painter.drawRoundedRect(plate.adjusted(0, 2, 0, -2), 4, 4);
  font.setBold(label.kind != LabelKind::axis);
  font.setItalic(label.kind == LabelKind::axis);
  font.setPixelSize(kTextSize);
  const double width = QFontMetricsF(font).horizontalAdvance(text), room = 2 * kRadius - 7;
  if (width > room) font.setPixelSize(std::max(6, static_cast<int>(kTextSize * room / width)));
  painter.setFont(font);
  painter.setPen(dark ? QColor(0xE6, 0xE9, 0xEE) : QColor(0x23, 0x27, 0x2E));
  painter.drawText(whole, Qt::AlignCenter, text);
  return image;
}

}  // namespace

std::vector<PlacedLabel> LabelLayer::place(const Stage& stage, std::span<const Pose> poses,
                                           const Camera& camera, const Viewport& viewport, double pixelRatio,
                                           std::span<const Showing> showing) {
  const auto isShownNow = [&](const StageLabel& label) {
    return isShown(label.kind) && (showing.empty() || showing[label.instance] == Showing::solid);
  };
  const auto count = std::count_if(stage.labels.begin(), stage.labels.end(), isShownNow);
  if (count == 0 || static_cast<std::size_t>(count) > kMostLabels) return {};
  m_sides.resize(stage.labels.size(), 0);
  std::vector<ScreenPoint> middles;
  double centre = 0;
  for (const StageLabel& label : stage.labels) {
    middles.push_back(camera.project(poses[label.instance] * label.place, viewport));
    centre += middles.back().x / static_cast<double>(stage.labels.size());
  }
  std::vector<PlacedLabel> placed;
  for (std::size_t i = 0; i < stage.labels.size(); ++i) {
    const ScreenPoint& middle = middles[i];
    if (middle.depth <= 0 || !isShownNow(stage.labels[i])) continue;
    if (stage.labels[i].kind != LabelKind::link) {
      placed.push_back({i, QPointF(middle.x, middle.y) / pixelRatio, kRadius});
      continue;
    }
    const double reach =
        stage.labels[i].radius / camera.millimetresPerPixel(viewport) * camera.distance() / middle.depth;
    const double off = middle.x - centre;
    if (m_sides[i] == 0 || off * m_sides[i] < -kCrossed * reach) m_sides[i] = off < 0 ? -1 : 1;
    const double away = reach / pixelRatio + kRadius + kGap;
    const QPointF at(middle.x / pixelRatio + 0.93 * m_sides[i] * away, middle.y / pixelRatio - 0.37 * away);
    placed.push_back({i, at, kRadius});
  }
  pushApart(placed, viewport.width / pixelRatio, viewport.height / pixelRatio);
  return placed;
}

void LabelLayer::paint(QPainter& painter, const Stage& stage, const std::vector<PlacedLabel>& labels,
                       bool dark) {
  const double ratio = painter.device()->devicePixelRatio();
  for (const PlacedLabel& placed : labels) {
    const StageLabel& label = stage.labels[placed.label];
    const QString key =
        QStringLiteral("%1 %2 %3 %4 %5 %6")
            .arg(QString::fromStdString(label.text), colorOf(label.colour).name(), painter.font().family())
            .arg(ratio)
            .arg(dark)
            .arg(static_cast<int>(label.kind));
    QImage& image = m_images[key];
    if (image.isNull()) image = plateImage(label, painter.font(), dark, ratio);
    const QPointF corner = placed.centre - QPointF(0.5, 0.5) * (image.width() / ratio);
    painter.drawImage(QPointF(std::round(corner.x() * ratio), std::round(corner.y() * ratio)) / ratio, image);
  }
}

std::optional<ElementId> LabelLayer::at(const Stage& stage, const std::vector<PlacedLabel>& labels,
                                        const QPointF& place) {
  for (const PlacedLabel& label : labels) {
    const QPointF away = place - label.centre;
    if (std::hypot(away.x(), away.y()) <= label.radius) return stage.labels[label.label].element;
  }
  return std::nullopt;
}

}  // namespace geargraph
