#pragma once

#include <QWidget>

#include "core/presentation/stage/motion_curves.h"
#include "ui/selection/selection.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace geargraph::inline view3d {

class MotionPlot;
class View3D;

/// Speeds over one period of the motion: of the selected joints and links, and of the points whose paths the
/// 3D view shows. It computes nothing while it is not seen.
class MotionPanel : public QWidget {
  Q_OBJECT

 public:
  MotionPanel(Selection* selection, View3D* view, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<CurveSheet>& sheets() const { return m_sheets; }
  void setComponents(bool shown);

 signals:
  void fileWanted();  ///< the sheets are to be saved

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void renew();
  void renewIfSeen();

  Selection* m_selection;
  View3D* m_view;
  std::vector<CurveSheet> m_sheets;
  std::vector<MotionPlot*> m_plots;
  QLabel* m_empty;
  QCheckBox* m_components;
  QToolButton* m_save;
};

}  // namespace geargraph::inline view3d
