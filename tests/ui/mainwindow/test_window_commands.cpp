#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QListView>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/csv_dialog.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/history_dialog.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_set.h"
#include "ui/panels/matrices_panel.h"
#include "ui/reading/print_dialog.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Commands of the menus by their keys: history, new document, CSV, printing, theme and type size.
class WindowCommandsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&window->digraph(), key, modifiers);
  }
  QAction* action(const char* name) { return window->findChild<QAction*>(QLatin1String(name)); }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() {
    window.reset();
    test::clearSettings();
    applyTheme(*qApp, Theme::light);
  }

  void aClickInTheHistoryGoesThere() {
    const MechanismPtr opened = window->document().mechanism();
    for (int i = 0; i < 30; ++i) {
      window->document().apply({QStringLiteral("Add link %1").arg(i),
                                [](const Mechanism& before) {
                                  return withLink(before, CanvasPoint{0, 0});
                                },
                                0});
    }
    press(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    auto* dialog = window->findChild<HistoryDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* list = dialog->findChild<QListView*>(QStringLiteral("historyList"));
    QCOMPARE(list->currentIndex().row(), 30);
    QSignalSpy changed(&window->document(), &Document::changed);
    const QModelIndex third = list->model()->index(3, 0);
    list->scrollTo(third);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(third).center());
    QCOMPARE(changed.count(), 1);
    QCOMPARE(window->document().mechanism()->n(), opened->n() + 3);
    QTest::keyClick(list, Qt::Key_Home);
    QCOMPARE(window->document().mechanism()->n(), opened->n() + 3);  // moving in the list goes nowhere yet
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(*window->document().mechanism(), *opened);
    press(Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(list->currentIndex().row(), 1);
  }

  void newStaysInTheWindowWhereNothingIsDrawn() {
    const QTemporaryDir folder;
    WindowSet windows(folder.path());
    MainWindow& first = windows.openNew();
    const auto addLink = [&first] {
      first.document().apply({QStringLiteral("Add link"),
                              [](const Mechanism& before) {
                                return withLink(before, CanvasPoint{0, 0});
                              },
                              0});
    };
    addLink();
    first.document().apply({QStringLiteral("Delete"),
                            [](const Mechanism& before) {
                              const std::vector<ElementId> last{before.links.back().id};
                              return withoutElements(before, last);
                            },
                            0});
    first.actions()[CommandId::newDocument]->trigger();
    QCOMPARE(windows.windows().size(), std::size_t{1});
    QVERIFY(!first.document().isModified());
    addLink();
    first.actions()[CommandId::newDocument]->trigger();
    QCOMPARE(windows.windows().size(), std::size_t{2});
  }

  void csvIsAskedHowItIsWritten() {
    window->matrices().showResult(resultOf(MatrixKind::cycleBasis));
    press(Qt::Key_E, Qt::ControlModifier);
    QPointer<CsvDialog> dialog = window->findChild<CsvDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QCOMPARE(dialog->options().separator, ',');
    QVERIFY(dialog->options().labels && !dialog->options().byteOrderMark);
    auto* separator = dialog->findChild<QComboBox*>(QStringLiteral("csvSeparator"));
    separator->setFocus();
    QTest::keyClick(separator, Qt::Key_Down);
    auto* labels = dialog->findChild<QCheckBox*>(QStringLiteral("csvLabels"));
    labels->setFocus();
    QTest::keyClick(labels, Qt::Key_Space);
    auto* mark = dialog->findChild<QCheckBox*>(QStringLiteral("csvByteOrderMark"));
    mark->setFocus();
    QTest::keyClick(mark, Qt::Key_Space);
    const CsvOptions chosen = dialog->options();
    QCOMPARE(chosen.separator, ';');
    QVERIFY(!chosen.labels && chosen.byteOrderMark);
    dialog->disconnect(&window->exports());  // the next question is the desktop's
    dialog->accept();
    QTRY_VERIFY(dialog == nullptr);
    const CsvDialog next(QStringLiteral("C"));
    QCOMPARE(next.options().separator, ';');
    QVERIFY(!next.options().labels);

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("C.csv"));
    QSignalSpy written(&window->exports(), &WindowExports::written);
    window->exports().exportCsv(window->matrices().model().table(), path, chosen);
    QTRY_COMPARE(written.count(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.startsWith("\xEF\xBB\xBF"));
    QCOMPARE(text.split('\n').front().mid(3).split(';').size(), 11);  // seven joints, four meshes
  }

  void theDocumentIsPrinted() {
    press(Qt::Key_P, Qt::ControlModifier);
    QTRY_VERIFY(window->findChild<PrintDialog*>() != nullptr);
    auto* dialog = window->findChild<PrintDialog*>();
    QVERIFY(dialog->isVisible());
    QTRY_VERIFY(dialog->isUpToDate());
    QCOMPARE(dialog->pages()->count(), 1);
    QCOMPARE(dialog->pages()->describe(0), QStringLiteral("Digraph"));
    const QTemporaryDir folder;
    dialog->printer()->setOutputFormat(QPrinter::PdfFormat);
    dialog->printer()->setOutputFileName(folder.filePath(QStringLiteral("robot.pdf")));
    QSignalSpy written(&window->exports(), &WindowExports::written);
    emit dialog->printWanted(dialog->pages(), dialog->printer());
    QTRY_COMPARE(written.count(), 1);
    QVERIFY(QFileInfo(folder.filePath(QStringLiteral("robot.pdf"))).size() > 1'000);
  }

  void typeIsAsLargeAsWanted() {
    const int before = window->statusLine().font().pixelSize();
    action("view.typeSize150")->trigger();
    QCOMPARE(bodyPixels(), 20);
    QTRY_VERIFY(QApplication::font().pixelSize() > before);
    QVERIFY(action("view.typeSize150")->isChecked());
    MainWindow next;  // it stays so
    QVERIFY(next.findChild<QAction*>(QStringLiteral("view.typeSize150"))->isChecked());
    action("view.typeSize100")->trigger();
    QCOMPARE(bodyPixels(), 13);
  }

  void noticesAreNeverClipped() {
    window->notices().post(
        {QStringLiteral("key"),
         Severity::warning,
         QStringLiteral("A sentence that is so long that it needs both of its lines. ").repeated(3),
         {{QStringLiteral("Later"), {}, {}}}});
    const auto* text = window->findChild<QLabel*>(QStringLiteral("noticeText"));
    const auto isWhole = [&] {
      const int lines = 2 * text->fontMetrics().lineSpacing();
      return text->isVisible() && text->height() >= lines && window->notices().height() >= lines;
    };
    QTRY_VERIFY(isWhole());
    const int before = text->fontMetrics().lineSpacing();
    window->presentation().setOn(true);
    QTRY_VERIFY(text->fontMetrics().lineSpacing() > before && isWhole());
    window->presentation().setOn(false);
    QTRY_VERIFY(text->fontMetrics().lineSpacing() == before && isWhole());
  }

  void theThemeIsTheSystemsUntilOneIsChosen() {
    QVERIFY(followsSystemTheme());
    QVERIFY(action("view.asSystem")->isChecked());
    action("view.dark")->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::dark);
    QVERIFY(!followsSystemTheme() && !action("view.asSystem")->isChecked());
    QCOMPARE(systemTheme(), Theme::light);
    QCOMPARE(themeOf(QApplication::palette()), Theme::dark);  // asking changes nothing
    QEvent other(QEvent::ThemeChange);
    QCoreApplication::sendEvent(window.get(), &other);
    QCOMPARE(themeOf(QApplication::palette()), Theme::dark);
    action("view.asSystem")->trigger();
    QCOMPARE(themeOf(QApplication::palette()), Theme::light);
    applyTheme(*qApp, Theme::dark);  // as if the system had been dark
    QCoreApplication::sendEvent(window.get(), &other);
    QCOMPARE(themeOf(QApplication::palette()), Theme::light);
  }

  void the3DViewGetsHalfTheWidth() {
    window->resize(1400, 800);
    auto* view = window->findChild<QDockWidget*>(QStringLiteral("dock.view3d"));
    view->hide();
    press(Qt::Key_3, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(view->isVisible());
    QTRY_VERIFY(std::abs(view->width() - window->width() / 2) < 40);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowCommandsTest)
#include "test_window_commands.moc"
