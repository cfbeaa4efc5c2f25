#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPointer>
#include <QPrinter>
#include <QScreen>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTextDocument>
#include <cmath>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/notes.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/note_editor.h"
#include "ui/canvas/rename_editor.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/screen_fit.h"
#include "ui/mainwindow/shortcut_sheet.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/panels/number_field.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

struct ReleaseCount : QObject {
  int count = 0;
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseButtonRelease) ++count;
    return QObject::eventFilter(watched, event);
  }
};

/// Menus on objects, themes, the presentation, and the picture that stays while a link hangs loose.
class WindowHabitsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] const MechanismPtr& now() { return window->document().mechanism(); }
  template <class Widget>
  Widget* part(const char* name) {
    return window->findChild<Widget*>(QLatin1String(name));
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&window->digraph(), key, modifiers);
  }
  template <class Reduce>
  void change(Reduce reduce) {
    window->document().apply({QStringLiteral("Change"), reduce, 0});
    QTRY_VERIFY(window->isSettled());
  }
  static QAction* entry(QMenu* menu, const QString& start) {
    for (QAction* action : menu->actions()) {
      if (action->text().startsWith(start)) return action;
    }
    return nullptr;
  }
  std::unique_ptr<QMenu> menuOf(int link) {
    return std::unique_ptr<QMenu>(window->digraph().contextMenuAt(test::Hand(*window).placeOf(link)));
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() { window.reset(); }

  // Labels follow the order of the elements; what has another one now is marked until the mouse moves on.
  void deletingALinkSaysWhichNumbersMoved() {
    const auto message = [this] { return part<QLabel>("statusMessage")->text(); };
    window->selection().select({LinkId("3")});
    window->actions()[CommandId::remove]->trigger();
    QTRY_VERIFY(window->isSettled());
    QVERIFY2(message().startsWith(
                 QStringLiteral("New numbers: 4 is now 3, 5 is now 4, 6 is now 5, 7 is now 6, and ")),
             qPrintable(message()));
    QVERIFY(window->selection().hovered().contains(LinkId("7")));
    QVERIFY(!window->selection().hovered().contains(LinkId("2")));
    window->document().undoStack().undo();
    QTRY_VERIFY(window->isSettled());
    QVERIFY2(!message().startsWith(QStringLiteral("New numbers")), qPrintable(message()));
    window->selection().unhover();
    change([](const Mechanism& m) { return withLink(m, CanvasPoint{600, 40}); });
    QVERIFY2(!message().startsWith(QStringLiteral("New numbers")), qPrintable(message()));
  }

  /// Docks that float as a group hear that they are hidden while there still is what they read.
  void docksThatFloatTogetherEndBeforeTheWorkbench() {
    auto* group = new QWidget(window.get(), Qt::Tool);  // as QMainWindow makes one
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("dock.gearbox"));
    QVERIFY(dock != nullptr);
    dock->setParent(group);
    group->resize(300, 200);
    group->show();
    dock->show();
    QVERIFY(dock->isVisible());
    const QPointer<Workbench> workbench(&window->workbench());
    int hidden = 0;
    bool wasThere = true;
    connect(dock, &QDockWidget::visibilityChanged, qApp, [&](bool visible) {
      if (visible) return;
      ++hidden;
      wasThere = wasThere && workbench != nullptr;
    });
    window.reset();
    QVERIFY(hidden > 0);
    QVERIFY(wasThere);
  }

  void keysDoNothingWhileADockIsDragged() {
    auto* dock = part<QDockWidget>("dock.view3d");
    const QPoint title(60, 12);
    QTest::mouseMove(dock, title);
    QTest::mousePress(dock, Qt::LeftButton, {}, title);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(dock, title - QPoint(40, 30) * i);
    QCOMPARE(QWidget::mouseGrabber(), dock);
    press(Qt::Key_F11);
    QVERIFY(window->menuBar()->isVisible());
    QTest::mouseRelease(dock, Qt::LeftButton, {}, title);
    QVERIFY(QWidget::mouseGrabber() == nullptr);
    press(Qt::Key_F11);
    QVERIFY(!window->menuBar()->isVisible());
    press(Qt::Key_F11);
    window.reset();  // with its docks
  }

  /// Qt would delete what makes room for the dock twice.
  void aWindowMayGoWhileADockIsDragged() {
    for (const char* over : {"dock.properties", "dock.problems", "dock.view3d"}) {
      auto* dock = part<QDockWidget>("dock.view3d");
      const QPoint title(60, 12);
      QTest::mouseMove(dock, title);
      QTest::mousePress(dock, Qt::LeftButton, {}, title);
      const QWidget* target = part<QDockWidget>(over);
      const QPoint from = dock->mapToGlobal(title), to = target->mapToGlobal(target->rect().center());
      for (int i = 1; i <= 8; ++i) {
        QTest::mouseMove(dock, dock->mapFromGlobal(from + (to - from) * i / 8));
        QTest::qWait(20);  // the docks below make room step by step
      }
      QVERIFY2(QWidget::mouseGrabber() == dock, over);
      ReleaseCount releases;
      dock->installEventFilter(&releases);
      window.reset();
      QCOMPARE(releases.count, 1);
      init();
    }
  }

  // The least that a lecture hall has. Where the docks need more, the window grows past the screen.
  void theWindowFitsAProjector() {
    for (const char* example : {"robot", "eight-speed-gearbox"}) {
      MainWindow other;
      other.resize(1280, 720);
      other.show();
      QVERIFY(other.openDocument(QStringLiteral(":/examples/%1.geargraph").arg(QLatin1String(example))));
      QTRY_VERIFY(other.isSettled());
      QCOMPARE(other.size(), QSize(1280, 720));
    }
  }

  void windowsAreNoLargerThanTheScreen() {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    QVERIFY(screen.width() < 1366);  // else nothing is tried here
    const QByteArray larger = window->saveGeometry();
    const ScreenFit fit;
    MainWindow other;
    other.restoreLayout(larger, {});
    other.resize(2 * screen.size());
    other.show();
    QTRY_VERIFY2(screen.contains(other.frameGeometry()),
                 qPrintable(QStringLiteral("%1 x %2").arg(other.width()).arg(other.height())));
    QVERIFY(other.openDocument(QStringLiteral(":/examples/eight-speed-gearbox.geargraph")));
    QTRY_VERIFY(other.isSettled());
    QTRY_VERIFY(screen.contains(other.frameGeometry()));
    // Panels that need more room do not push it past the screen later either.
    for (auto* dock : other.findChildren<QDockWidget*>()) dock->show();
    QTRY_VERIFY(screen.contains(other.frameGeometry()));

    QDialog dialog;
    dialog.setMinimumWidth(screen.width() + 300);
    dialog.resize(screen.width() + 400, screen.height() + 100);
    dialog.show();
    QTRY_VERIFY(screen.contains(dialog.frameGeometry()));
    // A window that fits stays as it is.
    QDialog small;
    small.setGeometry(screen.left() + 50, screen.top() + 60, 300, 200);
    small.show();
    QVERIFY(QTest::qWaitForWindowExposed(&small));
    QCoreApplication::processEvents();
    QCOMPARE(small.geometry(), QRect(screen.left() + 50, screen.top() + 60, 300, 200));
  }

  void aPlaceOffTheScreenIsMovedOntoIt() {
    const QRect room(0, 0, 960, 540);
    QCOMPARE(fittedInto(room, QRect(0, 0, 1366, 768)), room);
    QCOMPARE(fittedInto(room, QRect(900, -20, 400, 300)), QRect(560, 0, 400, 300));
    QCOMPARE(fittedInto(room, QRect(100, 50, 400, 300)), QRect(100, 50, 400, 300));
  }

  void aGearIsAttachedFromTheMenu() {
    const std::unique_ptr<QMenu> menu = menuOf(6);
    QAction* attach = entry(menu.get(), "Attach a gear");
    QVERIFY(attach != nullptr && attach->isEnabled());
    attach->trigger();
    QCOMPARE(now()->n(), 8);
    QCOMPARE(now()->turningJoints.back().tail, LinkId("1"));  // link 6 turns on carrier 1
    QCOMPARE(now()->turningJoints.back().head, now()->links.back().id);
    QCOMPARE(now()->gearMeshes.back().tail, LinkId("6"));
    QCOMPARE(now()->gearMeshes.back().head, now()->links.back().id);
    QCOMPARE(window->selection().selected(), std::set<ElementId>{now()->links.back().id});
    QVERIFY(now()->view.nodes.contains(now()->links.back().id));
    QTRY_VERIFY(window->isSettled());
    QVERIFY(!hasErrors(window->analysis().snapshot()->diagnostics));
    press(Qt::Key_G, Qt::ControlModifier);  // and one on that
    QCOMPARE(now()->n(), 9);
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now()->n(), 7);
  }

  void whatTheGroundCannotDoIsSaid() {
    const std::unique_ptr<QMenu> menu = menuOf(0);
    for (const char* what : {"Attach a gear", "Drive it", "Make it the ground", "Delete"}) {
      QAction* action = entry(menu.get(), what);
      QVERIFY2(action != nullptr && !action->isEnabled(), what);
      QVERIFY2(action->text().contains('('), what);  // the reason
    }
    window->selection().select({LinkId("0")});
    QVERIFY(!window->actions()[CommandId::attachGear]->isEnabled());
    QCOMPARE(window->actions()[CommandId::attachGear]->toolTip(),
             QString("No gear can be attached: the ground does not move."));
  }

  void theGroundStaysWhenEverythingIsDeleted() {
    press(Qt::Key_A, Qt::ControlModifier);
    press(Qt::Key_Backspace);
    QCOMPARE(now()->n(), 0);
    QCOMPARE(now()->t(), 0);
    press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now()->n(), 7);
  }

  void labelsOfTheMatricesHaveTheSameMenu() {
    MatrixView& view = window->matrices().view();
    QHeaderView* header = view.horizontalHeader();
    const QPoint at(header->sectionViewportPosition(2) + 8, header->height() / 2);
    emit header->customContextMenuRequested(at);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu != nullptr);
    QCOMPARE(window->selection().selected(), std::set<ElementId>{JointId("10")});
    entry(menu, "Flip")->trigger();
    menu->close();
    QCOMPARE(now()->find(JointId("10"))->tail, LinkId("1"));
  }

  void themesAreChosenAndRemembered() {
    window->actions()[CommandId::highContrast]->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::highContrast);
    QCOMPARE(window->digraph().theme(), Theme::highContrast);
    QCOMPARE(savedTheme(), Theme::highContrast);
    QCOMPARE(QApplication::palette().color(QPalette::Base), QColor(Qt::black));
    window->actions()[CommandId::dark]->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::dark);
    window->actions()[CommandId::light]->trigger();
    QCOMPARE(savedTheme(), Theme::light);
    QVERIFY(window->actions()[CommandId::light]->isChecked());
  }

  void thePresentationIsLargeAndBareAndGoesAway() {
    const QStringList before = test::shownDocks(*window);
    press(Qt::Key_F11);
    QVERIFY(window->presentation().isOn());
    QVERIFY(window->isFullScreen());
    QCOMPARE(QApplication::font().pixelSize(), 20);
    QVERIFY(!window->menuBar()->isVisible() && !window->statusBar()->isVisible());
    QVERIFY(part<QLabel>("presentationHint")->text().contains("F11"));
    QCOMPARE(test::shownDocks(*window), QStringList{"dock.matrices"});
    press(Qt::Key_3, Qt::AltModifier);  // the 3D view too
    QCOMPARE(test::shownDocks(*window), (QStringList{"dock.matrices", "dock.view3d"}));
    press(Qt::Key_F11);
    QVERIFY(!window->isFullScreen());
    QCOMPARE(QApplication::font().pixelSize(), 13);
    QVERIFY(window->menuBar()->isVisible() && window->statusBar()->isVisible());
    QCOMPARE(test::shownDocks(*window), before);
    press(Qt::Key_F11);  // as it was chosen
    QCOMPARE(test::shownDocks(*window), (QStringList{"dock.matrices", "dock.view3d"}));
    window->document().undoStack().setClean();
    QVERIFY(window->close());
    QVERIFY(!window->presentation().isOn());  // the layout for work is what is kept
  }

  void thePictureStaysWhileALinkHangsLoose() {
    const MechanismScenePtr before = window->view3d().stage();
    QVERIFY(!before->scene.instances.empty());
    change([](const Mechanism& m) { return withLink(m, CanvasPoint{600, 40}); });
    QCOMPARE(window->view3d().stage().get(), before.get());
    auto* note = part<QLabel>("view3dNote");
    QVERIFY(note->isVisible());
    QVERIFY2(note->text().contains("Link 8 is not tied"), qPrintable(note->text()));
    change([](const Mechanism& m) { return withTurningJoint(m, m.links.front().id, m.links.back().id); });
    QVERIFY(!note->isVisible());
    QVERIFY(window->view3d().stage().get() != before.get());
  }

  void whatIsGoneCannotBeSelectedInTheLastPicture() {
    const ElementId gone[] = {LinkId("2")};
    change([&](const Mechanism& m) { return withoutElements(m, gone); });
    QVERIFY(part<QLabel>("view3dNote")->isVisible());
    window->selection().select({gone[0]});  // as a click on its wheel does
    QVERIFY(window->selection().selected().empty());
    window->selection().hover(gone[0]);
    const MechanismPtr before = now();
    press(Qt::Key_Delete);
    QCOMPARE(now().get(), before.get());
  }

  void anotherDocumentDoesNotKeepThePicture() {
    window->document().replace(*withLink(emptyMechanism(), CanvasPoint{0, 0}), {});
    QTRY_VERIFY(window->isSettled());
    QVERIFY(window->view3d().stage()->scene.instances.empty());
    QVERIFY(!part<QLabel>("view3dNote")->isVisible());
  }

  /// A field with a number that is not finished goes with the document that it is about.
  void whatIsTypedStaysOutOfAnotherDocument() {
    const Mechanism robot = *now();
    const Mechanism other = readDocument(QStringLiteral(":/examples/eight-speed-gearbox.geargraph")).value();
    QStringList fields;
    for (const NumberField* field : window->findChildren<NumberField*>()) {
      if (!field->objectName().isEmpty() && field->isEnabled()) fields << field->objectName();
    }
    QVERIFY(fields.size() >= 3);  // the speeds of the inputs
    int typed = 0;
    for (const QString& name : fields) {
      for (QObject* each = window->findChild<NumberField*>(name); each != nullptr; each = each->parent()) {
        if (auto* dock = qobject_cast<QDockWidget*>(each)) dock->raise();
      }
      QTRY_VERIFY(window->isSettled());
      auto* field = window->findChild<NumberField*>(name);  // rows are made anew
      if (field == nullptr || !field->isVisible()) continue;
      field->setFocus();
      QTest::keyClick(field, Qt::Key_7);
      window->document().replace(other, {});
      QCoreApplication::processEvents();
      QVERIFY2(*now() == other && window->document().undoStack().count() == 0, qPrintable(name));
      window->document().replace(robot, {});
      ++typed;
    }
    QVERIFY2(typed >= 3, qPrintable(QString::number(typed)));
  }

  void longNamesAndTorquesAreTypedInTheDrawingWhole() {
    const auto typeAtTheEnd = [&](const char* text) {
      QWidget* editor = window->focusWidget();
      QVERIFY(qobject_cast<RenameEditor*>(editor) != nullptr);
      QTest::keyClick(editor, Qt::Key_End);
      QTest::keyClicks(editor, QLatin1String(text));
      QTest::keyClick(editor, Qt::Key_Return);
      QTRY_VERIFY(window->isSettled());
    };
    change([](const Mechanism& before) { return withName(before, LinkId("1"), std::string(998, 'n')); });
    window->selection().select({LinkId("1")});
    window->digraph().renameSelected();
    typeAtTheEnd("xy");
    QCOMPARE(now()->find(LinkId("1"))->name, std::string(998, 'n') + "xy");
    window->digraph().renameSelected();
    typeAtTheEnd("z");  // refused, not cut
    QCOMPARE(now()->find(LinkId("1"))->name, std::string(998, 'n') + "xy");

    window->digraph().editLoad();
    const std::string torque = "1/" + std::string(300, '7');
    typeAtTheEnd(torque.c_str());
    window->digraph().editLoad();
    QCOMPARE(qobject_cast<RenameEditor*>(window->focusWidget())->text().toStdString(), torque + " Nm");
    QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
  }

  void aNameOrNoteBeingTypedStaysOutOfAnotherDocument() {
    const Mechanism other = readDocument(QStringLiteral(":/examples/eight-speed-gearbox.geargraph")).value();
    window->selection().select({LinkId("1")});
    window->digraph().renameSelected();
    QTest::keyClicks(window->focusWidget(), QStringLiteral("Arm"));
    QPointer<QWidget> editor = window->focusWidget();
    QVERIFY(qobject_cast<RenameEditor*>(editor.data()) != nullptr);
    window->document().replace(other, {});
    QTRY_VERIFY(editor.isNull());
    QVERIFY(*now() == other);

    const Mechanism noted = withNote(other, {100, 100}, "a note").value();
    window->document().replace(noted, {});
    window->selection().select({noted.view.notes.front().id});
    window->digraph().renameSelected();
    editor = window->focusWidget();
    QVERIFY(qobject_cast<NoteEditor*>(editor.data()) != nullptr);
    QTest::keyClicks(editor, QStringLiteral("changed"));
    window->document().replace(other, {});
    QTRY_VERIFY(editor.isNull());
    QVERIFY(*now() == other);
    QCOMPARE(window->document().undoStack().count(), 0);
  }

  void nodesKeepToTheGrid() {
    press(Qt::Key_NumberSign);
    QVERIFY(window->actions()[CommandId::grid]->isChecked());
    const auto isOnGrid = [](CanvasPoint p) { return std::fmod(p.x, 20) == 0 && std::fmod(p.y, 20) == 0; };
    const auto placeOf = [this](const char* id) { return now()->view.nodes.at(LinkId(id)); };
    QVERIFY(!isOnGrid(placeOf("1")));  // nothing moves by itself
    QWidget* sheet = window->digraph().viewport();
    const QPoint from = test::Hand(*window).placeOf(1);
    const auto dragWith = [&](Qt::KeyboardModifiers modifiers, QPoint by) {
      const QPoint start = test::Hand(*window).placeOf(1);
      QTest::mousePress(sheet, Qt::LeftButton, modifiers, start);
      for (int step = 1; step <= 4; ++step) {
        QMouseEvent move(QEvent::MouseMove, start + by * step / 4, sheet->mapToGlobal(start + by * step / 4),
                         Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(sheet, &move);
      }
      QTest::mouseRelease(sheet, Qt::LeftButton, modifiers, start + by);
    };
    dragWith({}, {33, 27});
    QVERIFY(test::Hand(*window).placeOf(1) != from);
    QVERIFY(isOnGrid(placeOf("1")));
    dragWith(Qt::AltModifier, {13, 8});
    QVERIFY(!isOnGrid(placeOf("1")));
    press(Qt::Key_NumberSign);
    QVERIFY(!window->actions()[CommandId::grid]->isChecked());
  }

  void allKeysStandOnOneSheet() {
    press(Qt::Key_F1, Qt::ControlModifier);
    auto* sheet = part<ShortcutSheet>("shortcutSheet");
    QVERIFY(sheet != nullptr && sheet->isVisible());
    const auto columns = sheet->findChildren<QTextBrowser*>();
    QCOMPARE(columns.size(), static_cast<qsizetype>(ShortcutSheet::kColumns));
    QTRY_VERIFY(!columns.back()->toPlainText().isEmpty());
    QString text;
    for (const QTextBrowser* column : columns) text += column->toPlainText();
    for (const char* key : {"Ctrl+K", "F11", "Ctrl+D", "Alt+1", "Ctrl+G", "Space", "Shift+F"}) {
      QVERIFY2(text.contains(key), key);
    }
    sheet->close();
    // No key stands for two commands.
    QStringList keys;
    for (const QAction* action : window->findChildren<QAction*>()) {
      for (const QKeySequence& key : action->shortcuts()) keys << key.toString();
    }
    QCOMPARE(keys.removeDuplicates(), 0);
  }

  void theSheetOfKeysPrintsOnOnePage() {
    const QSizeF landscape(1062, 734);  // A4 within its margins, in pixels
    const auto page = ShortcutSheet::pageFor(*window->menuBar(), landscape);
    QCOMPARE(page->pageCount(), 1);
    QVERIFY(page->size().width() <= landscape.width());
    for (const char* key : {"Ctrl+K", "F11", "Shift+F"}) QVERIFY2(page->toPlainText().contains(key), key);
    const QTemporaryDir folder;
    QPrinter printer(QPrinter::HighResolution);
    printer.setPageOrientation(QPageLayout::Landscape);
    printer.setOutputFileName(folder.filePath("keys.pdf"));
    ShortcutSheet::printOn(printer, *window->menuBar());
    QVERIFY(QFileInfo(folder.filePath("keys.pdf")).size() > 10'000);
  }

  void menusReadCleanly() {
    QStringList titles;
    for (const QAction* top : window->menuBar()->actions()) titles << top->text().remove('&');
    QCOMPARE(titles, (QStringList{"File", "Edit", "View", "Mechanism", "Motion", "Learn", "Help"}));
    for (const QAction* action : window->findChildren<QAction*>()) {
      QVERIFY2(!action->text().contains("..."), qPrintable(action->text()));
      QVERIFY2(!action->text().contains(QStringLiteral("  ")), qPrintable(action->text()));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowHabitsTest)
#include "test_window_habits.moc"
