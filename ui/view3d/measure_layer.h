#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "core/machine/measure/measure_spots.h"
#include "core/presentation/scene3d/stage.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

class Measuring;
class OverlayLayer;

/// Measures in the 3D view: what the pointer is at snaps to the nearest pitch point, wheel centre or axis on
/// the screen, else to the face of the part under it. The spots are those of the reference pose; the marks
/// are hidden while the train is not in it.
class MeasureLayer final : public QObject {
  Q_OBJECT

 public:
  MeasureLayer(Viewer* viewer, Measuring* measuring);

  /// The spot that a click at a place of the picture would take. Logical pixels.
  [[nodiscard]] const Spot* spotAt(const QPointF& place, const std::optional<Hit>& hit);

 signals:
  void hintChanged(const QString& hint);

 private:
  bool probe(const QPointF& place, const std::optional<Hit>& hit, bool isClick);
  void renew();

  Viewer* m_viewer;
  Measuring* m_measuring;
  OverlayLayer* m_layer;
  std::optional<Spot> m_over;  ///< what a click would take
};

}  // namespace geargraph
