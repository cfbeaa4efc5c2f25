#include "ui/view3d/overlay.h"

#include <QPainter>
#include <cmath>

namespace geargraph {
namespace {

constexpr double kLongestBar = 110, kFromRight = 16, kTick = 4;  // logical pixels
constexpr double kBarFromBelow = 24;                             // of a picture in a file

void paintScaleBar(QPainter& painter, const OverlayGround& ground, bool dark) {
  const double ratio = ground.pixelRatio;
  const double perPixel = ground.camera.millimetresPerPixel(ground.viewport) * ratio;
  const double length = niceLength(perPixel, kLongestBar);
  const double right = ground.viewport.width / ratio - kFromRight;
  const double left = right - length / perPixel, y = ground.viewport.height / ratio - ground.barFromBelow;
  const QColor ink = dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80);
  painter.fillRect(QRectF(left, y - 1, right - left, 1.6), ink);
  painter.fillRect(QRectF(left, y - kTick, 1.6, 2 * kTick), ink);
  painter.fillRect(QRectF(right - 1.6, y - kTick, 1.6, 2 * kTick), ink);
  painter.setPen(ink);
  painter.drawText(
      QRectF(right - 200, y - 24, 200, 20), Qt::AlignRight | Qt::AlignBottom,
      QStringLiteral("%1 %2").arg(length, 0, 'g', 6).arg(QString::fromStdString(ground.stage.unit)));
}

}  // namespace

void paintOverlay(QPainter& painter, const OverlayGround& ground, LabelLayer& labels, bool scaleBar,
                  bool dark) {
  const auto placed = labels.place(ground.stage, ground.poses, ground.camera, ground.viewport,
                                   ground.pixelRatio, ground.showing);
  labels.paint(painter, ground.stage, placed, dark);
  if (scaleBar) paintScaleBar(painter, ground, dark);
}

void paintOverlay(QPainter& painter, const Viewer& viewer, LabelLayer& labels, bool dark) {
  if (viewer.stage() == nullptr || viewer.stage()->scene.instances.empty()) return;
  const OverlayGround ground{*viewer.stage(), viewer.poses(),    viewer.showing(),
                             viewer.camera(), viewer.viewport(), viewer.pixelRatio()};
  paintOverlay(painter, ground, labels, viewer.options().scaleBar, dark);
}

void paintOverlay(Image& image, const OverlayGround& ground, const ViewOptions& options, bool dark) {
  LabelLayer labels;
  labels.setShown(LabelKind::link, options.linkLabels);
  labels.setShown(LabelKind::joint, options.jointLabels);
  labels.setShown(LabelKind::axis, options.axisLabels);
  QImage pixels(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  pixels.setDevicePixelRatio(ground.pixelRatio);
  QPainter painter(&pixels);
  OverlayGround lower = ground;
  lower.barFromBelow = kBarFromBelow;
  paintOverlay(painter, lower, labels, options.scaleBar, dark);
}

}  // namespace geargraph
