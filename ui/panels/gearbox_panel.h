#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/models/states_model.h"
#include "ui/selection/selection.h"

class QLabel;
class QMenu;
class QStackedWidget;
class QToolButton;

namespace geargraph::inline panels {

class StatesTable;

/// Brakes, clutches and the shift table. A click on a dot puts a coupling into a state or takes it out; a
/// click on a state engages it in the document (its ratio asks for its links first, where it has none), the
/// letters above engage or release single couplings. All views are of the train as engaged, and all of it is
/// undone like any edit. Each dot has its coupling's torque, under the loads of the document or 1 N m at the
/// drive.
class GearboxPanel : public QWidget {
  Q_OBJECT

 public:
  GearboxPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot);
  /// Is it in sight?
  void setAwake(bool awake);
  /// The shift table of torques of this document; null: there is none.
  void setTorques(const std::shared_ptr<const ForceTable>& torques, const MechanismPtr& mechanism);
  [[nodiscard]] StatesModel& model() { return *m_model; }
  /// The finding, or the hint, under the table.
  [[nodiscard]] QString remark() const;

 public slots:
  /// Engages the state; its drive turns at 1 rad/s.
  void engage(int state);
  void toggleCoupling(int coupling);
  void releaseAll();
  void addBrake();
  void addClutch();
  void addState();

  /// The table as CSV: ratios, torques, efficiencies.
  void copy();
  void wantExport();

 signals:
  /// Torques of all states should be solved now, or no longer.
  void torquesWanted(bool wanted);
  /// The table as CSV, under a name for its file.
  void exportWanted(const QString& name, const QString& csv);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* makeButton(const char* name, const QString& text, const QString& tip);
  void wireTable();
  void apply(const QString& text, Reduce reduce);
  void renew();
  void renewWish();
  void addTableActions(QMenu& menu);
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
  QToolButton* m_release;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_remark;
  bool m_isAwake = false;
  bool m_wantsTorques = false;
  int m_shownState = -1;  ///< whose finding stands under the table
};

}  // namespace geargraph::inline panels
