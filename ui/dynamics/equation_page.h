#pragma once

#include <QWidget>

#include "ui/dynamics/dynamics_service.h"
#include "ui/forces/linked_table.h"

class QLabel;

namespace geargraph::inline ui_derivation {
class FormulaLabel;
}  // namespace geargraph::inline ui_derivation

namespace geargraph::inline ui_dynamics {

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

}  // namespace geargraph::inline ui_dynamics
