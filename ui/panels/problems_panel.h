#pragma once

#include <QWidget>

#include "ui/models/diagnostic_model.h"
#include "ui/selection/selection.h"

class QFrame;
class QLabel;
class QListView;
class QStackedWidget;

namespace geargraph {

/// What is wrong with the mechanism, or with a file that could not be opened: pointing at a finding lights up
/// its culprits everywhere, a click selects them.
class ProblemsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemsPanel(Selection* selection, QWidget* parent = nullptr);

  /// The findings of the newest analysis.
  void setDiagnostics(const Diagnostics& diagnostics);
  /// The findings of a file that was not opened stay on top until it is dismissed or another file opens.
  void setFileProblems(const QString& fileName, const Diagnostics& problems);
  void clearFileProblems();

  [[nodiscard]] DiagnosticModel& model() { return *m_model; }
  [[nodiscard]] QListView& list() { return *m_list; }

 signals:
  void countChanged(int count);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void renew();
  QFrame* makeBanner();

  Selection* m_selection;
  DiagnosticModel* m_model;
  QListView* m_list;
  QStackedWidget* m_pages;
  QFrame* m_banner = nullptr;
  QLabel* m_bannerText = nullptr;
  QString m_fileName;
  Diagnostics m_fileProblems;
  Diagnostics m_diagnostics;
};

}  // namespace geargraph
