#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/document/selection.h"
#include "ui/motion_panel/motion_sheets.h"

class QButtonGroup;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace geargraph {
class MotionPlot;
class View3D;
}  // namespace geargraph

namespace geargraph {

class MotorsForm;

/// Forward dynamics: the torques of the motors, the resulting motion as plots over time with its energy
/// balance, and its playback in the 3D view. The simulation runs on a background thread and can be stopped;
/// its result is discarded when the mechanism changes.
class MotionPage : public QWidget {
  Q_OBJECT

 public:
  MotionPage(Selection* selection, View3D* view, QWidget* parent = nullptr);

  /// Sets the dynamics of the current mechanism; null: none.
  void show(const DynamicsPtr& dynamics);
  /// Discards the motion, for another mechanism.
  void forget();

  [[nodiscard]] const SimulatedMotionPtr& motion() const { return m_simulations->answer(); }
  [[nodiscard]] bool hasMotion() const;  ///< with at least the start
  [[nodiscard]] bool isRunning() const { return m_simulations->isRunning(); }
  /// The result as a sentence: the energy balance, or why there is no motion.
  [[nodiscard]] QString verdict() const;
  /// The motion as CSV; std::nullopt without a motion. `separator`: of the fields.
  [[nodiscard]] std::optional<std::string> csv(char separator) const;
  [[nodiscard]] MotionPlot& plot() { return *m_plot; }

 signals:
  void motionChanged();  ///< a motion is available, or was discarded

 private:
  QWidget* makeLeft();
  QWidget* makeBar();
  void startOrHalt();
  void onMotion();
  void updateState();
  void updatePlot();
  void play(bool isWanted);
  [[nodiscard]] bool isPlayed() const;

  Selection* m_selection;
  View3D* m_view;
  SimulationService* m_simulations;
  DynamicsPtr m_dynamics;
  SnapshotPtr m_snapshot;           ///< of the motion
  InputTrajectoryPtr m_trajectory;  ///< of the motion
  QTimer m_clock;                   ///< shows the progress
  MotorsForm* m_motors = nullptr;
  QToolButton* m_run = nullptr;
  QProgressBar* m_progress = nullptr;
  QButtonGroup* m_quantities = nullptr;
  QToolButton* m_play = nullptr;
  MotionPlot* m_plot;
  QLabel* m_hint;
  QStackedWidget* m_pages;
};

}  // namespace geargraph
