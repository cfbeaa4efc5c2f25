#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/mini_map.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/sheet_offer.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/panels/insert_set_dialog.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// What an empty sheet offers, sets that are joined to a gearbox, names on the drawings, their map, and the
/// one transport of the window.
class WindowBeginningTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] const Mechanism& now() { return *window->document().mechanism(); }
  template <class Widget>
  Widget* part(const char* name) {
    return window->findChild<Widget*>(QLatin1String(name));
  }
  SheetOffer& offer() { return *window->findChild<SheetOffer*>(); }
  void openEmpty() {
    window = std::make_unique<MainWindow>();
    window->show();
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    window->digraph().setFocus();
  }
  void insert(const char* kind) {
    auto* dialog = window->findChild<InsertSetDialog*>();
    if (dialog == nullptr || !dialog->isVisible()) {
      window->actions()[CommandId::insertSet]->trigger();
      dialog = window->findChild<InsertSetDialog*>();
    }
    dialog->choose(QLatin1String(kind));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("insert")), Qt::LeftButton);
    QTRY_VERIFY(window->isSettled());
  }
  ElementId link(int label) { return now().links[static_cast<std::size_t>(label)].id; }
  int captionsIn(DrawingView& drawing) {
    int count = 0;
    for (const Mark& mark : drawing.displayList().marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (text != nullptr && mark.role == MarkRole::name && text->text.starts_with("z ")) ++count;
    }
    return count;
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void cleanup() {
    window.reset();
    test::clearSettings();
  }

  void anEmptySheetOffersToDraw() {
    openEmpty();
    QVERIFY(offer().isVisible());
    QTest::mouseClick(part<QToolButton>("offerDraw"), Qt::LeftButton);
    QCOMPARE(window->digraph().tool(), ToolKind::link);
    QVERIFY(!offer().isVisible());
    QTest::keyClick(&window->digraph(), Qt::Key_Escape);
    QVERIFY(offer().isVisible());  // still empty
    test::Hand hand(*window);
    hand.key(Qt::Key_L);
    hand.click(0.7, 0.3);
    QCOMPARE(now().n(), 1);
    hand.key(Qt::Key_V);
    QVERIFY(!offer().isVisible());
    window->actions()[CommandId::undo]->trigger();
    QVERIFY(offer().isVisible());
  }

  void anEmptySheetOffersSetsWithPictures() {
    openEmpty();
    for (auto* card : offer().findChildren<QToolButton*>()) {
      QVERIFY2(!card->icon().isNull(), qPrintable(card->objectName()));
      QVERIFY2(!card->toolTip().isEmpty(), qPrintable(card->objectName()));
    }
    QTest::mouseClick(part<QToolButton>("ravigneaux"), Qt::LeftButton);
    auto* dialog = window->findChild<InsertSetDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("insert")), Qt::LeftButton);
    QCOMPARE(now().name, std::string("Ravigneaux set"));
    QVERIFY(!offer().isVisible());
  }

  void insertingASetIsInTheToolBar() {
    openEmpty();
    auto* bar = part<QToolBar>("toolBar");
    QWidget* button = bar->widgetForAction(window->actions()[CommandId::insertSet]);
    QVERIFY(button != nullptr);
    for (const char* word : {"ratio", "teeth", "planetary"})
      QVERIFY(window->actions()[CommandId::insertSet]->property("searchWords").toString().contains(word));
  }

  void twoSetsAreWeldedAndSplit() {
    openEmpty();
    insert("planetary");
    insert("planetary");
    QCOMPARE(now().n(), 12);
    const auto freedom = [this] { return window->analysis().snapshot()->matroid()->dof; };
    QCOMPARE(freedom(), 2);
    QAction* weld = window->actions()[CommandId::weld];
    QAction* split = window->actions()[CommandId::split];
    // The wrong way first: one link, then two in mesh.
    window->selection().select({link(3)});
    QVERIFY(!weld->isEnabled());
    QVERIFY(weld->toolTip().contains("two links"));
    window->selection().select({link(1), link(4)});
    QVERIFY(!weld->isEnabled());
    QVERIFY(weld->toolTip().contains("mesh with each other"));
    window->selection().select({link(3), link(7)});
    QVERIFY(weld->isEnabled());
    const ElementId kept = link(3);
    QCOMPARE(weld->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
    weld->trigger();
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(now().n(), 11);
    QCOMPARE(freedom(), 1);
    QCOMPARE(window->selection().selected(), std::set<ElementId>{kept});
    QVERIFY(split->isEnabled());
    split->trigger();
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(now().n(), 12);
    QCOMPARE(freedom(), 2);
    QVERIFY(window->selection().isSelected(link(12)));
    window->actions()[CommandId::undo]->trigger();
    window->actions()[CommandId::undo]->trigger();
    QCOMPARE(now().n(), 12);
    QVERIFY(now().find(LinkId(kept.id)) != nullptr);
    QVERIFY(!now().inputs || now().inputs->size() == 2);
  }

  void namesAndTeethAreATickOfTheMenu() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    QCOMPARE(captionsIn(window->digraph()), 0);
    const auto plain = window->digraph().picture();
    window->actions()[CommandId::captions]->trigger();
    QTRY_COMPARE(captionsIn(window->digraph()), 4);
    QCOMPARE(window->digraph().picture().marks.size() > plain.marks.size(), true);
    // They follow edits.
    window->document().apply(
        {"Teeth", [](const Mechanism& before) { return withTeeth(before, before.gearMeshes[0].id, 19, 38); },
         0});
    QTRY_VERIFY([&] {
      for (const Mark& mark : window->digraph().displayList().marks) {
        const auto* text = std::get_if<Text>(&mark.what);
        if (text != nullptr && text->text == "z 19 : 38") return true;
      }
      return false;
    }());
    window->actions()[CommandId::captions]->trigger();
    QTRY_COMPARE(captionsIn(window->digraph()), 0);
  }

  void aPresentationHasNamesOn() {
    window = test::openedWindow(robotExamplePath());
    window->presentation().setOn(true);
    QVERIFY(window->actions()[CommandId::captions]->isChecked());
    window->presentation().setOn(false);
    QVERIFY(!window->actions()[CommandId::captions]->isChecked());
  }

  void theTransportIsThereOnce() {
    window = test::openedWindow(robotExamplePath());
    const auto playButtons = [this] {
      int count = 0;
      for (auto* button : window->findChildren<QToolButton*>()) {
        const QString name = button->objectName();
        const bool plays = name == QLatin1String("play") || name == QLatin1String("view3dPlay");
        count += plays && button->isVisible() ? 1 : 0;
      }
      return count;
    };
    QVERIFY(window->view3d().isVisible());
    QCOMPARE(playButtons(), 1);
    window->docks().of(window->view3d())->hide();
    QTRY_COMPARE(playButtons(), 1);
    QVERIFY(part<QToolBar>("toolBar")->findChild<QToolButton*>(QStringLiteral("play"))->isVisible());
  }

  void aDrawingThatDoesNotFitHasAMap() {
    window = test::openedWindow(robotExamplePath());
    auto* map = window->digraph().findChild<MiniMap*>();
    QVERIFY(map != nullptr);
    QVERIFY(!map->isVisible());
    for (int i = 0; i < 6; ++i) window->digraph().zoomIn();
    QTRY_VERIFY(map->isVisible());
    const QPointF before = window->digraph().mapToScene(window->digraph().viewport()->rect().center());
    QTest::mouseClick(map, Qt::LeftButton, {}, QPoint(12, 12));
    const QPointF after = window->digraph().mapToScene(window->digraph().viewport()->rect().center());
    QVERIFY(after.x() < before.x());
    window->digraph().fit();
    QTRY_VERIFY(!map->isVisible());
  }

  void examplesAreInTheMenuByTheirTitles() {
    openEmpty();
    auto* simpson = part<QAction>("example.simpson");
    QVERIFY(simpson != nullptr);
    QCOMPARE(simpson->text(), QString("Simpson train"));
    for (const QString& path : examplePaths()) {
      const Expected<Mechanism> read = readDocument(path);
      QCOMPARE(exampleTitle(path), QString::fromStdString(read->name));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowBeginningTest)
#include "test_window_beginning.moc"
