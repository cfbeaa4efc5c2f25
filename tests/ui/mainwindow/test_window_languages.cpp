#include <QDockWidget>
#include <QMenuBar>
#include <QTabWidget>
#include <QTest>
#include <QToolBar>
#include <set>

#include "tests/ui/mainwindow/file_windows.h"
#include "ui/canvas/drawing_view.h"
#include "ui/mainwindow/fitting_tool_bar.h"
#include "ui/mainwindow/window_files.h"
#include "ui/models/term_tips.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/settings/languages.h"

namespace geargraph {
namespace {

/// Menus in which two entries have one mnemonic, as "View: &Fit, Pre&fer".
QStringList clashesIn(const QList<QAction*>& entries, const QString& of) {
  QStringList clashes;
  QMap<QChar, QString> taken;
  for (const QAction* entry : entries) {
    if (entry->isSeparator()) continue;
    const QString text = entry->text();
    for (qsizetype at = text.indexOf(QLatin1Char('&')); at >= 0 && at + 1 < text.size();
         at = text.indexOf(QLatin1Char('&'), at + 2)) {
      const QChar key = text[at + 1].toLower();
      if (taken.contains(key)) clashes << QStringLiteral("%1: %2, %3").arg(of, taken[key], text);
      taken[key] = text;
    }
    if (entry->menu() != nullptr) clashes << clashesIn(entry->menu()->actions(), text);
  }
  return clashes;
}

}  // namespace

/// The window in other languages, chosen while it runs.
class WindowLanguagesTest : public QObject, protected test::FileWindows {
  Q_OBJECT

  void choose(const QString& code) const {
    auto* action = first().findChild<QAction*>(QStringLiteral("view.language.") + code);
    QVERIFY(action != nullptr);
    action->trigger();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  [[nodiscard]] QStringList menuTitles() const {
    QStringList titles;
    for (const QAction* menu : first().menuBar()->actions()) titles << menu->text();
    return titles;
  }

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() {
    useLanguage(QStringLiteral("en"));
    makeFolder();
  }
  void cleanup() {
    set.reset();
    QApplication::setLayoutDirection(Qt::LeftToRight);
    useLanguage(QStringLiteral("en"));
  }

  void aLanguageIsChosenWhileTheWindowRuns() {
    set->start({written(QStringLiteral("a.geargraph"), 2)});
    addLink(first());
    first().showDrawing(QStringLiteral("schematic"));
    first().actions().tool[static_cast<std::size_t>(ToolKind::gearMesh)]->trigger();
    first().selection().select({first().document().mechanism()->links[1].id});
    first().findChild<QDockWidget*>(QStringLiteral("dock.matrices"))->hide();
    const MechanismPtr before = first().document().mechanism();

    const QString english = first().document().undoStack().undoText();
    choose(QStringLiteral("de"));
    QCOMPARE(first().document().undoStack().undoText(), QStringLiteral("Schritt 1"));
    QCOMPARE(set->windows().size(), std::size_t{1});
    QVERIFY(first().isVisible());
    QCOMPARE(menuTitles().first(), QStringLiteral("&Datei"));
    QCOMPARE(first().document().mechanism(), before);
    QVERIFY(first().document().isModified());
    QCOMPARE(first().drawing().objectName(), QStringLiteral("schematic"));
    QVERIFY(first().actions().tool[static_cast<std::size_t>(ToolKind::gearMesh)]->isChecked());
    QCOMPARE(first().drawing().tool(), ToolKind::gearMesh);
    QCOMPARE(first().selection().selected().size(), std::size_t{1});
    QVERIFY(first().findChild<QDockWidget*>(QStringLiteral("dock.matrices"))->isHidden());
    QVERIFY(first().files().source().endsWith(QLatin1String("a.geargraph")));
    QVERIFY(!first().files().isReadOnly());
    QTRY_VERIFY(first().isSettled());  // the views of the new window have their answers
    QVERIFY(first().analysis().snapshot() != nullptr);

    first().actions()[CommandId::undo]->trigger();
    QVERIFY(!first().document().isModified());
    first().actions()[CommandId::redo]->trigger();
    QVERIFY(first().saveDocument(first().files().source()));

    QVERIFY(tipOf(Term::pathMatrix).contains(QStringLiteral("Wegmatrix")));  // core's words

    choose(QStringLiteral("en"));
    QCOMPARE(first().document().undoStack().undoText(), english);
    QCOMPARE(menuTitles().first(), QStringLiteral("&File"));
    QVERIFY(first().document().undoStack().canUndo());
  }

  void theChoiceIsRemembered() {
    set->start({});
    choose(QStringLiteral("tr"));
    QCOMPARE(savedLanguage(), QStringLiteral("tr"));
    QVERIFY(first().findChild<QAction*>(QStringLiteral("view.language.tr"))->isChecked());
    choose(QString());
    QCOMPARE(savedLanguage(), QString());
    QCOMPARE(currentLanguage(), systemLanguage());
  }

  void numbersAndPaperFollowTheLanguage() {
    useLanguage(QStringLiteral("de"));
    QCOMPARE(QLocale().decimalPoint(), QStringLiteral(","));
    QCOMPARE(QLocale().measurementSystem(), QLocale::MetricSystem);  // A4
    useLanguage(QStringLiteral("en"));
    QCOMPARE(QLocale().decimalPoint(), QStringLiteral("."));
  }

  void theWindowFitsAProjector_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QSize>("size");
    for (const QString& code : languageCodes()) {
      for (const QSize size : {QSize(1280, 720), QSize(1024, 720)})  // the latter of 768 below its title bar
        QTest::addRow("%s, %d", qPrintable(code), size.width()) << code << size;
    }
  }
  /// Where long words of a panel need more room than there is, the window grows past the screen. Every
  /// control of the tool bar is visible.
  void theWindowFitsAProjector() {
    QFETCH(QString, code);
    QFETCH(QSize, size);
    useLanguage(code);
    for (const char* example : {"robot", "eight-speed-gearbox"}) {
      MainWindow window;
      window.resize(size);
      window.show();
      QVERIFY(window.openDocument(QStringLiteral(":/examples/%1.geargraph").arg(QLatin1String(example))));
      QTRY_VERIFY(window.isSettled());
      QCOMPARE(window.size(), size);
      for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        dock->raise();  // each in turn in front
        QCoreApplication::processEvents();
        QVERIFY2(window.size() == size, qPrintable(dock->objectName()));
      }
      for (const char* name : {"qt_toolbar_ext_button", "qt_menubar_ext_button"}) {
        for (const QWidget* extension : window.findChildren<QWidget*>(QLatin1String(name)))
          QVERIFY2(!extension->isVisible(), name);
      }
    }
  }

  /// Names of tools come back when there is room for them again.
  void toolsKeepTheirNamesWhereTheyFit() {
    MainWindow window;
    window.resize(1366, 720);
    window.show();
    const auto* bar = window.findChild<FittingToolBar*>(QStringLiteral("toolBar"));
    QVERIFY(bar->areNamesShown());
    window.resize(1024, 720);
    QTRY_VERIFY(!bar->areNamesShown());
    window.resize(1366, 720);
    QTRY_VERIFY(bar->areNamesShown());
  }

  void filesAreTheSameInEveryLanguage() {
    const QString english = written(QStringLiteral("en.geargraph"), 3);
    useLanguage(QStringLiteral("de"));
    const QString german = written(QStringLiteral("de.geargraph"), 3);
    QFile one(english);
    QFile other(german);
    QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
    QCOMPARE(one.readAll(), other.readAll());
  }

  void mnemonicsAreDistinctInEveryMenu_data() {
    QTest::addColumn<QString>("code");
    for (const QString& code : languageCodes()) QTest::newRow(qPrintable(code)) << code;
  }
  void mnemonicsAreDistinctInEveryMenu() {
    QFETCH(const QString, code);
    useLanguage(code);
    const MainWindow window;
    const QStringList clashes = clashesIn(window.menuBar()->actions(), QStringLiteral("menu bar"));
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(QLatin1Char('\n'))));
  }

  /// On a usual screen every tool has its name, in every language.
  void toolsHaveTheirNamesInEveryLanguage_data() { mnemonicsAreDistinctInEveryMenu_data(); }
  void toolsHaveTheirNamesInEveryLanguage() {
    QFETCH(const QString, code);
    useLanguage(code);
    MainWindow window;
    window.resize(1280, 720);
    window.show();
    QCOMPARE(window.size(), QSize(1280, 720));
    QVERIFY(window.findChild<FittingToolBar*>(QStringLiteral("toolBar"))->areNamesShown());
  }

  void itIsMirroredFromRightToLeft() {
    QApplication::setLayoutDirection(Qt::RightToLeft);
    MainWindow window;
    window.resize(1366, 768);
    window.show();
    const auto menus = window.menuBar()->actions();
    QVERIFY(window.menuBar()->actionGeometry(menus.first()).left() >
            window.menuBar()->actionGeometry(menus.last()).right());
    const auto* bar = window.findChild<QToolBar*>(QStringLiteral("toolBar"));
    const auto tools = window.actions().tools->actions();
    QVERIFY(bar->widgetForAction(tools[0])->x() > bar->widgetForAction(tools[1])->x());
    // Formulas and matrices are read from left to right everywhere.
    QCOMPARE(window.matrices().view().layoutDirection(), Qt::LeftToRight);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowLanguagesTest)
#include "test_window_languages.moc"
