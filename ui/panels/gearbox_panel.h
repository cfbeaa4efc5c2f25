#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/states_model.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QLabel;
class QMenu;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class CompareStates;
class DriveTorqueStrip;
class StatesTable;

/// Brakes, clutches and the shift table. A click on a dot adds a coupling to a state or removes it; a click
/// on a state engages it in the document (one on its ratio first asks for the input and output link if it has
/// none); a click on a heading engages or releases that coupling. All views show the train as engaged, and
/// every change can be undone. Beside each dot is the torque of its coupling, under the same torque at the
/// drive of every state, which a field above the table sets, and other loads of the document.
class GearboxPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  GearboxPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  [[nodiscard]] QString emptyText() const override;
  /// Sets the torques of all states of `mechanism`; null: there are none.
  void setTorques(const std::shared_ptr<const ForceTable>& torques, const MechanismPtr& mechanism);
  [[nodiscard]] StatesModel& model() { return *m_model; }
  /// The diagnostic or the hint under the table.
  [[nodiscard]] QString remark() const;

 public slots:
  /// Engages the state with its input at 1 rad/s.
  void engage(int state);
  void toggleCoupling(int coupling);
  void releaseAll();
  /// Marks the row of the state that is looked at in another view; -1: none.
  void showLookedAt(int state);
  void addBrake();
  void addClutch();
  void addState();

  /// Shows two states side by side instead of the table: the engaged one, or else the first, and the next.
  void setComparing(bool isComparing);
  /// Copies the table with tabs: drive, driven, what is engaged, torques, ratios, steps, efficiencies.
  void copy();
  void wantExport();

 signals:
  /// The mouse is over the row of this state; -1: over none.
  void stateHovered(int state);
  /// The torques of all states are needed, or no longer.
  void torquesWanted(bool wanted);
  /// The table as CSV, with a proposed file name.
  void exportWanted(const QString& name, const QString& csv);

 private:
  QToolButton* makeButton(const char* name, const QString& text, const QString& tip);
  [[nodiscard]] QString torqueRemark() const;
  void wireTable();
  void apply(const QString& text, Reduce reduce);
  void renew();
  void updateTorqueRequest();
  void addTableActions(QMenu& menu);
  void updateButtons();
  void paintRemark();
  void toggleDot(int state, int coupling, bool engaged);
  void onClick(const QModelIndex& index);
  void chooseLinks(int state, const QPoint& at);
  void askLinks(int state, const QPoint& at, quint64 gesture);
  void rowMenu(const QPoint& at);
  void headMenu(const QPoint& at);
  void hoverCell(const QModelIndex& index);
  void hoverCoupling(int section);
  void chooseLink(QMenu& menu, const std::function<void(LinkId)>& chosen, std::optional<LinkId> without = {});
  [[nodiscard]] std::vector<LinkId> selectedLinks() const;

  Document* m_document;
  Selection* m_selection;
  StatesModel* m_model;
  StatesTable* m_table;
  QToolButton* m_brake;
  QToolButton* m_clutch;
  QToolButton* m_state;
  QToolButton* m_compare;
  QToolButton* m_export;
  QToolButton* m_release;
  DriveTorqueStrip* m_torque;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  CompareStates* m_comparison;
  QLabel* m_remark;
  bool m_isAwake = false;
  bool m_wantsTorques = false;
  int m_shownState = -1;  ///< the state whose diagnostic is shown under the table
};

[[nodiscard]] ViewEntry gearboxView();

}  // namespace geargraph
