#pragma once

#include <QMenu>
#include <QTest>

namespace geargraph::test {

/// Moves the mouse to an entry of an open menu as a hand does, and returns where that is: a menu that opens
/// under the mouse takes no click before that has moved (Qt 6.8: more than six times, or far).
inline QPoint moveToEntry(QMenu& menu, QAction* entry) {
  const QPoint at = menu.actionGeometry(entry).center();
  for (int step = 8; step >= 0; --step) QTest::mouseMove(&menu, at - QPoint(step, 0));
  return at;
}

inline void clickEntry(QMenu& menu, QAction* entry) {
  QTest::mouseClick(&menu, Qt::LeftButton, {}, moveToEntry(menu, entry));
}

}  // namespace geargraph::test
