#include "ui/view3d/label_layer.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr int kTextSize = 12;

QColor colorOf(const Rgb& rgb) {
  return QColor::fromRgbF(rgb.red, rgb.green, rgb.blue);
}

/// A link is a disc as in the digraph, a joint a square, an axis a rounded plate without a border.
QImage plateImage(const StageLabel& label, QFont font, bool dark, double ratio) {
  const QString text = QString::fromStdString(label.text);
  const int side = 2 * static_cast<int>(std::ceil((kLabelRadius + 2) * ratio));
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF whole({}, QSizeF(side, side) / ratio);
  painter.setPen(label.kind == LabelKind::axis ? QPen(Qt::NoPen) : QPen(colorOf(label.colour), 2.2));
  painter.setBrush(dark ? QColor(0x26, 0x2B, 0x31) : QColor(Qt::white));
  const QRectF plate = whole.adjusted(2, 2, -2, -2);
  if (label.kind == LabelKind::link) painter.drawEllipse(whole.center(), kLabelRadius, kLabelRadius);
  if (label.kind == LabelKind::joint) painter.drawRect(plate.adjusted(1, 1, -1, -1));
  if (label.kind == LabelKind::axis) painter.drawRoundedRect(plate.adjusted(0, 2, 0, -2), 4, 4);
  font.setBold(label.kind != LabelKind::axis);
  font.setItalic(label.kind == LabelKind::axis);
  font.setPixelSize(kTextSize);
  const double width = QFontMetricsF(font).horizontalAdvance(text), room = 2 * kLabelRadius - 7;
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
  std::vector<PlacedLabel> placed;
  for (const LabelPlace& place : m_places.find({stage, poses, showing, camera, viewport, pixelRatio}))
    placed.push_back({place.label, {place.x, place.y}, kLabelRadius});
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
