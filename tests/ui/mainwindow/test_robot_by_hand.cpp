#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/panels/matrices_panel.h"

namespace geargraph {

/// The paper's robot, built from an empty document with the mouse.
class RobotByHandTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;
  MechanismPtr empty;
  const QTemporaryDir folder;

  [[nodiscard]] const MechanismPtr& now() const { return window->document().mechanism(); }

 private slots:
  void initTestCase() {
    test::setUpProgram();
    window = std::make_unique<MainWindow>();
    window->resize(1366, 768);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    window->actions()[CommandId::newDocument]->trigger();
    empty = now();
    test::Hand(*window).drawRobot();
    QCOMPARE(now()->n(), 7);
    QCOMPARE(now()->t(), 7);
    QCOMPARE(now()->c(), 4);
    QTRY_VERIFY(window->isSettled());
  }
  void cleanupTestCase() { window.reset(); }

  void eq01_incidenceMatrixIsShown() {
    QCOMPARE(test::shownRows(*window, MatrixKind::incidence),
             (QStringList{"-1 -1 -1 0 0 0 0 0 0 0 0", "0 0 1 -1 -1 0 0 1 0 0 0", "0 0 0 0 1 -1 -1 0 1 0 0",
                          "0 0 0 0 0 0 1 0 0 0 1", "1 0 0 0 0 0 0 -1 0 0 0", "0 1 0 0 0 0 0 0 -1 0 0",
                          "0 0 0 1 0 0 0 0 0 -1 0", "0 0 0 0 0 1 0 0 0 1 -1"}));
  }

  void eq02_reducedIncidenceMatrixIsShown() {
    QCOMPARE(test::shownRows(*window, MatrixKind::reducedIncidence),
             (QStringList{"0 0 1 -1 -1 0 0 1 0 0 0", "0 0 0 0 1 -1 -1 0 1 0 0", "0 0 0 0 0 0 1 0 0 0 1",
                          "1 0 0 0 0 0 0 -1 0 0 0", "0 1 0 0 0 0 0 0 -1 0 0", "0 0 0 1 0 0 0 0 0 -1 0",
                          "0 0 0 0 0 1 0 0 0 1 -1"}));
    QCOMPARE(window->matrices().model().partition(), 7);
  }

  void eq03_pathMatrixIsShown() {
    QCOMPARE(test::shownRows(*window, MatrixKind::path),
             (QStringList{"0 0 0 -1 0 0 0", "0 0 0 0 -1 0 0", "-1 -1 -1 0 0 -1 -1", "0 0 0 0 0 -1 0",
                          "0 -1 -1 0 0 0 -1", "0 0 0 0 0 0 -1", "0 0 -1 0 0 0 0"}));
  }

  void eq04_spanningTreeMatrixIsShown() {
    QCOMPARE(test::shownRows(*window, MatrixKind::spanningTree),
             (QStringList{"1 0 -1 0 0 0 0", "0 1 -1 0 -1 0 0", "0 0 0 1 -1 -1 0", "0 0 0 0 0 1 -1"}));
  }

  void eq05_cycleBasisMatrixIsShown() {
    QCOMPARE(test::shownRows(*window, MatrixKind::cycleBasis),
             (QStringList{"1 0 -1 0 0 0 0 1 0 0 0", "0 1 -1 0 -1 0 0 0 1 0 0", "0 0 0 1 -1 -1 0 0 0 1 0",
                          "0 0 0 0 0 1 -1 0 0 0 1"}));
    QCOMPARE(window->matrices().model().headerData(1, Qt::Vertical).toString(), QStringLiteral("C16"));
  }

  void everythingIsUndoneAndDoneAgain() {
    const MechanismPtr drawn = now();
    test::Hand hand(*window);
    while (window->actions()[CommandId::undo]->isEnabled()) hand.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now().get(), empty.get());
    QVERIFY(!window->document().isModified());
    for (bool withY = true; window->actions()[CommandId::redo]->isEnabled(); withY = !withY) {
      if (withY) {
        hand.key(Qt::Key_Y, Qt::ControlModifier);
      } else {
        hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
      }
    }
    QCOMPARE(now().get(), drawn.get());
  }

  void savedAndOpenedItIsTheSame() {
    const QString path = folder.filePath(QStringLiteral("robot.geargraph"));
    QVERIFY(window->isWindowModified());
    QVERIFY(window->saveDocument(path));
    QVERIFY(!window->isWindowModified());
    QVERIFY(window->windowTitle().startsWith("robot.geargraph"));
    MainWindow other;
    QVERIFY(other.openDocument(path));
    QVERIFY(*other.document().mechanism() == *now());
  }

  void exportedTableReadsBack() {
    const QStringList rows = test::shownRows(*window, MatrixKind::cycleBasis);
    const QString path = folder.filePath(QStringLiteral("C.csv"));
    QSignalSpy written(&window->exports(), &WindowExports::written);
    window->exports().exportCsv(window->matrices().model().table(), path);
    QVERIFY(written.wait());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), rows.size() + 1);
    QVERIFY(lines.first().endsWith("8,9,10,11,12,13,14,15,16,17,18"));
    for (int i = 0; i < rows.size(); ++i) {
      QStringList fields = lines.at(i + 1).split(QLatin1Char(','));
      QCOMPARE(fields.takeFirst(), QStringLiteral("C%1").arg(15 + i));
      QCOMPARE(fields.join(QLatin1Char(' ')), rows.at(i));
    }
    QVERIFY(window->notices().current() != nullptr);  // it is told above the drawing
    window->notices().withdraw(QString(window->notices().current()->key));
    QTRY_VERIFY(!window->notices().isVisible());
  }

  void theColumnOfAMeshIsShownWhileItIsDrawn() {
    test::Hand hand(*window);
    hand.key(Qt::Key_G);
    const MatrixModel& model = window->matrices().model();
    QCOMPARE(model.columnCount(), 11);
    hand.press(3);
    hand.moveOver(6);
    QCOMPARE(model.columnCount(), 12);
    QVERIFY(model.headerData(11, Qt::Horizontal, MatrixModel::PreviewRole).toBool());
    hand.key(Qt::Key_Escape);
    QCOMPARE(model.columnCount(), 11);
    hand.release(6);
    QCOMPARE(now()->c(), 4);
  }

  void pointingAtALinkLightsItsRow() {
    test::Hand hand(*window);
    window->matrices().showResult(resultOf(MatrixKind::incidence));
    hand.key(Qt::Key_V);
    hand.moveOver(7);
    QCOMPARE(window->selection().hovered(), std::set<ElementId>{now()->links.at(7).id});
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::RobotByHandTest)
#include "test_robot_by_hand.moc"
