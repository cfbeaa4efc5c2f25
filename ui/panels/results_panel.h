#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/models/link_speeds_model.h"
#include "ui/models/results_model.h"
#include "ui/selection/selection.h"

class QFrame;
class QLabel;
class QMenu;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace geargraph {

/// What the inputs make of all other joints: their rates for one unit of each input, their rates now, and
/// whether both methods say the same; or the absolute velocities of the links. Speeds in rad/s, rpm or as
/// ratio.
class ResultsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultsPanel(Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot);
  [[nodiscard]] ResultsModel& model() { return *m_model; }
  [[nodiscard]] QString verdict() const;
  /// The absolute velocities of the links instead of the relative ones of the joints.
  void setAbsolute(bool absolute);
  void setUnit(const SpeedUnit& unit);

 signals:
  /// These joints are to be driven (ordinals of the snapshot's digraph), the motion staying as it is.
  void inputsWanted(const std::vector<int>& joints);

 signals:
  /// A right click on the row of this joint.
  void menuWanted(const geargraph::ElementId& joint, QPoint globalPlace);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeTable();
  void makeLinkTable();
  QLayout* makeStrip();
  void fillUnits(QMenu& menu);
  void fillMotors(QMenu& menu);
  void hoverHead(int section);
  void hoverRow(const QModelIndex& index);
  void renew();
  void fitColumns();
  void paintVerdict();
  [[nodiscard]] QString whyNone() const;

  Selection* m_selection;
  ResultsModel* m_model;
  SnapshotPtr m_snapshot;
  QTableView* m_table;
  LinkSpeedsModel* m_linkModel;
  QTableView* m_links;
  QToolButton* m_frame;
  QToolButton* m_unit;
  QToolButton* m_motors;
  bool m_absolute = false;
  QToolButton* m_symbols;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_note;
  QLabel* m_verdict;
  QTimer m_patience;  ///< runs out where solving exactly takes long enough to be said
};

}  // namespace geargraph
