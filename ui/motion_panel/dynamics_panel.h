#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/motion_panel/dynamics_service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QButtonGroup;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace geargraph {
class View3D;
}  // namespace geargraph

namespace geargraph {

class EquationPage;
class InertiaBars;
class MassPage;
class MotionPage;

enum class DynamicsView { masses, inertia, equation, motion };

/// Dynamics of the window's document: masses, inertia reflected to the motors, the equation of motion at the
/// pose of the 3D view, and forward dynamics. Nothing is computed while the panel is hidden.
class DynamicsPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  DynamicsPanel(Document* document, Selection* selection, View3D* view, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  void showView(DynamicsView view);

  [[nodiscard]] bool isUpToDate() const { return m_service->isComplete(); }
  [[nodiscard]] const DynamicsPtr& dynamics() const { return m_service->answer(); }
  [[nodiscard]] MassPage& masses() { return *m_masses; }
  [[nodiscard]] InertiaBars& inertia() { return *m_bars; }
  [[nodiscard]] EquationPage& equation() { return *m_equation; }
  [[nodiscard]] MotionPage& motion() { return *m_motion; }
  [[nodiscard]] QString emptyText() const override;
  /// The line below the view.
  [[nodiscard]] QString remark() const;

 signals:
  /// The view as CSV, under a name for its file.
  void exportWanted(const QString& name, const QString& csv);

 private:
  QWidget* makeBar();
  void ask();
  void showDynamics();
  void showRemark();
  [[nodiscard]] DynamicsView view() const;
  /// The view as a table, and a name for its file; std::nullopt if there is nothing to show.
  [[nodiscard]] std::optional<std::pair<QString, std::string>> csv(char separator) const;

  View3D* m_view3d;
  DynamicsService* m_service;
  SnapshotPtr m_snapshot;
  bool m_isAwake = false;
  QButtonGroup* m_chips = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_export = nullptr;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_remark;
  MassPage* m_masses;
  InertiaBars* m_bars;
  EquationPage* m_equation;
  MotionPage* m_motion;
};

[[nodiscard]] ViewEntry dynamicsView();

}  // namespace geargraph
