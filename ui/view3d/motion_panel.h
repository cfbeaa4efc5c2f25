#pragma once

#include <QWidget>

#include "core/foundations/base/request_worker.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/stage/motion_curves.h"
#include "ui/selection/selection.h"
#include "ui/service/background_work.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace geargraph::inline view3d {

class MotionPlot;
class View3D;

/// Speeds over one period of the motion, or along the trajectory that the 3D view plays: of the selected
/// joints and links, and of the points whose paths the 3D view shows. They are computed on a thread of its
/// own, the newest request wins; nothing is while the panel is not seen.
class MotionPanel : public QWidget, public BackgroundWork {
  Q_OBJECT

 public:
  MotionPanel(Selection* selection, View3D* view, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<CurveSheet>& sheets() const { return m_sheets; }
  void setComponents(bool shown);
  /// The document that names in legends are taken from. Sheets, and the files made of them, have labels only.
  void setNames(const MechanismPtr& newest);
  void tellToEnd() override { m_worker.tellToEnd(); }
  [[nodiscard]] bool hasEnded() const override { return m_worker.hasEnded(); }
  /// Do the sheets show what is chosen now?
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_wanted; }

 signals:
  void fileWanted();  ///< the sheets are to be saved

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Request {
    StagePtr stage;
    StageView view;
    CurveChoice choice;
    quint64 number = 0;
  };

  void renew();
  void renewIfSeen();
  void showSheets();
  [[nodiscard]] CurveSheet withNames(CurveSheet sheet) const;
  void arrived(std::vector<CurveSheet> sheets, quint64 number);

  Selection* m_selection;
  View3D* m_view;
  MechanismPtr m_names;
  std::vector<CurveSheet> m_sheets;
  std::vector<MotionPlot*> m_plots;
  QLabel* m_empty;
  QCheckBox* m_components;
  QToolButton* m_save;
  quint64 m_wanted = 0;
  quint64 m_shown = 0;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline view3d
