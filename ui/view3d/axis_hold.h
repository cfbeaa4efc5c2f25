#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/view3d/axis_pull.h"
#include "ui/view3d/viewer.h"

namespace geargraph::inline view3d {

class AxisHandle;

/// Shows the handle where one axis or turning joint is selected, at the end of its line as the picture shows
/// it, and turns ways of the pointer into ways in space: in the plane of the picture, at the handle's depth.
class AxisHold final : public QObject {
  Q_OBJECT

 public:
  /// Over the picture that `view` shows of the viewer.
  AxisHold(Viewer* viewer, Selection* selection, QWidget* view);

  /// Gives the focus to the handle; false where there is none.
  bool takeFocus();

 signals:
  void grabbed();  ///< before the first pull or nudge: the reference pose is wanted
  void pulled(const geargraph::AxisPull& pull);
  void dropped();
  void putBack();
  void nudged(const geargraph::AxisPull& pull);

 private:
  void renew();
  void grab();
  /// The label of what is selected, whose place is on the axis; null where nothing of the kind is.
  [[nodiscard]] const StageLabel* heldLabel() const;
  [[nodiscard]] std::optional<ScreenPoint> place() const;
  [[nodiscard]] AxisPull pullBy(const QPointF& way, bool isFree) const;

  Viewer* m_viewer;
  Selection* m_selection;
  QWidget* m_view;
  AxisHandle* m_handle;
  // As it was when the axis was grabbed:
  ElementId m_held;
  double m_perPixel = 0;  ///< length units a logical pixel at the handle's depth
  Eigen::Vector3d m_right = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_up = Eigen::Vector3d::Zero();
};

}  // namespace geargraph::inline view3d
