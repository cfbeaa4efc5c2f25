#pragma once

#include <QWidget>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace geargraph {
class NumberField;
}  // namespace geargraph

namespace geargraph {

/// The loads of the document, one per row: element, value in the chosen unit, and a button for removal; and
/// the places of the torques that hold them. Every change is an undoable edit; spinning a field until it is
/// left is one step.
class LoadsList : public QWidget {
  Q_OBJECT

 public:
  LoadsList(Document* document, Selection* selection, QWidget* parent = nullptr);

 public slots:
  /// Adds a load of 1 N m on the selected joint or link, else on an element from a menu.
  void addLoad();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Row {
    std::vector<QWidget*> widgets;
    std::vector<NumberField*> fields;  ///< one of a torque, three of a force
  };

  QWidget* makeHead();
  void renew();
  void showRows();
  void showNumbers();
  Row makeRow(int load, int line);
  NumberField* makeField(int load, std::size_t component);
  void remove(int load);
  void setSize(int load, std::size_t component, const Number& size);
  void addOn(const ElementId& element);
  void fillPlaces(QMenu& menu);
  void fillBalances(QMenu& menu);
  void balance(std::optional<std::vector<HoldingTorque>> balances, const QString& text);
  [[nodiscard]] QString titleOf(const Load& load) const;
  [[nodiscard]] QString tipOf(const Load& load) const;
  [[nodiscard]] ElementId elementOf(const Load& load) const;
  [[nodiscard]] QString nameOf(const ElementId& element) const;
  /// The chosen unit in N m.
  [[nodiscard]] Rational newtonMetres() const;

  Document* m_document;
  Selection* m_selection;
  QWidget* m_list;  ///< of rows
  QGridLayout* m_grid;
  QLabel* m_empty;
  QLabel* m_more;
  QComboBox* m_unit = nullptr;
  QToolButton* m_add = nullptr;
  QToolButton* m_balances = nullptr;
  std::vector<Row> m_rows;
  QStringList m_shown;  ///< the titles of the rows
  quint64 m_gesture = 0;
};

}  // namespace geargraph
