#pragma once

#include <QWidget>

#include "core/design/fixes/fixes.h"
#include "ui/document/selection.h"
#include "ui/models/diagnostic_model.h"
#include "ui/service/service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QFrame;
class QLabel;
class QListView;
class QStackedWidget;

namespace geargraph {

/// The diagnostics of the mechanism, or of a file that could not be opened. Hovering one highlights its
/// elements in all views, a click selects them, and buttons under it apply quick fixes. In large documents,
/// and far down the list, the buttons appear only when a diagnostic is clicked.
class ProblemsPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit ProblemsPanel(Selection* selection, QWidget* parent = nullptr);

  static constexpr int kMaxLinksWithImmediateFixes = 300;  ///< beyond, fixes are computed on a click
  static constexpr int kMaxImmediateFixes = 12;

  [[nodiscard]] QWidget& widget() override { return *this; }
  /// Sets the diagnostics of the newest analysis.
  void setSnapshot(const SnapshotPtr& snapshot) override;
  /// Sets the diagnostics of the motion check, listed after the others, and a sentence below them on what was
  /// not checked (motionNote()); empty: none.
  void setMotionDiagnostics(const Diagnostics& diagnostics, const QString& note);
  /// Sets the diagnostics of the document's loads, listed after those of the analysis.
  void setLoadDiagnostics(const Diagnostics& diagnostics);
  /// Sets those of the 3D files that links wear.
  void setShapeDiagnostics(const Diagnostics& diagnostics);
  /// Sets the diagnostics of a file that was not opened. They stay on top until dismissed or another file
  /// opens.
  void setFileProblems(const QString& fileName, const Diagnostics& problems);
  void clearFileProblems();

  [[nodiscard]] DiagnosticModel& model() { return *m_model; }
  [[nodiscard]] QListView& list() { return *m_list; }
  /// Are all fixes offered that were asked for?
  [[nodiscard]] bool isSettled() const override { return m_fixFinder->isUpToDate(); }

 signals:
  void fixesOffered();  ///< those that were found in the background
  void countChanged(int count);
  void fixWanted(const geargraph::Fix& fix);
  void momentWanted(double time);  ///< s of the motion: time of a clicked diagnostic

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct FixRequest {
    SnapshotPtr snapshot;
    Diagnostics diagnostics;
  };
  using FixFinder = Service<FixRequest, std::vector<std::vector<Fix>>>;

  void renew();
  void offerFixes();
  /// Adds the fixes of this row, or the row to those whose fixes requestFixes() asks for.
  void offerFixes(const QModelIndex& index);
  void requestFixes();
  void showFixes(int row, const std::vector<Fix>& fixes);
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
  Diagnostics m_motionDiagnostics;
  Diagnostics m_loadDiagnostics;
  Diagnostics m_shapeDiagnostics;
  SnapshotPtr m_snapshot;
  std::vector<int> m_rowsAsked;  ///< whose fixes are found in the background
  FixFinder* m_fixFinder;
};

[[nodiscard]] ViewEntry problemsView();

}  // namespace geargraph
