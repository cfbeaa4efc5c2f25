#pragma once

#include <QStatusBar>
#include <optional>
#include <tuple>

#include "core/theory/analysis/analysis.h"
#include "ui/selection/selection.h"
#include "ui/theme/application_theme.h"

class QLabel;
class QToolButton;

namespace geargraph::inline mainwindow {

/// The status bar: what the tool expects next, or why an edit was rejected; and n, t, c, rank, DOF as chips.
/// Hovering a chip highlights what it counts.
class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(Selection* selection, QWidget* parent = nullptr);

  void setHint(const QString& hint);
  /// Shows a message until the next edit, or until another hint is set.
  void showRejection(const QString& why);
  void clearRejection();
  void showNote(const QString& note);
  void setSnapshot(const SnapshotPtr& snapshot);
  /// Shows or hides the chips, whose counts a lesson may ask for.
  void showCounts(bool isShown);

  [[nodiscard]] QString text() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addChip(const char* name, const QString& tip, const char* look = "count");
  void renewMessage();
  void announce(bool isUrgent);
  void renewFreedomTip();
  [[nodiscard]] std::set<ElementId> counted(const QObject* chip) const;

  Selection* m_selection;
  SnapshotPtr m_snapshot;
  QLabel* m_icon;
  QLabel* m_message;
  QString m_hint;
  QString m_rejection;
  QString m_note;
  std::optional<std::tuple<QString, bool, Theme>> m_shown;  ///< message, is it a rejection, colours
  QToolButton* m_links;
  QToolButton* m_joints;
  QToolButton* m_meshes;
  QToolButton* m_rank;
  QToolButton* m_freedom;
};

}  // namespace geargraph::inline mainwindow
