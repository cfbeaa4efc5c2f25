#include "ui/view3d/label_layer.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kTextSize = 12;

QColor colorOf(const Rgb& rgb) {
  return QColor::fromRgbF(rgb.red, rgb.green, rgb.blue);
}

QPointF pointOf(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

QColor sheetColor(bool dark) {
  return dark ? QColor(0x26, 0x2B, 0x31) : QColor(Qt::white);
}

/// Device pixels for one of the painter's, which may be enlarged.
double ratioOf(const QPainter& painter) {
  return painter.device()->devicePixelRatio() * painter.worldTransform().m11();
}

/// The image with its corner on a whole device pixel, so that it stays sharp.
void drawAt(QPainter& painter, const QPointF& corner, const QImage& image) {
  const double ratio = image.devicePixelRatio();
  painter.drawImage(QPointF(std::round(corner.x() * ratio), std::round(corner.y() * ratio)) / ratio, image);
}

/// The line from a plate to its part, with a dot at its end; a rim sets it off from any part.
void drawLine(QPainter& painter, const LabelPlate& plate, const QColor& color, bool dark) {
  constexpr double kLine = 1.4, kDot = 2.2, kRim = 1;
  const QPointF from = pointOf(plate.rim()), to = pointOf(plate.anchor);
  const double ratio = ratioOf(painter), margin = kDot + kRim + 1;
  const QRectF box = QRectF(from, to).normalized().adjusted(-margin, -margin, margin, margin);
  const QPointF corner = QPointF(std::floor(box.x() * ratio), std::floor(box.y() * ratio)) / ratio;
  QImage image((box.size() * ratio).toSize() + QSize(2, 2), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter line(&image);
  line.setRenderHint(QPainter::Antialiasing);
  line.translate(-corner);
  for (const bool isRim : {true, false}) {
    const QColor ink = isRim ? sheetColor(dark) : color;
    line.setPen(QPen(ink, isRim ? kLine + 2 * kRim : kLine));
    line.drawLine(from, to);
    line.setPen(Qt::NoPen);
    line.setBrush(ink);
    const double dot = isRim ? kDot + kRim : kDot;
    line.drawEllipse(to, dot, dot);
  }
  line.end();
  drawAt(painter, corner, image);
}

/// A link is a disc as in the digraph, a joint a square, an axis a rounded plate without a border.
QImage plateImage(const SceneLabel& label, QFont font, bool dark, double ratio) {
  const QString text = QString::fromStdString(label.text);
  const int side = 2 * static_cast<int>(std::ceil((kLabelRadius + 2) * ratio));
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF whole({}, QSizeF(side, side) / ratio);
  painter.setPen(label.kind == LabelKind::axis ? QPen(Qt::NoPen) : QPen(colorOf(label.colour), 2.2));
  painter.setBrush(sheetColor(dark));
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

double overlayScale() {
  return scaledPixels(100) / 100.0;
}

const std::vector<LabelPlate>& LabelLayer::place(const LabelGround& ground) {
  return m_plates = m_places.find(ground);
}

void LabelLayer::paint(QPainter& painter, const MechanismScene& stage, bool dark) {
  const double ratio = ratioOf(painter);
  for (const LabelPlate& plate : m_plates) {
    if (plate.hasLine()) drawLine(painter, plate, colorOf(stage.labels[plate.label].colour), dark);
  }
  for (const LabelPlate& plate : m_plates) {
    const SceneLabel& label = stage.labels[plate.label];
    const QString key =
        QStringLiteral("%1 %2 %3 %4 %5 %6")
            .arg(QString::fromStdString(label.text), colorOf(label.colour).name(), painter.font().family())
            .arg(ratio)
            .arg(dark)
            .arg(static_cast<int>(label.kind));
    QImage& image = m_images[key];
    if (image.isNull()) image = plateImage(label, painter.font(), dark, ratio);
    drawAt(painter, pointOf(plate.middle) - QPointF(0.5, 0.5) * (image.width() / ratio), image);
  }
}

QPointF LabelLayer::meant(const QPointF& place) const {
  const double scale = overlayScale();
  for (const LabelPlate& plate : m_plates) {
    const QPointF away = place / scale - pointOf(plate.middle);
    if (std::hypot(away.x(), away.y()) <= kLabelRadius) return scale * pointOf(plate.anchor);
  }
  return place;
}

}  // namespace geargraph
