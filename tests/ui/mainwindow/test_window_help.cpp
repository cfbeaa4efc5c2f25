#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QWhatsThis>

#include "core/presentation/manual/manual.h"
#include "core/presentation/manual/markdown.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/help/help_browser.h"
#include "ui/help/help_page_of.h"
#include "ui/help/help_window.h"
#include "ui/help/search_entries.h"
#include "ui/help/search_field.h"
#include "ui/help/tour.h"
#include "ui/help/whats_this.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/shortcut_sheet.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_table.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_help.h"
#include "ui/settings/settings.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

/// The manual, F1, "What's this" and the tour, in the window.
class WindowHelpTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  template <class Widget>
  Widget* part(const char* name) {
    return window->findChild<Widget*>(QLatin1String(name));
  }
  WindowHelp& help() { return window->help(); }
  HelpWindow* manual() { return help().manualWindow(); }

  static bool isPlace(const QString& place) {
    const ManualPage* page = manualPage(place.section('#', 0, 0).toStdString());
    if (page == nullptr) return false;
    const std::string anchor = place.section('#', 1).toStdString();
    return anchor.empty() || std::any_of(page->sections.begin(), page->sections.end(),
                                         [&](const auto& section) { return section.anchor == anchor; });
  }
  static QStringList allIn(const std::string& html, const char* pattern) {
    QStringList found;
    const QRegularExpression expression{QString::fromLatin1(pattern)};
    for (auto match = expression.globalMatch(QString::fromStdString(html)); match.hasNext();)
      found << QString::fromStdString(plainTextOf(match.next().captured(1).toStdString()));
    return found;
  }
  /// What is operated or chosen from, and seen.
  QList<QWidget*> controls() {
    QList<QWidget*> found;
    for (auto* each : window->findChildren<QWidget*>()) {
      const bool isControl =
          qobject_cast<QAbstractButton*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr ||
          qobject_cast<QAbstractSpinBox*>(each) != nullptr || qobject_cast<QLineEdit*>(each) != nullptr ||
          qobject_cast<QAbstractItemView*>(each) != nullptr ||
          (qobject_cast<QAbstractSlider*>(each) != nullptr && qobject_cast<QScrollBar*>(each) == nullptr);
      if (isControl && each->isVisible() && each->window() == window.get()) found << each;
    }
    return found;
  }
  bool hasInk(HelpBrowser& browser, const QUrl& url) {
    const auto image = browser.document()->resource(QTextDocument::ImageResource, url).value<QImage>();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (qAlpha(image.pixel(x, y)) > 128) return true;
      }
    }
    return false;
  }
  void pressOnFocus(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() { window.reset(); }

  // --- what the manual names
  // --------------------------------------------------------------------------------

  void everyCommandThatTheManualNamesExists() {
    int commands = 0;
    for (const ManualPage& page : manualPages()) {
      for (const QString& path : allIn(page.html, "<strong>([^<]* &gt; [^<]*)</strong>")) {
        QVERIFY2(commandAt(*window->menuBar(), path) != nullptr,
                 qPrintable(QString::fromStdString(page.id) + ": " + path));
        ++commands;
      }
    }
    QVERIFY(commands > 50);
    QCOMPARE(commandAt(*window->menuBar(), QStringLiteral("File > Nothing")), nullptr);
  }

  void everyKeyThatTheManualNamesDoesSomething() {
    QStringList keys;
    for (const auto* action : window->findChildren<QAction*>())
      for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    QString sheet;
    for (const QString& column : ShortcutSheet::columnsFor(*window->menuBar())) sheet += column;
    int count = 0;
    for (const ManualPage& page : manualPages()) {
      for (const QString& key : allIn(page.html, "<kbd>([^<]*)</kbd>")) {
        ++count;
        const QRegularExpression word(
            QStringLiteral("(^|[^\\w+])%1([^\\w+]|$)").arg(QRegularExpression::escape(key)));
        QVERIFY2(keys.contains(key) || sheet.contains(word), qPrintable(key));
      }
    }
    QVERIFY(count > 40);
  }

  // --- F1
  // ---------------------------------------------------------------------------------------------------

  void everyPageInTheTableExists() {
    for (const QString& page : namedPages()) QVERIFY2(isPlace(page), qPrintable(page));
    for (const ViewEntry& view : viewTable()) QVERIFY2(isPlace(view.helpPage), qPrintable(view.id));
  }

  void everyPanelAndDrawingHasAPage() {
    const auto docks = window->findChildren<QDockWidget*>();
    QVERIFY(docks.size() >= 10);
    for (QDockWidget* dock : docks) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      QVERIFY2(!purposeOf(*dock).isEmpty(), qPrintable(dock->objectName()));
      const QString page = helpPageOf(dock);
      for (const auto* inside : dock->findChildren<QWidget*>()) QCOMPARE(helpPageOf(inside), page);
    }
    QStringList pages;
    for (const char* drawing : {"digraph", "ttgraph", "schematic"}) {
      window->showDrawing(QLatin1String(drawing));
      pages << helpPageOf(&window->drawing());
    }
    pages.removeDuplicates();
    QCOMPARE(pages.size(), 3);
  }

  void f1OpensThePageOfWhatHasTheFocus() {
    auto* matrices = part<QDockWidget>("dock.matrices");
    matrices->raise();
    auto* button = matrices->findChild<QToolButton*>(QStringLiteral("exportCsv"));
    QVERIFY(button != nullptr);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_F1);
    QVERIFY(manual() != nullptr && manual()->isVisible() && !manual()->isModal());
    QCOMPARE(manual()->place(), QStringLiteral("digraph-and-matrices"));
    window->activateWindow();
    window->showDrawing(QStringLiteral("ttgraph"));
    window->drawing().setFocus();
    window->actions()[CommandId::manual]->trigger();
    QCOMPARE(manual()->place(), QStringLiteral("t-t-graph-method"));
  }

  void f1WorksInDialogsToo() {
    const std::pair<QAction*, const char*> dialogs[] = {
        {window->actions()[CommandId::insertSet], "insertSet"},
        {window->actions()[CommandId::print], "printDialog"},
        {window->actions()[CommandId::exportPicture], "pictureDialog"},
        {window->actions()[CommandId::history], "historyDialog"},
        {window->actions()[CommandId::shortcuts], "shortcutSheet"},
        {window->actions()[CommandId::lessons], "courseDialog"},
        {window->actions()[CommandId::checkPaper], "paperCheck"},
        {window->actions()[CommandId::exercises], "exercisesDialog"},
        {window->actions()[CommandId::about], "about"}};
    for (const auto& [action, name] : dialogs) {
      action->trigger();
      QTRY_VERIFY2(part<QDialog>(name) != nullptr, name);  // drawings to be printed come one by one
      auto* dialog = part<QDialog>(name);
      QVERIFY2(dialog->isVisible(), name);
      dialog->activateWindow();
      QTRY_COMPARE(QApplication::activeWindow(), dialog);
      QTest::keyClick(dialog, Qt::Key_F1);
      QCOMPARE(manual()->place(), helpPageOf(dialog));
      QVERIFY2(isPlace(helpPageOf(dialog)), name);
      dialog->close();
    }
  }

  // --- the manual
  // -------------------------------------------------------------------------------------------

  void pagesGoBackAndForward() {
    help().showPage(QStringLiteral("drawing"));
    emit manual()->browser().pageWanted(QStringLiteral("glossary#ground"));
    QCOMPARE(manual()->place(), QStringLiteral("glossary#ground"));
    QVERIFY(manual()->browser().verticalScrollBar()->value() > 0);
    auto* back = manual()->findChild<QToolButton*>(QStringLiteral("helpBack"));
    auto* forward = manual()->findChild<QToolButton*>(QStringLiteral("helpForward"));
    QTest::mouseClick(back, Qt::LeftButton);
    QCOMPARE(manual()->place(), QStringLiteral("drawing"));
    QTest::mouseClick(forward, Qt::LeftButton);
    QCOMPARE(manual()->place(), QStringLiteral("glossary#ground"));
    QVERIFY(!forward->isEnabled() && !forward->toolTip().isEmpty());
    QVERIFY(!manual()->open(QStringLiteral("no-such-page")));
    QCOMPARE(manual()->place(), QStringLiteral("glossary#ground"));
    auto* contents = manual()->findChild<QTreeWidget*>(QStringLiteral("helpContents"));
    QCOMPARE(contents->topLevelItemCount(), static_cast<int>(manualPages().size()));
    contents->setCurrentItem(contents->topLevelItem(0)->child(1));
    QCOMPARE(manual()->place(), QStringLiteral("first-steps#draw-a-mechanism-of-your-own"));
  }

  void wordsAreFoundThroughAllPages() {
    help().showPage(QStringLiteral("first-steps"));
    auto* find = manual()->findChild<QLineEdit*>(QStringLiteral("helpFind"));
    find->setFocus();
    find->setText(QStringLiteral("ravigneaux"));
    QTest::keyClick(find, Qt::Key_Return);
    QCOMPARE(manual()->place(), QStringLiteral("drawing"));
    QCOMPARE(manual()->browser().textCursor().selectedText(), QStringLiteral("Ravigneaux"));
    QVERIFY(manual()->isVisible());  // Return closes no dialog
    find->setText(QStringLiteral("xyzzy"));
    QTest::keyClick(find, Qt::Key_Return);
    QCOMPARE(manual()->findChild<QLabel*>(QStringLiteral("helpFound"))->text(), QStringLiteral("Not found"));
  }

  void commandsOfThePagesAreCarriedOut() {
    help().showPage(QStringLiteral("the-window"));
    QVERIFY(manual()->browser().toHtml().contains(QStringLiteral("command:View &gt; Gearbox")));
    part<QDockWidget>("dock.gearbox")->hide();
    emit manual()->browser().commandWanted(QStringLiteral("View > Gearbox"));
    QVERIFY(part<QDockWidget>("dock.gearbox")->isVisible());
    emit manual()->browser().commandWanted(QStringLiteral("View > Gearbox"));
    QVERIFY(part<QDockWidget>("dock.gearbox")->isVisible());  // shown, never hidden
    QSignalSpy rejected(&help(), &WindowHelp::rejected);
    emit manual()->browser().commandWanted(QStringLiteral("Mechanism > Make ground"));
    QCOMPARE(rejected.size(), 1);
    QCOMPARE(rejected.front().front().toString(), window->actions()[CommandId::makeGround]->toolTip());
  }

  void lessonsOfThePagesAreOpened() {
    help().showPage(QStringLiteral("gearboxes"));
    QSignalSpy wanted(window.get(), &MainWindow::lessonWanted);
    emit manual()->browser().lessonWanted(QStringLiteral("brakes-and-shift-tables"));
    QCOMPARE(wanted.size(), 1);
  }

  void picturesAndFormulasArePainted() {
    help().showPage(QStringLiteral("matroid-method"));
    HelpBrowser& browser = manual()->browser();
    browser.grab();
    QTRY_VERIFY(browser.isSettled());
    QVERIFY(hasInk(browser, QUrl(QStringLiteral("picture:digraph/robot/cycle.15"))));
    QVERIFY(hasInk(browser, QUrl(QStringLiteral("formula:0"))));
    QVERIFY(!browser.toPlainText().contains(QStringLiteral("x-equation")));
  }

  void pagesFollowTheTheme() {
    help().showPage(QStringLiteral("drawing"));
    HelpBrowser& browser = manual()->browser();
    const QString light = browser.document()->defaultStyleSheet();
    window->setTheme(Theme::dark);
    QTRY_VERIFY(browser.document()->defaultStyleSheet() != light);
    window->setTheme(Theme::light);
    QTRY_COMPARE(browser.document()->defaultStyleSheet(), light);
  }

  // --- the search
  // -------------------------------------------------------------------------------------------

  void pagesAreFoundByTheSearch() {
    auto* search = part<SearchField>("search");
    search->begin();
    QTest::keyClicks(search, QStringLiteral("shift table"));
    QVERIFY(search->model().rowCount() > 0);
    QCOMPARE(search->model().entryAt(0).page, QStringLiteral("gearboxes#the-shift-table"));
    QVERIFY(!search->model().index(0, 0).data(SearchModel::DetailRole).toString().isEmpty());
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(manual() != nullptr && manual()->isVisible());
    QCOMPARE(manual()->place(), QStringLiteral("gearboxes#the-shift-table"));
  }

  void pagesAreFoundByTheirWords() {
    auto* search = part<SearchField>("search");
    search->begin();
    QTest::keyClicks(search, QStringLiteral("undercut contact ratio"));
    QVERIFY(search->model().rowCount() > 0);
    QCOMPARE(search->model().entryAt(0).page, QStringLiteral("teeth-axes-and-3d#what-is-checked"));
  }

  void f1OnATermOpensTheGlossary() {
    auto* search = part<SearchField>("search");
    search->begin();
    QTest::keyClicks(search, QStringLiteral("transfer vertex"));
    QVERIFY(search->model().entryAt(0).term.has_value());
    QTest::keyClick(search, Qt::Key_F1);
    QCOMPARE(manual()->place(), QStringLiteral("glossary#transfer-vertex"));
  }

  // --- "What's this"
  // ----------------------------------------------------------------------------------------

  void everyControlSaysWhatItIs() {
    int count = 0;
    for (auto* dock : window->findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      for (QWidget* control : controls()) {
        const QString text = WhatsThis::textFor(control);
        QVERIFY2(!text.isEmpty(),
                 qPrintable(control->objectName() + ' ' + control->metaObject()->className()));
        QHelpEvent asked(QEvent::QueryWhatsThis, {2, 2}, control->mapToGlobal(QPoint(2, 2)));
        asked.ignore();
        QCoreApplication::sendEvent(control, &asked);
        QVERIFY2(asked.isAccepted(), qPrintable(control->objectName()));
        ++count;
      }
    }
    QVERIFY(count > 80);
    QVERIFY(WhatsThis::textFor(part<QToolButton>("exportCsv"))
                .contains(part<QToolButton>("exportCsv")->toolTip()));
  }

  void everyCommandSaysWhatItDoes() {
    window->actions()[CommandId::whatsThis]->trigger();
    QVERIFY(QWhatsThis::inWhatsThisMode());
    QWhatsThis::leaveWhatsThisMode();
    int count = 0;
    for (const auto* action : window->menuBar()->findChildren<QAction*>()) {
      if (action->isSeparator() || action->menu() != nullptr || action->text().isEmpty()) continue;
      QVERIFY2(!action->whatsThis().isEmpty(), qPrintable(action->text()));
      ++count;
    }
    for (const auto* action : {window->actions()[CommandId::save], window->actions()[CommandId::flip],
                               window->actions()[CommandId::tour]})
      QVERIFY(action->whatsThis().contains(action->toolTip().toHtmlEscaped()));
  }

  // --- the tour
  // ---------------------------------------------------------------------------------------------

  void theTourPointsAtPartsOfTheWindow_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("1366x768") << QSize(1366, 768);
    QTest::newRow("1280x720") << QSize(1280, 720);
  }
  void theTourPointsAtPartsOfTheWindow() {
    QFETCH(QSize, size);
    window->resize(size);
    part<QDockWidget>("dock.inputs")->hide();
    window->actions()[CommandId::tour]->trigger();
    Tour* tour = help().tour();
    QVERIFY(tour != nullptr && tour->isVisible());
    QVERIFY(tour->count() >= 6 && tour->count() <= 8);
    QVERIFY(tour->target().isEmpty());  // the welcome
    std::set<std::pair<int, int>> places;
    while (tour->step() + 1 < tour->count()) {
      const int before = tour->step();
      tour->next();
      QCoreApplication::processEvents();
      QCOMPARE(tour->step(), before + 1);
      QVERIFY(tour->rect().contains(tour->card().geometry()));
      const QRect target = tour->target().boundingRect();
      QVERIFY(target.width() > 100 && target.height() > 20);
      QVERIFY2(!tour->card().geometry().intersects(target), qPrintable(QString::number(tour->step())));
      QVERIFY(!tour->card().accessibleName().isEmpty() && !tour->card().accessibleDescription().isEmpty());
      places.insert({target.x(), target.y()});
    }
    QVERIFY(places.size() >= 5);
    QVERIFY(part<QDockWidget>("dock.inputs")->isVisible());
    tour->next();
    QTRY_VERIFY(help().tour() == nullptr);
    QVERIFY(window->digraph().hasFocus());
  }

  void theTourIsTakenByKeys() {
    help().startTour();
    Tour* tour = help().tour();
    help().startTour();
    QCOMPARE(help().tour(), tour);  // one at a time
    pressOnFocus(Qt::Key_Right);
    QCOMPARE(tour->step(), 1);
    pressOnFocus(Qt::Key_Return);
    QCOMPARE(tour->step(), 2);
    pressOnFocus(Qt::Key_Left);
    QCOMPARE(tour->step(), 1);
    QStringList focused;
    for (int i = 0; i < 3; ++i) {
      pressOnFocus(Qt::Key_Tab);
      focused << QApplication::focusWidget()->objectName();
    }
    QCOMPARE(focused, (QStringList{"tourSkip", "tourBack", "tourNext"}));
    pressOnFocus(Qt::Key_L);  // no tool meanwhile
    pressOnFocus(Qt::Key_Delete);
    QCOMPARE(window->digraph().tool(), ToolKind::select);
    QVERIFY(!window->document().isModified());
    pressOnFocus(Qt::Key_Escape);
    QTRY_VERIFY(help().tour() == nullptr);
  }

  void theTourIsOfferedOnceAndOpensTheRobot() {
    removeSetting(QStringLiteral("tourOffered"));
    MainWindow fresh;
    fresh.show();
    fresh.showStartPage();
    fresh.help().offerTour();
    QVERIFY(fresh.help().tour() != nullptr);
    QVERIFY(fresh.startPage().isVisible());
    fresh.help().tour()->next();
    QVERIFY(!fresh.startPage().isVisible());
    QCOMPARE(fresh.document().mechanism()->n(), 7);
    fresh.help().tour()->end();
    QTRY_VERIFY(fresh.help().tour() == nullptr);
    fresh.help().offerTour();
    QVERIFY(fresh.help().tour() == nullptr);
    fresh.help().startTour();  // asked for again
    QVERIFY(fresh.help().tour() != nullptr);
  }

  void theTourLeavesAnotherDocumentAsItIs() {
    const MechanismPtr before = window->document().mechanism();
    QVERIFY(window->openDocument(QStringLiteral(":/examples/simpson.geargraph")));
    const MechanismPtr simpson = window->document().mechanism();
    help().startTour();
    help().tour()->next();
    QCOMPARE(window->document().mechanism(), simpson);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowHelpTest)
#include "test_window_help.moc"
