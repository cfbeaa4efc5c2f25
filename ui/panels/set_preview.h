#pragma once

#include <QWidget>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A preview of a gear set: the pitch circles of gears on parallel axes seen along them, pulleys with their
/// strands, the pitch cones of bevel gears seen from the side, in the colours of the links, with the links'
/// names. Pins in holes have no wheels and are left out.
class SetPreview : public QWidget {
  Q_OBJECT

 public:
  explicit SetPreview(QWidget* parent = nullptr);

  /// An empty mechanism shows nothing.
  void setMechanism(const Mechanism& mechanism);
  [[nodiscard]] QSize sizeHint() const override { return {300, 320}; }

  /// The same without names, as a small picture on a transparent ground.
  [[nodiscard]] static QPixmap picture(const Mechanism& mechanism, QSize size, const QPalette& palette,
                                       double pixelRatio);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QPointF projected(const Vector3& point) const;
  [[nodiscard]] QRectF extent() const;
  /// Centre and radius of a pulley of the mesh with this position.
  [[nodiscard]] std::pair<QPointF, double> pulley(std::size_t mesh, bool tail) const;
  void paintSet(QPainter& painter, const QRectF& room, double lineWidth) const;
  void paintBelt(QPainter& painter, std::size_t mesh) const;
  void paintWheel(QPainter& painter, const MeshGeometry& mesh, bool tail, double lineWidth) const;
  void paintNames(QPainter& painter) const;

  Mechanism m_mechanism;
  Placement m_placement;
  bool m_across = false;  ///< bevel gears: seen along x
};

}  // namespace geargraph
