#pragma once

#include <QHash>
#include <QImage>
#include <QPointF>
#include <QString>
#include <vector>

#include "core/presentation/scene3d/label_places.h"

class QPainter;

namespace geargraph {

/// The scale of labels, forces and the scale bar of the window; 1 at the normal font size.
[[nodiscard]] double overlayScale();

/// The label plates of the shown kinds, facing the viewer, placed by LabelPlaces; a leader line joins a plate
/// placed beside its part to it.
class LabelLayer {
 public:
  void setShown(LabelKind kind, bool shown) { m_places.setShown(kind, shown); }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_places.isShown(kind); }
  void reset() { m_places.reset(); }
  /// Has no map of visible links been used yet? Then one is needed immediately.
  [[nodiscard]] bool areNew() const { return m_places.areNew(); }
  /// Sets the heights at the top and bottom to keep free of labels, in logical pixels of the window.
  void setBorders(double above, double below) {
    m_above = above;
    m_below = below;
    m_places.setBorders(above / overlayScale(), below / overlayScale());
  }
  [[nodiscard]] double above() const { return m_above; }
  [[nodiscard]] double below() const { return m_below; }

  /// Places the labels, without those of hidden instances. Cost: O(labels²), for the separation of
  /// overlapping plates.
  const std::vector<LabelPlate>& place(const LabelGround& ground);
  /// Paints the placed labels. Plates and lines are painted from small images, because a QPainter on OpenGL
  /// does not antialias.
  void paint(QPainter& painter, const MechanismScene& stage, bool dark);
  /// The place to pick for this place: that of the labelled part if a plate is there, else the place itself.
  /// Both in logical pixels of the window.
  [[nodiscard]] QPointF meant(const QPointF& place) const;

 private:
  LabelPlaces m_places;
  double m_above = 0, m_below = 0;
  std::vector<LabelPlate> m_plates;  ///< as last placed
  QHash<QString, QImage> m_images;   ///< by text, colours, font and pixel ratio
};

}  // namespace geargraph
