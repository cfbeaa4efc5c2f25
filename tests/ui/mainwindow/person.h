#pragma once

#include "tests/ui/mainwindow/hand.h"

class QAbstractItemView;
class QMenu;
class QModelIndex;

namespace geargraph::test {

/// Somebody at the program with a mouse and a keyboard, whose gestures are counted: a click, a drag, a key
/// with its modifiers, and a typed entry with its Return are one each. Keys go to the window, which hands
/// them on to what has the focus, as those of a keyboard do.
class Person {
 public:
  explicit Person(MainWindow& window) : m_window(window), m_hand(window) {}

  void clickButton(QWidget* button);
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  /// Clicks at this part of the digraph's width and height.
  void click(double across, double down);
  void clickLink(int link, Qt::KeyboardModifiers modifiers = {});
  /// Meshes and joints by their position in their list.
  void clickMesh(int mesh, Qt::KeyboardModifiers modifiers = {});
  void clickJoint(int joint);
  void drag(int from, int to);
  /// In view, once it is there; false where it does not come into view.
  bool clickCell(const QAbstractItemView& table, const QModelIndex& index);
  /// Clicks the tab whose title begins so; false where there is none.
  bool raise(const QString& begin);

  /// Clicks a field and types this and Return: two gestures. False where the field is out of sight.
  [[nodiscard]] bool typeInto(QWidget* field, const QString& text);

  /// The right button on a mesh or on a joint's arrow, then an entry of the menu. `>` parts it from the
  /// submenu that it is in, which the mouse opens by moving over it. False where an entry is missing or grey.
  bool chooseForMesh(int mesh, const QString& path);
  bool chooseForJoint(int joint, const QString& path);
  /// An entry of the menu that is open.
  bool chooseFromMenu(const QString& path);

  int gestures = 0;

 private:
  bool chooseAt(const QPoint& at, const QString& path);
  [[nodiscard]] QPoint placeOfJoint(int joint);
  [[nodiscard]] QWidget* sheet();

  MainWindow& m_window;
  Hand m_hand;
};

}  // namespace geargraph::test
