#include <QMenu>
#include <QMenuBar>
#include <QTest>

#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/settings/languages.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Texts against their room, in large type and in a language of long words.
class WindowTextsTest : public QObject {
  Q_OBJECT

  static void addScreens() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<double>("scale");
    for (const char* code : {"en", "de"}) {
      for (const double scale : {1.0, 1.5, 2.0})
        QTest::addRow("%s, %d %%", code, qRound(100 * scale)) << QString(code) << scale;
    }
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void cleanup() {
    useLanguage(QStringLiteral("en"));
    applyTheme(*qApp, Theme::light);
    test::clearSettings();
  }

  /// A menu that is higher than the screen goes on in a second column unless it scrolls.
  void menusAreOneColumn_data() { addScreens(); }
  void menusAreOneColumn() {
    QFETCH(QString, code);
    QFETCH(double, scale);
    useLanguage(code);
    applyTheme(*qApp, Theme::light, scale);
    MainWindow window;
    window.show();
    for (QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
      if (menu->actions().isEmpty()) continue;
      menu->popup(window.pos());
      const QList<QAction*> actions = menu->actions();
      const int left = menu->actionGeometry(actions.first()).left();
      for (const QAction* action : actions) {
        const QRect place = menu->actionGeometry(const_cast<QAction*>(action));
        QVERIFY2(place.isNull() || place.left() == left, qPrintable(menu->title() + ": " + action->text()));
      }
      menu->close();
    }
  }

  void theProjectorHasALargeDrawingBeside3D() {
    const auto window = test::openedWindow(QStringLiteral(":/examples/robot.geargraph"));
    QVERIFY(window != nullptr);
    window->resize(1280, 720);
    window->actions()[CommandId::projector]->trigger();
    QTRY_VERIFY(window->drawing().width() >= 0.6 * window->width());
    QCOMPARE(test::shownDocks(*window).size(), 1);
    QVERIFY(window->view3d().isVisible() && window->view3d().width() > 0.3 * window->width());
    QVERIFY(QFontInfo(window->font()).pixelSize() * 11 / 13 >= 14);  // of captions
    window->actions()[CommandId::resetLayout]->trigger();
    QTRY_VERIFY(test::shownDocks(*window).size() > 1);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowTextsTest)
#include "test_window_texts.moc"
