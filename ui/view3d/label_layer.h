#pragma once

#include <QHash>
#include <QImage>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

#include "core/render/camera.h"
#include "core/render/label_places.h"
#include "core/render/renderer.h"
#include "core/render/stage.h"

class QPainter;

namespace geargraph {

/// A label's disc in the picture, in logical pixels.
struct PlacedLabel {
  std::size_t label = 0;  ///< position in Stage::labels
  QPointF centre;
  double radius = 0;
};

/// The discs with numbers that face the viewer, of the kinds that are shown: a link's beside its part, on the
/// side away from the train's middle, a joint's and an axis' at its place; pushed apart where two would
/// touch. A disc changes sides only when its part has clearly crossed the middle, so that turning parts do
/// not make it flicker.
class LabelLayer {
 public:
  void setShown(LabelKind kind, bool shown) { m_places.setShown(kind, shown); }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_places.isShown(kind); }
  void reset() { m_places.reset(); }
  void setBorders(double above, double below) { m_places.setBorders(above, below); }

  /// Labels of hidden instances are left out. Cost: O(labels²), for the pushing.
  [[nodiscard]] std::vector<PlacedLabel> place(const Stage& stage, std::span<const Pose> poses,
                                               const Camera& camera, const Viewport& viewport,
                                               double pixelRatio, std::span<const Showing> showing = {});
  /// Discs come from small images, because a painter on OpenGL smooths nothing by itself.
  void paint(QPainter& painter, const Stage& stage, const std::vector<PlacedLabel>& labels, bool dark);
  /// The element of the label under a place.
  [[nodiscard]] static std::optional<ElementId> at(const Stage& stage, const std::vector<PlacedLabel>& labels,
                                                   const QPointF& place);

 private:
  LabelPlaces m_places;
  QHash<QString, QImage> m_images;  ///< by text, colours, font and pixel ratio
};

}  // namespace geargraph
