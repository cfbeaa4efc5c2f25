#include "tests/ui/mainwindow/person.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>
#include <QTest>
#include <QWindow>
#include <algorithm>

#include "tests/support/menu_hand.h"
#include "ui/canvas/digraph_view.h"

namespace geargraph::test {
namespace {

/// The entry with this text that can be chosen; null where there is none.
QAction* entryOf(const QMenu& menu, const QString& text) {
  const QList<QAction*> all = menu.actions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const QAction* action) {
    const QString shown = action->text().section(QLatin1Char('\t'), 0, 0).remove(QLatin1Char('&'));
    return shown == text && action->isEnabled();
  });
  return found == all.end() ? nullptr : *found;
}

bool comesIntoView(const QWidget& widget) {
  return QTest::qWaitFor([&widget] { return widget.isVisible(); });
}

}  // namespace

QWidget* Person::sheet() {
  return m_window.digraph().viewport();
}

void Person::clickButton(QWidget* button) {
  ++gestures;
  QTest::mouseClick(button, Qt::LeftButton);
}

bool Person::typeInto(QWidget* field, const QString& text) {
  if (field == nullptr || !field->isVisible() || field->visibleRegion().isEmpty()) return false;
  QWidget* const line = field->findChild<QLineEdit*>();
  clickButton(line != nullptr ? line : field);
  ++gestures;
  for (const QChar letter : text) QTest::keyClick(m_window.windowHandle(), letter.toLatin1());
  QTest::keyClick(m_window.windowHandle(), Qt::Key_Return);
  return true;
}

void Person::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  ++gestures;
  QTest::keyClick(m_window.windowHandle(), key, modifiers);
}

void Person::click(double across, double down) {
  ++gestures;
  m_hand.click(across, down);
}

void Person::clickLink(int link, Qt::KeyboardModifiers modifiers) {
  ++gestures;
  QTest::mouseClick(sheet(), Qt::LeftButton, modifiers, m_hand.placeOf(link));
}

void Person::clickMesh(int mesh, Qt::KeyboardModifiers modifiers) {
  ++gestures;
  QTest::mouseClick(sheet(), Qt::LeftButton, modifiers, m_hand.placeOfMesh(mesh));
}

void Person::clickJoint(int joint) {
  ++gestures;
  QTest::mouseClick(sheet(), Qt::LeftButton, {}, placeOfJoint(joint));
}

void Person::drag(int from, int to) {
  ++gestures;
  m_hand.drag(from, to);
}

bool Person::clickCell(const QAbstractItemView& table, const QModelIndex& index) {
  if (!comesIntoView(table)) return false;
  const QPoint at = table.visualRect(index).center();
  if (!table.viewport()->rect().contains(at)) return false;
  ++gestures;
  QTest::mouseMove(table.viewport(), at);
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
  return true;
}

bool Person::raise(const QString& begin) {
  for (auto* tabs : m_window.findChildren<QTabBar*>()) {
    for (int i = 0; i < tabs->count(); ++i) {
      if (!tabs->isVisible() || !tabs->isTabVisible(i) || !tabs->tabText(i).startsWith(begin)) continue;
      ++gestures;
      QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
      return tabs->currentIndex() == i;
    }
  }
  return false;
}

/// Nearer the head than the middle, where the arrows of other joints may cross.
QPoint Person::placeOfJoint(int joint) {
  const JointId id = m_window.document().mechanism()->turningJoints.at(static_cast<std::size_t>(joint)).id;
  for (const Outline& outline : m_window.digraph().displayList().outlines) {
    const auto* curve = std::get_if<Curve>(&outline.shape);
    if (curve == nullptr || outline.element != ElementId(id)) continue;
    const CanvasPoint place = curve->at(0.6);
    return m_window.digraph().mapFromScene(QPointF(place.x, place.y));
  }
  return {};
}

bool Person::chooseAt(const QPoint& at, const QString& path) {
  ++gestures;
  QTest::mouseMove(sheet(), at);
  QContextMenuEvent wanted(QContextMenuEvent::Mouse, at, sheet()->mapToGlobal(at));
  QApplication::sendEvent(sheet(), &wanted);
  return chooseFromMenu(path);
}

bool Person::chooseForMesh(int mesh, const QString& path) {
  return chooseAt(m_hand.placeOfMesh(mesh), path);
}

bool Person::chooseForJoint(int joint, const QString& path) {
  return chooseAt(placeOfJoint(joint), path);
}

bool Person::chooseFromMenu(const QString& path) {
  const auto openMenu = [] { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); };
  if (!QTest::qWaitFor([&] { return openMenu() != nullptr; })) return false;
  QMenu* menu = openMenu();
  for (const QString& text : path.split(QLatin1Char('>'))) {
    QAction* entry = menu != nullptr && comesIntoView(*menu) ? entryOf(*menu, text) : nullptr;
    if (entry == nullptr) {
      while (QWidget* left = QApplication::activePopupWidget()) left->close();
      return false;
    }
    const QPoint at = moveToEntry(*menu, entry);
    QMenu* const next = entry->menu();
    if (next == nullptr) {
      ++gestures;
      QTest::mouseClick(menu, Qt::LeftButton, {}, at);
    }
    menu = next;
  }
  return true;
}

}  // namespace geargraph::test
