#pragma once

#include <QHash>
#include <QImage>
#include <QPointF>
#include <QString>
#include <vector>

#include "core/presentation/stage/label_places.h"

class QPainter;

namespace geargraph::inline view3d {

/// How much larger than at the normal type size labels, forces and the scale bar of the window are.
[[nodiscard]] double overlayScale();

/// The plates with numbers that face the viewer, of the kinds that are shown, where LabelPlaces puts them;
/// from one that stands beside its part a line leads there.
class LabelLayer {
 public:
  void setShown(LabelKind kind, bool shown) { m_places.setShown(kind, shown); }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_places.isShown(kind); }
  void reset() { m_places.reset(); }
  /// Nothing tells yet where links are seen: a map is wanted at once.
  [[nodiscard]] bool areNew() const { return m_places.areNew(); }
  /// Of the window's own logical pixels.
  void setBorders(double above, double below) {
    m_places.setBorders(above / overlayScale(), below / overlayScale());
  }

  /// Labels of hidden instances are left out. Cost: O(labels²), for the pushing.
  const std::vector<LabelPlate>& place(const LabelGround& ground);
  /// Paints what was placed. Plates and lines come from small images, because a painter on OpenGL smooths
  /// nothing by itself.
  void paint(QPainter& painter, const Stage& stage, bool dark);
  /// What somebody means who points here: the part that the plate under the place speaks of, else the place.
  /// In the window's own logical pixels, as the place.
  [[nodiscard]] QPointF meant(const QPointF& place) const;

 private:
  LabelPlaces m_places;
  std::vector<LabelPlate> m_plates;  ///< as they were placed last
  QHash<QString, QImage> m_images;   ///< by text, colours, font and pixel ratio
};

}  // namespace geargraph::inline view3d
