#include "ui/view3d/overlay.h"

#include <QPainter>
#include <cmath>

namespace geargraph::inline view3d {
namespace {

constexpr double kLongestBar = 110, kFromRight = 16, kTick = 4;  // logical pixels
constexpr double kBarFromBelow = 24, kBarOverPlayback = 52;      // in a file; in the window

void paintScaleBar(QPainter& painter, const LabelGround& ground, double fromBelow, bool dark) {
  const double ratio = ground.pixelRatio;
  const double perPixel = ground.camera.millimetresPerPixel(ground.viewport) * ratio;
  const double length = niceLength(perPixel, kLongestBar);
  const double right = ground.viewport.width / ratio - kFromRight;
  const double left = right - length / perPixel, y = ground.viewport.height / ratio - fromBelow;
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

void paintOverlay(QPainter& painter, const LabelGround& ground, LabelLayer& labels, bool scaleBar,
                  bool dark) {
  if (ground.stage.scene.instances.empty()) return;
  labels.place(ground);
  labels.paint(painter, ground.stage, dark);
  if (scaleBar) paintScaleBar(painter, ground, kBarOverPlayback, dark);
}

PictureOverlay::PictureOverlay(const ViewOptions& options, bool dark)
    : m_scaleBar(options.scaleBar), m_dark(dark) {
  m_labels.setShown(LabelKind::link, options.linkLabels);
  m_labels.setShown(LabelKind::joint, options.jointLabels);
  m_labels.setShown(LabelKind::axis, options.axisLabels);
}

void PictureOverlay::paint(Image& image, const LabelGround& ground) {
  QImage pixels(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  pixels.setDevicePixelRatio(ground.pixelRatio);
  QPainter painter(&pixels);
  m_labels.place(ground);
  m_labels.paint(painter, ground.stage, m_dark);
  if (m_scaleBar) paintScaleBar(painter, ground, kBarFromBelow, m_dark);
}

}  // namespace geargraph::inline view3d
