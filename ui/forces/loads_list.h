#pragma once

#include <QWidget>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"

class QComboBox;
class QLabel;
class QLayout;
class QMenu;
class QScrollArea;
class QToolButton;

namespace geargraph {
class NumberField;
}  // namespace geargraph

namespace geargraph {

/// The loads of the document side by side: element, value in the chosen unit, and a button for removal. The
/// controls that go with them stand in another layout: they fold the list away, add a load, and choose the
/// places of the torques that hold the loads. Every change is an undoable edit; spinning a field until it is
/// left is one step.
class LoadsList : public QWidget {
  Q_OBJECT

 public:
  /// `controls`: the layout that gets the controls; its widget is `parent`, too
  LoadsList(Document* document, Selection* selection, QLayout& controls, QWidget* parent);

  /// Shows or hides the list together with its controls.
  void setShown(bool isShown);
  /// A list of many loads scrolls in this height. Until the user has folded or unfolded the list it is folded
  /// where there is little room for what stands below it.
  void setRoom(int height, bool isLittle);

 public slots:
  /// Adds a load of 1 N m on the selected joint or link, else on an element from a menu.
  void addLoad();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    QWidget* box = nullptr;
    std::vector<NumberField*> fields;  ///< one of a torque, three of a force
  };

  void makeControls(QLayout& controls, QWidget* parent);
  void renew();
  void showFold();
  void setOpen(bool isOpen);
  void showPlaces();
  void fitHeight();
  void showRows();
  void showNumbers();
  Row makeRow(int load);
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
  /// "joint 6 (carrier)".
  [[nodiscard]] QString nameOf(const ElementId& element) const;
  /// The chosen unit in N m.
  [[nodiscard]] Rational newtonMetres() const;

  Document* m_document;
  Selection* m_selection;
  QScrollArea* m_view;
  QWidget* m_list;  ///< of rows
  QLabel* m_empty;
  QLabel* m_more;
  QToolButton* m_fold = nullptr;
  QComboBox* m_unit = nullptr;
  QToolButton* m_add = nullptr;
  QToolButton* m_balances = nullptr;
  std::vector<Row> m_rows;
  QStringList m_shown;  ///< the titles of the rows
  bool m_isShown = true;
  bool m_isOpen = true;
  bool m_isFoldChosen = false;  ///< by the user
  int m_room = 120;             ///< px
  quint64 m_gesture = 0;
};

}  // namespace geargraph
