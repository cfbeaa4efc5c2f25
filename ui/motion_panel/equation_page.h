#pragma once

#include <QWidget>

#include "ui/forces/linked_table.h"
#include "ui/motion_panel/dynamics_service.h"

class QLabel;

namespace geargraph {
class FormulaLabel;
}  // namespace geargraph

namespace geargraph {

/// The equation of motion in the inputs: in symbols, with numerical matrices if they are small, and as a
/// table.
class EquationPage : public QWidget {
  Q_OBJECT

 public:
  explicit EquationPage(Selection* selection, QWidget* parent = nullptr);

  /// Shows the dynamics; null: nothing.
  void show(const DynamicsPtr& dynamics);
  [[nodiscard]] ValueTableModel& model() { return *m_model; }
  [[nodiscard]] const std::string& tex() const;

 private:
  ValueTableModel* m_model;
  LinkedTable* m_table;
  FormulaLabel* m_numbers;
};

}  // namespace geargraph
