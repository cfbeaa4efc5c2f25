#pragma once

#include <QWidget>

#include "ui/models/results_model.h"
#include "ui/selection/selection.h"

class QFrame;
class QLabel;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace geargraph {

/// What the inputs make of all other joints: their rates for one unit of each input, their rates now, and
/// whether both methods say the same.
class ResultsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ResultsPanel(Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot);
  [[nodiscard]] ResultsModel& model() { return *m_model; }
  [[nodiscard]] QString verdict() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeTable();
  void hoverRow(const QModelIndex& index);
  void renew();
  void fitColumns();
  void paintVerdict();
  [[nodiscard]] QString whyNone() const;

  Selection* m_selection;
  ResultsModel* m_model;
  SnapshotPtr m_snapshot;
  QTableView* m_table;
  QToolButton* m_symbols;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_note;
  QLabel* m_verdict;
};

}  // namespace geargraph
