#pragma once

#include <QWidget>

#include "core/design/fixes/fixes.h"
#include "ui/models/diagnostic_model.h"
#include "ui/selection/selection.h"

class QFrame;
class QLabel;
class QListView;
class QStackedWidget;

namespace geargraph::inline panels {

/// What is wrong with the mechanism, or with a file that could not be opened: pointing at a finding lights up
/// its culprits everywhere, a click selects them, a button under it mends it. In large documents, and far
/// down the list, the buttons come when a finding is clicked.
class ProblemsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemsPanel(Selection* selection, QWidget* parent = nullptr);

  static constexpr int kMostLinksMendedAtOnce = 300;  ///< beyond, fixes are looked for on a click
  static constexpr int kMostMendedAtOnce = 12;

  /// The findings of the newest analysis.
  void setSnapshot(const SnapshotPtr& snapshot);
  /// What the check of the motion has found, after the other findings, and below them a sentence on what was
  /// not checked (motionNote()), or nothing.
  void setMotionFindings(const Diagnostics& findings, const QString& note);
  /// What is wrong with the loads of the document, after the findings of the analysis.
  void setLoadFindings(const Diagnostics& findings);
  /// The findings of a file that was not opened stay on top until it is dismissed or another file opens.
  void setFileProblems(const QString& fileName, const Diagnostics& problems);
  void clearFileProblems();

  [[nodiscard]] DiagnosticModel& model() { return *m_model; }
  [[nodiscard]] QListView& list() { return *m_list; }

 signals:
  void countChanged(int count);
  void fixWanted(const geargraph::Fix& fix);
  void momentWanted(double time);  ///< s of the motion: the time of a finding that was clicked

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void renew();
  void offerFixes();
  void offerFixes(const QModelIndex& index);
  QFrame* makeBanner();

  Selection* m_selection;
  DiagnosticModel* m_model;
  QListView* m_list;
  QStackedWidget* m_pages;
  QLabel* m_motionNote;
  QFrame* m_banner = nullptr;
  QLabel* m_bannerText = nullptr;
  QString m_fileName;
  Diagnostics m_fileProblems;
  Diagnostics m_motionFindings;
  Diagnostics m_loadFindings;
  SnapshotPtr m_snapshot;
};

}  // namespace geargraph::inline panels
