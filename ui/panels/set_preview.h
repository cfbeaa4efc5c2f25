#pragma once

#include <QWidget>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A preview of a gear set: the pitch circles of gears on parallel axes seen along them, the pitch cones of
/// bevel gears seen from the side, in the colours of the links, with the links' names.
class SetPreview : public QWidget {
  Q_OBJECT

 public:
  explicit SetPreview(QWidget* parent = nullptr);

  /// An empty mechanism shows nothing.
  void setMechanism(const Mechanism& mechanism);
  [[nodiscard]] QSize sizeHint() const override { return {300, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QPointF projected(const Vector3& point) const;
  [[nodiscard]] QRectF extent() const;
  void paintWheel(QPainter& painter, const MeshGeometry& mesh, bool tail) const;
  void paintNames(QPainter& painter) const;

  Mechanism m_mechanism;
  Placement m_placement;
  bool m_across = false;  ///< bevel gears: seen along x
};

}  // namespace geargraph
