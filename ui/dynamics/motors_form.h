#pragma once

#include <QWidget>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/theory/dynamics/simulation.h"

class QGridLayout;

namespace geargraph::inline panels {
class NumberField;
}  // namespace geargraph::inline panels

namespace geargraph::inline ui_dynamics {

/// What a simulation begins with: per input the torque of its motor, how much it loses with the speed, angle
/// and speed at time 0; and how long the motion is followed. No part of the document.
class MotorsForm : public QWidget {
  Q_OBJECT

 public:
  explicit MotorsForm(QWidget* parent = nullptr);

  /// The inputs, by position, with the inertia at each: numbers of joints that stay are kept, the torque of a
  /// new one makes it gain some 10 rad/s in a second.
  void setInputs(const Mechanism& mechanism, const std::vector<int>& joints, const Eigen::VectorXd& inertias);
  /// For the inputs of setInputs(), in their order; without limits.
  [[nodiscard]] SimulationOptions options() const;

 private:
  struct Row {
    JointId joint;
    Number torque, damping, degrees, speed;
  };
  void showRows(const Mechanism& mechanism, const std::vector<int>& joints);
  void addField(const QString& name, const QString& meaning, int row, int column, Number Row::*number);
  NumberField* makeField(const QString& name, const QString& meaning);

  QGridLayout* m_grid;
  std::vector<Row> m_rows;
  std::vector<QWidget*> m_widgets;  ///< of the rows
  QStringList m_titles;
  Number m_seconds = Number(2);
};

}  // namespace geargraph::inline ui_dynamics
