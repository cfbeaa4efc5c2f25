#pragma once

#include <QFont>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <utility>

#include "ui/document/selection.h"
#include "ui/models/link_speeds_model.h"
#include "ui/models/link_text.h"
#include "ui/models/results_model.h"
#include "ui/service/turns.h"
#include "ui/theme/application_theme.h"

class QFrame;
class QLabel;
class QMenu;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace geargraph {

/// The solution: the rates of all other joints for one unit of each input, their current rates, and whether
/// both methods agree; or the absolute velocities of the links. Speeds in rad/s, rpm or as ratios, of what
/// slides in lengths a second.
class ResultsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultsPanel(Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot);
  [[nodiscard]] ResultsModel& model() { return *m_model; }
  [[nodiscard]] QString verdict() const;
  /// The number of rate columns fitted to their contents: only those that are or were visible, or nearly so.
  [[nodiscard]] int columnsFitted() const;
  /// Sets the document that names of links are taken from.
  void setNames(const MechanismPtr& newest);
  /// Shows the absolute velocities of the links instead of the relative ones of the joints.
  void setAbsolute(bool absolute);
  /// Shows the velocities of the links relative to this one.
  void setObserver(LinkId observer);
  void setUnit(const SpeedUnit& unit);
  void showUnit();
  /// While not awake (behind another panel) the panel takes results but updates its layout only when visible
  /// again.
  void setAwake(bool awake);
  /// The text shown instead of the rates; empty while they are shown.
  [[nodiscard]] QString emptyText() const;

 signals:
  /// These joints (ordinals of the snapshot's digraph) are to become the inputs, with the same motion.
  void inputsWanted(const std::vector<int>& joints);
  /// A right click on the row of this joint.
  void menuWanted(const geargraph::ElementId& joint, QPoint globalPlace);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeTable();
  void makeLinkTable();
  QLayout* makeStrip();
  void showLinkSpeeds(bool shown);
  void updateFrame();
  void fillFrames(QMenu& menu);
  void fillUnits(QMenu& menu);
  void fillMotors(QMenu& menu);
  void hoverHead(int section);
  void hoverRow(const QModelIndex& index);
  void renew();
  void updateNote();
  void updateRatio();
  void typeChanged();
  void fitToType();
  void fitColumns();
  [[nodiscard]] int widthOfColumn(int column) const;
  [[nodiscard]] int narrowed(int& first, int wanted) const;
  void paintVerdict();
  /// The row whose ratio is shown: that of the selected joint or link, else ResultsModel::ratioRow().
  [[nodiscard]] int ratioRow() const;
  /// The verdict on the two methods; std::nullopt while the former verdict stays shown for a moment.
  [[nodiscard]] std::optional<std::pair<QString, ColorRole>> verdictNow() const;
  [[nodiscard]] bool isWaiting() const;
  [[nodiscard]] QString unavailableReason() const;

  Selection* m_selection;
  ResultsModel* m_model;
  SnapshotPtr m_snapshot;
  QTableView* m_table;
  LinkSpeedsModel* m_linkModel;
  QTableView* m_links;
  QToolButton* m_frame;
  QToolButton* m_unit;
  SpeedUnit m_unitShown;
  QToolButton* m_motors;
  LinkNames m_names;
  MechanismPtr m_newest;  ///< document that names are taken from
  bool m_absolute = false;
  std::optional<LinkId> m_observer;  ///< reference of absolute speeds; none: the ground
  bool m_isAwake = true;
  bool m_isBehind = false;      ///< the display is out of date
  std::vector<int> m_measured;  ///< widths of columns; 0: not yet
  std::vector<int> m_fitted;    ///< widths of columns; the last is that of the table
  CoalescedTask m_typeTurn{this, [this] { fitToType(); }};
  std::pair<QFont, int> m_type;  ///< of the table, and the height of rows, that they were measured in
  QToolButton* m_symbols;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_note;
  QLabel* m_ratio;
  QLabel* m_verdict;
  QTimer m_patience;  ///< times out when the exact solution takes long enough to be mentioned
};

}  // namespace geargraph
