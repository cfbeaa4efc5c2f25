#pragma once

#include <QLabel>
#include <QStatusBar>
#include <optional>
#include <tuple>

#include "core/theory/analysis/analysis.h"
#include "ui/document/selection.h"
#include "ui/theme/application_theme.h"

class QToolButton;

namespace geargraph {

/// A line of text that ends in an ellipsis where its place is too narrow; it is whole in its tool tip then.
class StatusMessage : public QLabel {
 public:
  using QLabel::QLabel;
  /// The text as far as it is painted.
  [[nodiscard]] QString shown() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

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
  void updateMessage();
  void announce(bool isUrgent);
  void updateFreedomTip();
  [[nodiscard]] std::set<ElementId> counted(const QObject* chip) const;

  Selection* m_selection;
  SnapshotPtr m_snapshot;
  QLabel* m_icon;
  StatusMessage* m_message;
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

}  // namespace geargraph
