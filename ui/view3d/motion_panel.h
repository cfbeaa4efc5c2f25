#pragma once

#include <QWidget>

#include "core/foundations/base/request_worker.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/scene3d/motion_curves.h"
#include "ui/document/selection.h"
#include "ui/service/background_work.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace geargraph {

class MotionPlot;
class View3D;

/// Plots of speeds over one period of the motion, or along the trajectory played by the 3D view: of the
/// selected joints and links, and of the points traced in the 3D view. Computed on a background thread for
/// the newest request; a hidden panel computes nothing.
class MotionPanel : public QWidget, public ResultsView, public BackgroundWork {
  Q_OBJECT

 public:
  MotionPanel(Selection* selection, View3D* view, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  [[nodiscard]] QString emptyText() const override;
  [[nodiscard]] const std::vector<CurveSheet>& sheets() const { return m_sheets; }
  void setComponents(bool shown);
  /// Sets the document that names in legends are taken from. Sheets, and files exported from them, have
  /// labels only.
  void setMechanism(const MechanismPtr& newest) override;
  void requestStop() override { m_worker.requestStop(); }
  [[nodiscard]] bool hasStopped() const override { return m_worker.hasStopped(); }
  /// Do the sheets show the current choice?
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_wanted; }

 signals:
  void fileWanted();  ///< the sheets are to be saved

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Request {
    MechanismScenePtr stage;
    SceneView view;
    CurveChoice choice;
    quint64 number = 0;
  };

  void renew();
  void updateIfSeen();
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
  RequestWorker<Request> m_worker;  ///< last: stopped before the members it uses are destroyed
};

[[nodiscard]] ViewEntry speedsView();

}  // namespace geargraph
