#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <set>

#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/status_line.h"
#include "ui/panels/results_panel.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// The window for hands without a mouse and eyes that do not see it: every control is reached by Tab, the
/// elements of drawings by keys, and all of them have names for screen readers.
class AccessibilityTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  /// Roles of what is operated, read or chosen; the others only hold these.
  static bool mustHaveName(QAccessible::Role role) {
    static const std::set<QAccessible::Role> kRoles{
        QAccessible::Button,         QAccessible::CheckBox,     QAccessible::RadioButton,
        QAccessible::ComboBox,       QAccessible::SpinBox,      QAccessible::Slider,
        QAccessible::EditableText,   QAccessible::PageTab,      QAccessible::MenuItem,
        QAccessible::ListItem,       QAccessible::TreeItem,     QAccessible::Cell,
        QAccessible::Graphic,        QAccessible::Canvas,       QAccessible::Table,
        QAccessible::List,           QAccessible::Tree,         QAccessible::ButtonMenu,
        QAccessible::ButtonDropDown, QAccessible::ColumnHeader, QAccessible::RowHeader};
    return kRoles.contains(role);
  }
  static QString placeOf(const QAccessibleInterface& of) {
    QStringList names;
    for (const QObject* each = of.object(); each != nullptr; each = each->parent()) {
      names.prepend(
          QStringLiteral("%1(%2)").arg(QLatin1String(each->metaObject()->className()), each->objectName()));
    }
    return names.mid(std::max<qsizetype>(0, names.size() - 3)).join(QLatin1Char('/'));
  }
  /// What is shown below, and has a role that must have a name, and has none; all that has one into `named`.
  static void collect(QAccessibleInterface* of, QStringList& nameless, std::set<QString>& named,
                      int depth = 0) {
    if (of == nullptr || !of->isValid() || depth > 40) return;
    const QAccessible::State state = of->state();
    if (state.invisible) return;
    const QString name = of->text(QAccessible::Name).trimmed();
    if (!name.isEmpty()) named.insert(name);
    if (mustHaveName(of->role()) && name.isEmpty())
      nameless << QStringLiteral("%1 %2").arg(of->role()).arg(placeOf(*of));
    const bool isValued = of->role() == QAccessible::Slider || of->role() == QAccessible::SpinBox;
    if (isValued && of->valueInterface() == nullptr) nameless << QStringLiteral("no value: ") + placeOf(*of);
    for (int i = 0; i < of->childCount(); ++i) collect(of->child(i), nameless, named, depth + 1);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&window->drawing(), key, modifiers);
  }
  [[nodiscard]] const std::set<ElementId>& selected() { return window->selection().selected(); }

  /// A field of the panel that takes keys.
  static QWidget* fieldIn(const QDockWidget& dock) {
    for (QWidget* each : dock.widget()->findChildren<QWidget*>())
      if ((each->focusPolicy() & Qt::TabFocus) != 0 && each->isEnabled() && isInSight(*each)) return each;
    return nullptr;
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() { window.reset(); }

  /// Keys would change what is not seen.
  void theKeyboardLeavesPanelsThatAreCovered() {
    window->selection().select({window->document().mechanism()->gearMeshes[0].id});
    int covered = 0;
    for (auto* dock : window->findChildren<QDockWidget*>()) {
      const QList<QDockWidget*> others = window->tabifiedDockWidgets(dock);
      if (others.isEmpty()) continue;
      dock->show();
      dock->raise();
      QTRY_VERIFY(isInSight(*dock->widget()));
      QTRY_VERIFY(window->isSettled());
      QWidget* field = fieldIn(*dock);
      if (field == nullptr) continue;
      field->setFocus();
      QTRY_COMPARE(QApplication::focusWidget(), field);
      others.front()->raise();
      QTRY_VERIFY(!isInSight(*dock->widget()));
      const QWidget* focus = QApplication::focusWidget();
      QVERIFY2(focus != nullptr && !dock->isAncestorOf(focus) && isInSight(*focus),
               qPrintable(dock->objectName()));
      ++covered;
    }
    QVERIFY(covered > 3);
  }

  void tabPassesOverPanelsThatAreCovered() {
    window->selection().select({window->document().mechanism()->gearMeshes[0].id});
    QTRY_VERIFY(window->isSettled());
    std::set<const QWidget*> reached;
    for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
      for (int i = 0; i < 300; ++i) {
        QTest::keyClick(QApplication::focusWidget(), key,
                        key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
        const QWidget* focus = QApplication::focusWidget();
        QVERIFY(focus != nullptr);
        reached.insert(focus);
        for (const auto* dock : window->findChildren<QDockWidget*>())
          QVERIFY2(!dock->isAncestorOf(focus) || isInSight(*dock), qPrintable(dock->objectName()));
      }
    }
    QVERIFY(reached.size() > 20);
  }

  void everythingHasAName_data() {
    QTest::addColumn<QString>("example");
    for (const char* example : {"robot", "eight-speed-gearbox", "robot-to-mend", "ravigneaux"}) {
      QTest::newRow(example) << QStringLiteral(":/examples/%1.geargraph").arg(QLatin1String(example));
    }
  }
  void everythingHasAName() {
    QFETCH(QString, example);
    QVERIFY(window->openDocument(example));
    QTRY_VERIFY(window->isSettled());
    QStringList nameless;
    std::set<QString> named;
    auto* properties = window->findChild<QDockWidget*>(QStringLiteral("dock.properties"));
    properties->raise();
    QTRY_VERIFY(properties->widget()->isVisible());
    collect(QAccessible::queryAccessibleInterface(properties), nameless, named);  // nothing is selected
    QVERIFY(named.contains(QStringLiteral("Name")));
    window->selection().select({window->document().mechanism()->links[1].id});
    for (auto* dock : window->findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QTest::qWait(0);
      collect(QAccessible::queryAccessibleInterface(window.get()), nameless, named);
    }
    for (const char* drawing : {"atlas", "ttgraph", "schematic", "digraph"}) {
      window->showDrawing(QLatin1String(drawing));
      QTRY_VERIFY(window->isSettled());
      collect(QAccessible::queryAccessibleInterface(window.get()), nameless, named);
    }
    nameless.removeDuplicates();
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
    for (const ElementId& element : window->digraph().drawnElements())
      QVERIFY2(named.contains(window->digraph().describe(element)), element.id.text().c_str());
    const bool hasPicture = !window->view3d().shownLinks().empty();
    QCOMPARE(named.contains(QStringLiteral("link 1")), hasPicture);
  }

  void elementsAreChildrenOfTheirDrawing() {
    QAccessibleInterface* drawing = QAccessible::queryAccessibleInterface(&window->digraph());
    QCOMPARE(drawing->role(), QAccessible::Canvas);
    const auto elements = window->digraph().drawnElements();
    QCOMPARE(drawing->childCount(), static_cast<int>(elements.size()));
    QCOMPARE(elements.size(), std::size_t{8 + 7 + 4});
    QAccessibleInterface* mesh = drawing->child(15);
    QVERIFY(mesh->text(QAccessible::Name).startsWith(QLatin1String("Gear mesh 15")));
    QVERIFY(!mesh->state().selected);
    mesh->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
    QCOMPARE(selected(), std::set<ElementId>{elements[15]});
    QVERIFY(mesh->state().selected && mesh->state().focused);
    QCOMPARE(drawing->focusChild(), mesh);
    QCOMPARE(drawing->indexOfChild(mesh), 15);
    QVERIFY(window->digraph().viewport()->rect().contains(
        window->digraph().viewport()->mapFromGlobal(mesh->rect().center())));
    window->selection().select({elements[15]});
    press(Qt::Key_Delete);
    QVERIFY(!mesh->isValid() || !mesh->state().selected);
  }

  void keysWalkAlongTheElements() {
    const auto all = window->digraph().drawnElements();
    press(Qt::Key_PageDown);
    QCOMPARE(selected(), std::set<ElementId>{all.front()});
    press(Qt::Key_PageDown);
    press(Qt::Key_PageDown, Qt::ShiftModifier);
    QCOMPARE(selected(), (std::set<ElementId>{all[1], all[2]}));
    press(Qt::Key_PageUp);
    QCOMPARE(selected(), std::set<ElementId>{all[1]});
    press(Qt::Key_PageUp);
    press(Qt::Key_PageUp);
    QCOMPARE(selected(), std::set<ElementId>{all.back()});
    window->digraph().walkTo(all.front());
    for (const Qt::Key way : {Qt::Key_Right, Qt::Key_Left, Qt::Key_Up, Qt::Key_Down}) {
      window->digraph().walkTo(all.front());
      const QPoint from = window->digraph().boxOf(all.front()).center();
      press(way, Qt::ControlModifier);
      const QPoint step = window->digraph().boxOf(*selected().begin()).center() - from;
      if (selected().contains(all.front())) continue;  // nothing is there
      const bool isAcross = way == Qt::Key_Right || way == Qt::Key_Left;
      QVERIFY(isAcross ? (step.x() > 0) == (way == Qt::Key_Right) : (step.y() > 0) == (way == Qt::Key_Down));
    }
  }

  /// A train of two gears, without a mouse.
  void aTrainIsDrawnByKeys() {
    window->document().replace(emptyMechanism(), {});
    QTRY_VERIFY(window->isSettled());
    const auto mechanism = [this]() -> const Mechanism& { return *window->document().mechanism(); };
    const auto join = [&](int tail, int head) {
      for (const int end : {tail, head}) {
        window->drawing().walkTo(mechanism().links[static_cast<std::size_t>(end)].id);
        press(Qt::Key_Return);
      }
    };
    window->drawing().setFocus();
    press(Qt::Key_L);
    press(Qt::Key_Return);
    press(Qt::Key_Return);
    QCOMPARE(mechanism().n(), 2);
    press(Qt::Key_T);
    join(0, 1);
    join(0, 2);
    QCOMPARE(mechanism().t(), 2);
    press(Qt::Key_G);
    join(1, 2);
    QCOMPARE(mechanism().c(), 1);
    press(Qt::Key_I);
    window->drawing().walkTo(mechanism().links[1].id);
    press(Qt::Key_Return);
    QVERIFY(mechanism().inputs && mechanism().inputs->size() == 1);
  }

  void theMenuKeyOpensTheMenuOfTheElement() {
    window->digraph().walkTo(LinkId("3"));
    QContextMenuEvent event(QContextMenuEvent::Keyboard, {5, 5},
                            window->digraph().viewport()->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(window->digraph().viewport(), &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu != nullptr);
    QCOMPARE(menu->title(), QStringLiteral("link 3"));
    menu->close();
  }

  void tabLeavesTheDrawings() {
    for (const char* drawing : {"digraph", "ttgraph", "schematic"}) {
      window->showDrawing(QLatin1String(drawing));
      window->drawing().setFocus();
      press(Qt::Key_Tab);
      QVERIFY2(QApplication::focusWidget() != &window->drawing(), drawing);
    }
  }

  /// From each control the next, back to the first: none of those that are seen is left out.
  void tabReachesEveryControl() {
    std::set<QWidget*> reached;
    window->digraph().setFocus();
    for (int i = 0; i < 500; ++i) {
      QWidget* now = QApplication::focusWidget();
      QVERIFY(now != nullptr);
      if (!reached.insert(now).second && now == &window->digraph()) break;
      QTest::keyClick(now, Qt::Key_Tab);
      if (QApplication::focusWidget() == now) QVERIFY2(false, qPrintable(now->objectName()));
    }
    QStringList missed;
    for (auto* control : window->findChildren<QWidget*>()) {
      const bool isOperated = qobject_cast<QAbstractButton*>(control) != nullptr ||
                              qobject_cast<QComboBox*>(control) != nullptr ||
                              (qobject_cast<QAbstractSlider*>(control) != nullptr &&
                               qobject_cast<QScrollBar*>(control) == nullptr);
      const bool isQts = control->objectName().startsWith(QLatin1String("qt_")) ||
                         qobject_cast<QTabBar*>(control->parentWidget()) != nullptr;
      // In an exclusive group Tab reaches one button, and arrow keys the others.
      const auto* button = qobject_cast<QAbstractButton*>(control);
      const QButtonGroup* group = button != nullptr ? button->group() : nullptr;
      const auto hasTab = [](const QAbstractButton* each) {
        return (each->focusPolicy() & Qt::TabFocus) != 0;
      };
      const QList<QAbstractButton*> others = group != nullptr ? group->buttons() : QList<QAbstractButton*>();
      const bool isOneOf =
          group != nullptr && group->exclusive() && std::any_of(others.begin(), others.end(), hasTab);
      if (!isOperated || isQts || isOneOf || !control->isEnabled() || control->visibleRegion().isEmpty())
        continue;
      if (control->focusPolicy() == Qt::NoFocus || (control->focusPolicy() & Qt::TabFocus) == 0)
        missed << control->objectName() + QLatin1Char(' ') +
                      QLatin1String(control->metaObject()->className());
    }
    QVERIFY2(missed.isEmpty(), qPrintable(missed.join(QLatin1Char('\n'))));
  }

  void theFocusIsSeen() {
    window->results().setFocus();
    const QImage before = window->digraph().grab().toImage();
    window->digraph().setFocus(Qt::TabFocusReason);
    QVERIFY(window->digraph().grab().toImage().pixel(1, 100) != before.pixel(1, 100));
    window->digraph().clearFocus();
    QCOMPARE(window->digraph().grab().toImage().pixel(1, 100), before.pixel(1, 100));
  }

  void escapeLeavesAPresentationAndSpacePlaysIt() {
    window->presentation().setOn(true);
    QTRY_VERIFY(window->presentation().isOn());
    auto* matrices = window->findChild<QDockWidget*>(QStringLiteral("dock.matrices"));
    auto* button = matrices->findChild<QToolButton*>(QStringLiteral("exportCsv"));
    button->setFocus();
    QSignalSpy pressed(button, &QToolButton::clicked);
    QTest::keyClick(button, Qt::Key_Space);
    QVERIFY(window->view3d().playback().isPlaying());
    QVERIFY(pressed.empty());
    window->view3d().setFocus();
    QTest::keyClick(&window->digraph(), Qt::Key_Space);
    window->digraph().setFocus();
    press(Qt::Key_T);
    test::Hand hand(*window);
    hand.press(1);
    press(Qt::Key_Escape);  // gives up the arrow
    QVERIFY(window->presentation().isOn());
    hand.release(1);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Escape);
    QVERIFY(!window->presentation().isOn());
    QTest::keyClick(button, Qt::Key_Escape);  // nothing more happens
    QVERIFY(window->isVisible());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::AccessibilityTest)
#include "test_accessibility.moc"
