#include "ui/view3d/overlay.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/foundations/base/translation.h"
#include "core/presentation/scene3d/force_arrow_shape.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

constexpr double kMaxBarLength = 110, kFromRight = 16, kTick = 4;  // logical pixels
constexpr double kBarFromBelow = 24, kBarOverPlayback = 52;        // in a file; in the window

void paintScaleBar(QPainter& painter, const LabelGround& ground, double fromBelow, bool dark) {
  const double ratio = ground.pixelRatio;
  const double perPixel = ground.camera.millimetresPerPixel(ground.viewport) * ratio;
  const double length = niceLength(perPixel, kMaxBarLength);
  const double right = ground.viewport.width / ratio - kFromRight;
  const double left = right - length / perPixel, y = ground.viewport.height / ratio - fromBelow;
  const QColor ink = dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80);
  painter.fillRect(QRectF(left, y - 1, right - left, 1.6), ink);
  painter.fillRect(QRectF(left, y - kTick, 1.6, 2 * kTick), ink);
  painter.fillRect(QRectF(right - 1.6, y - kTick, 1.6, 2 * kTick), ink);
  painter.setPen(ink);
  painter.drawText(
      QRectF(right - 200, y - 24, 200, 20), Qt::AlignRight | Qt::AlignBottom,
      QStringLiteral("%1 %2").arg(printedNumber(length, 6), QString::fromStdString(ground.stage.unit)));
}

QColor inkOf(bool dark) {
  return dark ? QColor(0xE6, 0xE9, 0xEE) : QColor(0x23, 0x27, 0x2E);
}

QColor sheetOf(bool dark) {
  return dark ? QColor(0x26, 0x2B, 0x31) : QColor(Qt::white);
}

QColor colourOf(ForceKind kind, bool dark) {
  if (kind == ForceKind::tooth) return inkOf(dark);
  return dark ? QColor(0x6C, 0x9B, 0xFF) : QColor(0x2A, 0x68, 0xE4);
}

QPointF pointOf(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

/// Over the solids, as most forces act inside of one, and cased, so that it is seen before any of them.
void paintArrow(QPainter& painter, const ForceArrowShape& shape, const QColor& colour, const QColor& casing) {
  const QPen edge(casing, 2 * kForceCasing, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  painter.setPen(edge);
  painter.setBrush(colour);
  if (shape.isDisc) {
    constexpr double kRadius = kForceDisc + kForceCasing / 2;
    painter.drawEllipse(pointOf(shape.from), kRadius, kRadius);
    return;
  }
  const QPointF head[] = {pointOf(shape.head[0]), pointOf(shape.head[1]), pointOf(shape.head[2])};
  const QLineF shaft(pointOf(shape.from), pointOf(shape.neck));
  painter.setPen(QPen(casing, kForceShaft + 2 * kForceCasing, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(shaft);
  painter.setPen(edge);
  painter.drawPolygon(head, 3);
  painter.setPen(QPen(colour, kForceShaft, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(shaft);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(head, 3);
}

QString legendOf(ForceKind kind) {
  return QString::fromStdString(translated(forceLegend(kind)));
}

constexpr double kLegendLeft = 12, kLegendTop = 40, kLegendLine = 18;  // below "Software 3D"

constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

/// Where the caption stands, wrapped, from this line on.
QRectF captionBox(const QFontMetricsF& metrics, const LabelGround& ground, const QString& caption,
                  double line) {
  constexpr double kWidestCaption = 380;
  const double room = ground.viewport.width / ground.pixelRatio - 2 * kLegendLeft;
  const double wide = std::max(40.0, std::min(kWidestCaption, room) - 12);
  const QRectF needed = metrics.boundingRect(QRectF(0, 0, wide, 1000), kWrapped, caption);
  return {kLegendLeft, line, needed.width() + 14, needed.height() + 4};
}

QFont forceFont(const QPainter& painter) {
  QFont font = painter.font();
  font.setPixelSize(12);
  return font;
}

/// What the colours of arrows mean, on the upper left, and what is not drawn. Returns where it is.
QRectF paintForceLegend(QPainter& painter, const LabelGround& ground, const ShownForces& shown, bool dark) {
  const QColor sheet = sheetOf(dark);
  const QFontMetricsF metrics(painter.font());
  double line = kLegendTop;
  QRectF all;
  for (const ForceKind kind : {ForceKind::tooth, ForceKind::bearing}) {
    if (shown.arrows.empty()) break;
    const QString text = legendOf(kind);
    const QRectF row(kLegendLeft, line, 46 + metrics.horizontalAdvance(text), kLegendLine);
    painter.fillRect(row, sheet);
    painter.fillRect(QRectF(kLegendLeft + 6, line + kLegendLine / 2 - 1.4, 26, 2.8), colourOf(kind, dark));
    painter.setPen(inkOf(dark));
    painter.drawText(row.adjusted(40, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
    line += kLegendLine;
    all |= row;
  }
  if (shown.caption.isEmpty()) return all;
  const QRectF box = captionBox(metrics, ground, shown.caption, line);
  painter.fillRect(box, sheet);
  painter.setPen(inkOf(dark));
  painter.drawText(box.adjusted(6, 2, 0, 0), kWrapped, shown.caption);
  return all | box;
}

/// Arrows, the legend, and boxes in the arrows' colours, of what is not highlighted only where there is room.
void paintForces(QPainter& painter, const LabelGround& ground, const ShownForces& shown, bool dark) {
  if (shown.arrows.empty() && shown.caption.isEmpty()) return;
  const QColor sheet = sheetOf(dark);
  const QFont font = forceFont(painter);
  painter.setFont(font);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const ForceArrow& arrow : shown.arrows)
    paintArrow(painter, forceArrowShape(arrow, ground), colourOf((*shown.forces)[arrow.force].kind, dark),
               dark ? QColor(0x1E, 0x22, 0x27) : QColor(Qt::white));
  painter.restore();
  const QRectF legend = paintForceLegend(painter, ground, shown, dark);
  if (shown.arrows.empty()) return;
  const QFontMetricsF metrics(font);
  const auto widthOf = [&](const std::string& text) {
    return metrics.horizontalAdvance(QString::fromStdString(text));
  };
  for (const ForceLabel& label :
       placeForceLabels(*shown.forces, shown.arrows, shown.highlighted, ground, widthOf)) {
    const SceneForce& force = (*shown.forces)[label.force];
    const QRectF box(std::round(label.middle.x() - label.half.x()),
                     std::round(label.middle.y() - label.half.y()), std::round(2 * label.half.x()),
                     2 * label.half.y());
    const bool hasRoom = !shown.areLabelsShared && !box.intersects(legend);
    if (!hasRoom && !shown.highlighted.contains(force.element)) continue;
    painter.fillRect(box.adjusted(-1, -1, 1, 1), colourOf(force.kind, dark));
    painter.fillRect(box, sheet);
    painter.setPen(inkOf(dark));
    painter.drawText(box, Qt::AlignCenter, QString::fromStdString(force.text));
  }
}

}  // namespace

void paintOverlay(QPainter& painter, const LabelGround& ground, LabelLayer& labels, bool scaleBar, bool dark,
                  const ShownForces& forces) {
  if (ground.stage.scene.instances.empty()) return;
  // In larger pixels, so that plates, gaps and type keep their proportions.
  const double scale = overlayScale();
  const LabelGround enlarged = ground.enlarged(scale);
  painter.save();
  painter.scale(scale, scale);
  QFont font = painter.font();
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(QFontInfo(font).pixelSize() / scale))));
  painter.setFont(font);
  labels.place(enlarged);
  labels.paint(painter, ground.stage, dark);
  paintForces(painter, enlarged, forces, dark);
  if (scaleBar) paintScaleBar(painter, enlarged, kBarOverPlayback / scale, dark);
  painter.restore();
}

double bottomOfForceLegend(const QPainter& painter, const LabelGround& ground, const ShownForces& shown) {
  double line = kLegendTop + (shown.arrows.empty() ? 0 : 2 * kLegendLine);
  if (!shown.caption.isEmpty())
    line = captionBox(QFontMetricsF(forceFont(painter)), ground, shown.caption, line).bottom();
  return line;
}

PictureOverlay::PictureOverlay(const ViewOptions& options, bool dark)
    : m_scaleBar(options.scaleBar), m_dark(dark) {
  m_labels.setShown(LabelKind::link, options.linkLabels);
  m_labels.setShown(LabelKind::joint, options.jointLabels);
  m_labels.setShown(LabelKind::axis, options.axisLabels);
}

void PictureOverlay::paint(Image& image, const LabelGround& ground, const ShownForces& forces) {
  QImage pixels(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  pixels.setDevicePixelRatio(ground.pixelRatio);
  QPainter painter(&pixels);
  m_labels.place(ground);
  m_labels.paint(painter, ground.stage, m_dark);
  paintForces(painter, ground, forces, m_dark);
  if (m_scaleBar) paintScaleBar(painter, ground, kBarFromBelow, m_dark);
}

}  // namespace geargraph
