#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "ui/theme/application_theme.h"
#include "ui/theme/style_sheet.h"
#include "ui/theme/theme_sheets.h"

namespace geargraph {
namespace {

constexpr int kDocks = 6;

/// A window with docks that hold a card each, the last dock hidden.
struct ThemedWindow {
  QMainWindow window;
  std::vector<QDockWidget*> docks;
  std::vector<QFrame*> cards;

  ThemedWindow() {
    window.menuBar()->addMenu(QStringLiteral("File"));
    window.setCentralWidget(new QLabel(QStringLiteral("centre")));
    for (int i = 0; i < kDocks; ++i) {
      auto* dock = new QDockWidget(QString::number(i), &window);
      auto* card = new QFrame;
      card->setProperty("look", "card");
      dock->setWidget(card);
      window.addDockWidget(Qt::RightDockWidgetArea, dock);
      docks.push_back(dock);
      cards.push_back(card);
    }
    docks.back()->hide();
    window.resize(400, 600);
    window.show();
  }

  /// The parts of the window that are shown and do not have the sheet.
  [[nodiscard]] int outdated(const QString& sheet) const {
    const QObjectList& children = window.children();
    return static_cast<int>(std::count_if(children.begin(), children.end(), [&](QObject* child) {
      auto* widget = qobject_cast<QWidget*>(child);
      return widget != nullptr && widget->isVisible() && widget->styleSheet() != sheet;
    }));
  }
};

struct PaintCount : QObject {
  int count = 0;
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count;
    return QObject::eventFilter(watched, event);
  }
};

QColor middleOf(QWidget& widget) {
  const QImage image = widget.grab().toImage();
  return image.pixelColor(image.rect().center());
}

}  // namespace

class ThemeSheetsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    applyTheme(*qApp, Theme::light);
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
  }

  void everyPartHasTheSheetAndTheWindowHasNone() {
    ThemedWindow shown;
    QVERIFY(shown.window.styleSheet().isEmpty());
    QVERIFY(qApp->styleSheet().isEmpty());
    QCOMPARE(shown.outdated(styleSheetOf(Theme::light)), 0);
    QCOMPARE(middleOf(*shown.cards.front()), qColor(ColorRole::sheet, Theme::light));
  }

  void anotherThemeGoesThroughThePartsOneATurn() {
    ThemedWindow shown;
    const QString dark = styleSheetOf(Theme::dark);
    applyTheme(*qApp, Theme::dark);
    const int parts = shown.outdated(dark);
    QVERIFY(parts > kDocks);  // the docks that are shown, the menu bar and the centre
    int left = parts;
    int most = 0;
    QTimer turns;
    turns.setInterval(0);
    connect(&turns, &QTimer::timeout, [&] {
      const int now = shown.outdated(dark);
      most = std::max(most, left - now);
      left = now;
    });
    turns.start();
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    QCOMPARE(shown.outdated(dark), 0);
    QVERIFY2(most <= 2, qPrintable(QString::number(most)));  // the timers may run in either order
    QCOMPARE(middleOf(*shown.cards.front()), qColor(ColorRole::sheet, Theme::dark));
  }

  void theWindowPaintsWhenAllPartsHaveTheSheet() {
    ThemedWindow shown;
    PaintCount paints;
    shown.cards.front()->installEventFilter(&paints);
    QVERIFY(QTest::qWaitForWindowExposed(&shown.window));
    QCoreApplication::processEvents();
    shown.cards.front()->update();  // which waits to be painted when the theme changes
    paints.count = 0;
    applyTheme(*qApp, Theme::dark);
    QVERIFY(!shown.window.updatesEnabled());
    QSignalSpy settled(&ThemeSheets::instance(), &ThemeSheets::settled);
    QVERIFY(settled.wait());
    QVERIFY(shown.window.updatesEnabled());
    QCOMPARE(paints.count, 0);
    QTRY_COMPARE(paints.count, 1);
  }

  void aHiddenDockGetsTheSheetAfterThoseThatAreShown() {
    ThemedWindow shown;
    const QDockWidget* hidden = shown.docks.back();
    const QString dark = styleSheetOf(Theme::dark);
    std::optional<bool> isLater;
    connect(&ThemeSheets::instance(), &ThemeSheets::settled, &shown.window,
            [&] { isLater = hidden->styleSheet() != dark; });
    applyTheme(*qApp, Theme::dark);
    QTRY_COMPARE(hidden->styleSheet(), dark);
    QVERIFY(!hidden->isVisible());
    QVERIFY(isLater && *isLater);
  }

  /// Its end shows the hidden parts, which waits for the sheets of all that have another one.
  void aPresentationLeavesTheSheetsOfHiddenDocks() {
    ThemedWindow shown;
    const QString before = shown.docks.back()->styleSheet();
    applyTheme(*qApp, Theme::light, 1.5);
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    for (std::size_t i = 0; i <= shown.docks.size(); ++i)
      QCoreApplication::processEvents();  // a turn for each
    QVERIFY(shown.docks.front()->styleSheet() != before);
    QCOMPARE(shown.docks.back()->styleSheet(), before);
    applyTheme(*qApp, Theme::light);
    QCOMPARE(styleSheetOf(Theme::light), before);
  }

  void aHiddenDockThatIsShownEarlierGetsTheSheetBeforeTheWindowPaints() {
    ThemedWindow shown;
    applyTheme(*qApp, Theme::dark);
    QDockWidget* hidden = shown.docks.back();
    QVERIFY(hidden->styleSheet() != styleSheetOf(Theme::dark));
    hidden->show();
    QVERIFY(!shown.window.updatesEnabled());
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    QCOMPARE(hidden->styleSheet(), styleSheetOf(Theme::dark));
    shown.cards.back()->resize(20, 20);  // its dock may have no room
    QCOMPARE(middleOf(*shown.cards.back()), qColor(ColorRole::sheet, Theme::dark));
  }

  /// As when the layout is reset after a presentation.
  void hiddenDocksWithAnotherSheetThatAreShownTogetherGetItOneATurn() {
    ThemedWindow shown;
    for (QDockWidget* dock : shown.docks) dock->hide();
    applyTheme(*qApp, Theme::light, 1.5);
    QTRY_VERIFY(ThemeSheets::instance().isSettled() && shown.window.updatesEnabled());
    const QString sheet = styleSheetOf(Theme::light);
    for (QDockWidget* dock : shown.docks) dock->show();
    QCOMPARE(shown.outdated(sheet), kDocks);
    QVERIFY(!shown.window.updatesEnabled());
    QCoreApplication::processEvents();
    QVERIFY(shown.outdated(sheet) > 0);
    QTRY_VERIFY(shown.window.updatesEnabled());
    QCOMPARE(shown.outdated(sheet), 0);
    applyTheme(*qApp, Theme::light);
  }

  void floatingDocksWithAnotherSheetThatAreShownTogetherGetItOneATurn() {
    ThemedWindow shown;
    for (QDockWidget* dock : shown.docks) {
      dock->setFloating(true);
      dock->hide();
    }
    applyTheme(*qApp, Theme::light, 1.5);
    QTRY_VERIFY(ThemeSheets::instance().isSettled() && shown.window.updatesEnabled());
    const QString sheet = styleSheetOf(Theme::light);
    for (QDockWidget* dock : shown.docks) dock->show();
    QVERIFY(shown.docks.front()->isWindow());
    QCOMPARE(shown.outdated(sheet), kDocks);
    QTRY_COMPARE(shown.outdated(sheet), 0);
    applyTheme(*qApp, Theme::light);
  }

  /// As when a presentation ends that hid them before they were ever seen.
  void docksThatAreFirstShownTogetherGetItOneATurn() {
    ThemedWindow shown;
    QCOMPARE(shown.outdated(styleSheetOf(Theme::light)), 0);  // the layout of a new window begins with it
    std::vector<QDockWidget*> added;
    for (int i = 0; i < 3; ++i) {
      auto* dock = added.emplace_back(new QDockWidget(QString::number(i), &shown.window));
      dock->setWidget(new QLabel(QStringLiteral("new")));
      dock->hide();
      shown.window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    }
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    for (QDockWidget* dock : added) dock->show();
    const QString sheet = styleSheetOf(Theme::light);
    QCOMPARE(shown.outdated(sheet), 2);  // the first one has it at once
    QVERIFY(!shown.window.updatesEnabled());
    QTRY_VERIFY(shown.window.updatesEnabled());
    QCOMPARE(shown.outdated(sheet), 0);
  }

  void windowsPaintOneATurn() {
    ThemedWindow one;
    ThemedWindow other;
    applyTheme(*qApp, Theme::dark);
    bool oneWaits = false;
    QTimer turns;
    turns.setInterval(0);
    connect(&turns, &QTimer::timeout, [&] {
      if (one.window.updatesEnabled() != other.window.updatesEnabled()) oneWaits = true;
    });
    turns.start();
    QTRY_VERIFY(one.window.updatesEnabled() && other.window.updatesEnabled());
    QVERIFY(oneWaits);
  }

  void dialogsMenusAndWindowsThatOpenLaterHaveTheSheet() {
    ThemedWindow shown;
    applyTheme(*qApp, Theme::dark);
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    const QString dark = styleSheetOf(Theme::dark);
    QDialog dialog(&shown.window);
    dialog.show();
    QCOMPARE(dialog.styleSheet(), dark);
    QMenu menu(&shown.window);
    menu.addAction(QStringLiteral("Cut"));
    menu.popup(QPoint());
    QCOMPARE(menu.styleSheet(), dark);
    QWidget alone;
    alone.show();
    QCOMPARE(alone.styleSheet(), dark);
    // What is in a part has the part's: another sheet of its own would be polished twice.
    QMenu inDock(shown.docks.front());
    inDock.addAction(QStringLiteral("Copy"));
    inDock.popup(QPoint());
    QVERIFY(inDock.styleSheet().isEmpty());
  }

  void twoChangesInOneTurnEndWithTheLast() {
    ThemedWindow shown;
    applyTheme(*qApp, Theme::dark);
    applyTheme(*qApp, Theme::highContrast);
    QTRY_VERIFY(ThemeSheets::instance().isSettled());
    QVERIFY(shown.window.updatesEnabled());
    QCOMPARE(shown.outdated(styleSheetOf(Theme::highContrast)), 0);
    QCOMPARE(QToolTip::palette().color(QPalette::ToolTipBase), qColor(ColorRole::sheet, Theme::highContrast));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ThemeSheetsTest)
#include "test_theme_sheets.moc"
