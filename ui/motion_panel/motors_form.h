#pragma once

#include <QWidget>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/model/quantity.h"
#include "core/theory/dynamics/simulation.h"

class QGridLayout;

namespace geargraph {
class NumberField;
}  // namespace geargraph

namespace geargraph {

/// The parameters of a simulation: per input motor torque, damping, angle and speed at time 0; and the
/// duration. Not part of the document.
class MotorsForm : public QWidget {
  Q_OBJECT

 public:
  explicit MotorsForm(QWidget* parent = nullptr);

  /// Sets the inputs, by position, with their reflected inertias: values of joints that remain are kept; the
  /// default torque of a new one accelerates it at about 10 rad/s².
  void setInputs(const Mechanism& mechanism, const std::vector<int>& joints, const Eigen::VectorXd& inertias);
  /// For the inputs of setInputs(), in their order; without limits.
  [[nodiscard]] SimulationOptions options() const;

 private:
  struct Row {
    JointId joint;
    Number torque, damping, degrees, speed;
  };
  void showRows(const Mechanism& mechanism, const std::vector<int>& joints);
  void addField(const QString& name, const QString& meaning, int row, int column, Number Row::*number,
                Quantity quantity);
  NumberField* makeField(const QString& name, const QString& meaning);

  QGridLayout* m_grid;
  std::vector<Row> m_rows;
  std::vector<QWidget*> m_widgets;  ///< of the rows
  QStringList m_titles;
  Number m_seconds = Number(2);
};

}  // namespace geargraph
