#pragma once

#include <QWidget>

class QComboBox;
class QStandardItemModel;
class QTableView;

namespace geargraph {
class StatesModel;
}  // namespace geargraph

namespace geargraph {

/// Two states of a gearbox side by side: what they engage, their ratios and efficiencies, the torque in each
/// coupling, and how fast the joints turn. What differs is bold.
class CompareStates : public QWidget {
  Q_OBJECT

 public:
  explicit CompareStates(StatesModel* states, QWidget* parent = nullptr);

  /// Compares these two states, by their rows.
  void compare(int one, int other);
  [[nodiscard]] QStandardItemModel& values() { return *m_values; }

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void renew();
  void fillChoices();
  void addRow(const QString& name, const QString& one, const QString& other, const QString& tip = {});
  void addColumn(int column, const QString& name);
  void addRates();
  void fit();

  StatesModel* m_states;
  QComboBox* m_one;
  QComboBox* m_other;
  QStandardItemModel* m_values;
  QTableView* m_table;
};

}  // namespace geargraph
