#include "ui/view3d/overlay_layer.h"

#include <QFont>
#include <QImage>
#include <QPainter>

#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

OverlayLayer::OverlayLayer(Viewer* viewer, bool sharesLabels)
    : QObject(viewer), m_viewer(viewer), m_sharesLabels(sharesLabels) {}

void OverlayLayer::setPainting(PaintOver painting) {
  if (!painting && !m_painting) return;
  m_painting = std::move(painting);
  if (m_sharesLabels) m_viewer->setLabelsShared(static_cast<bool>(m_painting));
  emit m_viewer->viewChanged();
}

void paintLayer(QPainter& painter, const LabelGround& ground, const Viewer& viewer, bool isDark) {
  if (ground.stage.scene.instances.empty()) return;
  const double scale = overlayScale();
  const LabelGround enlarged = ground.enlarged(scale);
  const ShownForces forces = viewer.shownForces();
  painter.save();
  painter.scale(scale, scale);
  painter.setRenderHint(QPainter::Antialiasing);
  const double top = bottomOfForceLegend(painter, enlarged, forces);
  for (const auto* layer : viewer.findChildren<const OverlayLayer*>()) {
    if (layer->painting())
      layer->painting()(painter, {enlarged, viewer.view(), top, isDark, forces.highlighted});
  }
  painter.restore();
}

void paintLayer(Image& image, const LabelGround& ground, const SceneView& view, const PaintOver& painting,
                bool isDark, const ShownForces& forces) {
  if (!painting || image.width <= 0) return;
  QImage pixels(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  pixels.setDevicePixelRatio(ground.pixelRatio);
  QPainter painter(&pixels);
  painter.setRenderHint(QPainter::Antialiasing);
  painting(painter, {ground, view, bottomOfForceLegend(painter, ground, forces), isDark, {}});
}

}  // namespace geargraph

#include "moc_overlay_layer.cpp"
