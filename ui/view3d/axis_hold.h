#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/view3d/axis_pull.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

class AxisHandle;

/// Shows the handle while a single axis or turning joint is selected, at the end of its line in the picture,
/// and converts displacements of the pointer to displacements in space: parallel to the picture plane, at the
/// handle's depth.
class AxisHold final : public QObject {
  Q_OBJECT

 public:
  /// `view`: shows the picture of the viewer; the parent of the handle.
  AxisHold(Viewer* viewer, Selection* selection, QWidget* view);

  /// Gives the focus to the handle; false if there is none.
  bool takeFocus();

 signals:
  void grabbed();  ///< before the first pull or nudge: the train should be in its reference pose
  void pulled(const geargraph::AxisPull& pull);
  void dropped();
  void putBack();
  void nudged(const geargraph::AxisPull& pull);

 private:
  void renew();
  void grab();
  /// The label of the selected axis or joint, which is on the axis; null if no such element is selected.
  [[nodiscard]] const SceneLabel* heldLabel() const;
  [[nodiscard]] std::optional<ScreenPoint> place() const;
  [[nodiscard]] AxisPull pullBy(const QPointF& way, bool isFree) const;

  Viewer* m_viewer;
  Selection* m_selection;
  QWidget* m_view;
  AxisHandle* m_handle;
  // The state when the axis was grabbed:
  ElementId m_held;
  double m_perPixel = 0;  ///< length units per logical pixel at the handle's depth
  Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_up = Eigen::Vector3d::Zero();
};

}  // namespace geargraph
