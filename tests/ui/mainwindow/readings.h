#pragma once

#include <QToolButton>

#include "ui/mainwindow/main_window.h"
#include "ui/models/results_model.h"
#include "ui/panels/results_panel.h"

namespace geargraph::test {

/// What a person reads in the row of this link: its rate now.
inline QString rateOfLink(MainWindow& window, int label) {
  const ResultsModel& model = window.results().model();
  for (int i = 0; i < model.rowCount(); ++i) {
    if (model.index(i, 0).data(ResultsModel::LinkLabelRole).toInt() == label)
      return model.index(i, model.columnCount() - 1).data().toString();
  }
  return {};
}

/// The entries of a row of results but for the joint and its rate.
inline QStringList formulas(MainWindow& window, int row) {
  const ResultsModel& model = window.results().model();
  QStringList texts;
  for (int j = 1; j + 1 < model.columnCount(); ++j) texts << model.index(row, j).data().toString();
  return texts;
}

/// A chip of the status bar, as "chip.dof".
inline QString chip(const MainWindow& window, const char* name) {
  return window.findChild<QToolButton*>(QLatin1String(name))->text();
}

}  // namespace geargraph::test
