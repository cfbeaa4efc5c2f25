#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>
#include <set>

#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/settings/languages.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

namespace {

/// The width of a text of several lines without the marks of its mnemonic.
int wideOf(const QWidget& widget, const QString& text) {
  return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

/// What is cut off in one widget, as a sentence; empty: nothing. What scrolls or is meant to be shortened,
/// with its whole text in a tip, is not asked.
QString cutOff(const QWidget& widget) {
  const auto said = [&](const QString& text, int has, int needs) {
    return QStringLiteral("%1 \"%2\" (%3): %4 px of %5")
        .arg(QLatin1String(widget.metaObject()->className()), text, widget.objectName())
        .arg(has)
        .arg(needs);
  };
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty() || !label->toolTip().isEmpty()) return {};
    if (label->wordWrap()) {
      const int needs = label->heightForWidth(label->width());
      return label->height() + 2 < needs ? said(label->text(), label->height(), needs) : QString();
    }
    const bool isRich = Qt::mightBeRichText(label->text());
    const int needs = isRich ? label->sizeHint().width() : wideOf(*label, label->text());
    return label->contentsRect().width() + 1 < needs
               ? said(label->text(), label->contentsRect().width(), needs)
               : QString();
  }
  if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
    for (int i = 0; i < bar->count(); ++i) {
      if (!bar->isTabVisible(i)) continue;
      const int needs = wideOf(*bar, bar->tabText(i));
      const int has = bar->tabRect(i).width();
      if (has < needs) return said(bar->tabText(i), has, needs);
    }
    return {};
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.editable = box->isEditable();
    const int has =
        box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box).width();
    const int needs = wideOf(*box, box->currentText());
    return has < needs && box->toolTip().isEmpty() ? said(box->currentText(), has, needs) : QString();
  }
  if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
    if (header->orientation() != Qt::Horizontal || header->model() == nullptr) return {};
    for (int i = 0; i < header->count(); ++i) {
      if (header->isSectionHidden(i)) continue;
      const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
      const int needs = header->fontMetrics().size(0, text).width();
      if (header->sectionSize(i) < needs) return said(text, header->sectionSize(i), needs);
    }
    return {};
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    const auto* tool = qobject_cast<const QToolButton*>(button);
    if (button->text().isEmpty() || (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
      return {};
    const QString text =
        tool != nullptr && tool->defaultAction() ? tool->defaultAction()->iconText() : button->text();
    const int needs = wideOf(*button, text);
    return button->width() < needs ? said(text, button->width(), needs) : QString();
  }
  return {};
}

/// All that is cut off among the widgets that are shown now.
void gather(const QWidget& window, std::set<QString>& found) {
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
    const QString cut = cutOff(*widget);
    if (!cut.isEmpty()) found.insert(cut);
  }
}

}  // namespace

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

  /// Each panel and each drawing in front once, on the screens of lecture halls and old laptops.
  void noTextIsCutOff_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("scale");
    for (const QSize size : {QSize(1024, 768), QSize(1280, 720), QSize(1366, 768)}) {
      for (const double scale : {1.0, 1.5, 2.0})
        QTest::addRow("%d x %d, %d %%", size.width(), size.height(), qRound(100 * scale)) << size << scale;
    }
  }
  void noTextIsCutOff() {
    QFETCH(QSize, size);
    QFETCH(double, scale);
    useLanguage(QStringLiteral("de"));
    applyTheme(*qApp, Theme::light, scale);
    const auto window = test::openedWindow(QStringLiteral(":/examples/simpson.geargraph"));
    QVERIFY(window != nullptr);
    window->resize(size);
    QCoreApplication::processEvents();
    std::set<QString> found;
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
      if (dock->isHidden()) continue;
      dock->raise();
      std::set<QString> cut;  // once the layout has come to rest
      static_cast<void>(QTest::qWaitFor(
          [&] {
            cut.clear();
            gather(*window, cut);
            return cut.empty();
          },
          10'000));
      found.insert(cut.begin(), cut.end());
    }
    QStringList all;
    for (const QString& each : found) all << each;
    QVERIFY2(found.empty(), qPrintable(QStringLiteral("\n") + all.join(QLatin1Char('\n'))));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowTextsTest)
#include "test_window_texts.moc"
