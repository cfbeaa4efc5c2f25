#include "ui/view3d/overlay.h"

#include <QPainter>
#include <cmath>

namespace geargraph {
namespace {

constexpr double kLongestBar = 110, kFromRight = 16, kFromBelow = 52, kTick = 4;  // logical pixels

void paintScaleBar(QPainter& painter, const Viewer& viewer, bool dark) {
  const double perPixel = viewer.camera().millimetresPerPixel(viewer.viewport()) * viewer.pixelRatio();
  const double length = niceLength(perPixel, kLongestBar);
  const double right = viewer.viewport().width / viewer.pixelRatio() - kFromRight;
  const double left = right - length / perPixel,
               y = viewer.viewport().height / viewer.pixelRatio() - kFromBelow;
  const QColor ink = dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80);
  painter.fillRect(QRectF(left, y - 1, right - left, 1.6), ink);
  painter.fillRect(QRectF(left, y - kTick, 1.6, 2 * kTick), ink);
  painter.fillRect(QRectF(right - 1.6, y - kTick, 1.6, 2 * kTick), ink);
  painter.setPen(ink);
  painter.drawText(
      QRectF(right - 200, y - 24, 200, 20), Qt::AlignRight | Qt::AlignBottom,
      QStringLiteral("%1 %2").arg(length, 0, 'g', 6).arg(QString::fromStdString(viewer.stage()->unit)));
}

}  // namespace

double niceLength(double millimetresPerPixel, double most) {
  const double longest = millimetresPerPixel * most;
  const double decade = std::pow(10, std::floor(std::log10(longest)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= longest) return step * decade;
  }
  return decade;
}

void paintOverlay(QPainter& painter, const Viewer& viewer, LabelLayer& labels, bool dark) {
  if (viewer.stage() == nullptr || viewer.stage()->scene.instances.empty()) return;
  const auto placed = labels.place(*viewer.stage(), viewer.poses(), viewer.camera(), viewer.viewport(),
                                   viewer.pixelRatio(), viewer.showing());
  labels.paint(painter, *viewer.stage(), placed, dark);
  if (viewer.options().scaleBar) paintScaleBar(painter, viewer, dark);
}

}  // namespace geargraph
