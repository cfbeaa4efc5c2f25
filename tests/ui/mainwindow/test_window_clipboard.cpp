#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QTest>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/status_line.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Cut, copy, paste and duplicate by their keys, in one window and between two.
class WindowClipboardTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  static const MechanismPtr& now(MainWindow& of) { return of.document().mechanism(); }
  const MechanismPtr& now() { return now(*window); }
  static void press(MainWindow& in, Qt::Key key) { QTest::keyClick(&in.digraph(), key, Qt::ControlModifier); }
  static std::unique_ptr<MainWindow> opened(const QString& path) {
    auto made = std::make_unique<MainWindow>();
    if (!path.isEmpty()) made->openDocument(path);
    made->show();
    made->activateWindow();
    [[maybe_unused]] const bool active = QTest::qWaitForWindowActive(made.get());
    made->digraph().setFocus();
    return made;
  }
  [[nodiscard]] QString said() { return window->statusLine().text(); }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    QApplication::clipboard()->clear();
    window = opened(robotExamplePath());
    QTRY_VERIFY(window->isSettled());
  }
  void cleanup() { window.reset(); }

  void copiedLinksBringTheArrowsAmongThem() {
    test::Hand hand(*window);
    window->selection().select({LinkId("1"), LinkId("2"), LinkId("5")});
    press(*window, Qt::Key_C);
    const MechanismPtr before = now();
    press(*window, Qt::Key_V);
    QCOMPARE(now()->n(), 10);
    QCOMPARE(now()->t(), 8);  // 12, from 1 to 2; the joints to the ground stay behind
    QCOMPARE(now()->c(), 5);  // 16, from 5 to 2
    const Link& copy = now()->links.back();
    QCOMPARE(copy.name, before->find(LinkId("5"))->name);
    QVERIFY(before->find(copy.id) == nullptr);
    const CanvasPoint from = before->view.nodes.at(LinkId("5"));
    const CanvasPoint to = now()->view.nodes.at(copy.id);
    QCOMPARE(to.x - from.x, 30.0);
    QCOMPARE(to.y - from.y, 30.0);
    QCOMPARE(window->selection().selected().size(), std::size_t{5});  // the copies, ready to be moved
    QCOMPARE(now()->gearMeshes.back().tailTeeth, 20);
    QCOMPARE(now()->gearMeshes.back().headTeeth, 30);
    press(*window, Qt::Key_V);
    QCOMPARE(now()->view.nodes.at(now()->links.back().id).x, from.x + 60);
    press(*window, Qt::Key_Z);
    press(*window, Qt::Key_Z);
    QCOMPARE(*now(), *before);
  }

  void theWholeRobotTravelsToAnotherWindow() {
    press(*window, Qt::Key_A);
    press(*window, Qt::Key_C);
    const std::unique_ptr<MainWindow> other = opened({});
    press(*other, Qt::Key_V);
    Mechanism expected = *now();
    const Mechanism& there = *now(*other);
    QCOMPARE(there.links, expected.links);
    QCOMPARE(there.turningJoints, expected.turningJoints);
    QCOMPARE(there.gearMeshes, expected.gearMeshes);
    QCOMPARE(there.axes, expected.axes);
    QCOMPARE(there.inputs, expected.inputs);
    expected.view.nodes.erase(LinkId("0"));  // the ground is the other window's own
    for (const auto& [link, point] : expected.view.nodes) QCOMPARE(there.view.nodes.at(link), point);
  }

  void itTravelsAsTextToo() {
    window->selection().select({LinkId("3")});
    press(*window, Qt::Key_C);
    const QString text = QApplication::clipboard()->text();
    QVERIFY(readMechanism(text.toStdString()));
    QApplication::clipboard()->setText(text);  // by way of a text editor
    press(*window, Qt::Key_V);
    QCOMPARE(now()->n(), 8);
    QCOMPARE(now()->links.back().name, std::string("end-effector"));
  }

  void thePictureOfWhatIsCopiedLiesBesideIt() {
    const auto pixelsOf = [] {
      return QApplication::clipboard()->mimeData()->imageData().value<QImage>().size();
    };
    const auto has = [](const char* format) {
      return QApplication::clipboard()->mimeData()->hasFormat(QLatin1String(format));
    };
    window->selection().select({LinkId("1"), LinkId("2"), LinkId("5")});
    press(*window, Qt::Key_C);
    QVERIFY(has("application/x-geargraph+json"));  // at once
    QTRY_VERIFY(has("image/svg+xml") && has("image/png"));
    QVERIFY(has("application/x-geargraph+json"));
    const QByteArray svg = QApplication::clipboard()->mimeData()->data(QStringLiteral("image/svg+xml"));
    QVERIFY(svg.contains("data-id=\"12\""));  // the joint between two of them
    QVERIFY(!svg.contains("data-id=\"3\""));  // another link
    const QSize part = pixelsOf();
    QVERIFY(!part.isEmpty());
    press(*window, Qt::Key_V);
    QCOMPARE(now()->n(), 10);

    press(*window, Qt::Key_A);
    press(*window, Qt::Key_C);
    QTRY_VERIFY(pixelsOf().width() > part.width());
  }

  void drawingsAndThe3DViewAreCopiedAsPictures() {
    const auto* content = QApplication::clipboard()->mimeData();
    window->showDrawing(QStringLiteral("schematic"));
    QTRY_VERIFY(window->isSettled());
    window->drawing().setFocus();
    QTest::keyClick(&window->drawing(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(
        (content = QApplication::clipboard()->mimeData())->hasFormat(QStringLiteral("image/svg+xml")));
    QVERIFY(content->hasImage());
    QVERIFY(readMechanism(content->data(QStringLiteral("application/x-geargraph+json")).toStdString()));
    QVERIFY(!content->hasText());  // a text editor gets nothing that was not asked for

    window->view3d().setFocus();
    QTest::keyClick(&window->view3d(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT((content = QApplication::clipboard()->mimeData())->hasImage() &&
                                 !content->hasFormat(QStringLiteral("image/svg+xml")),
                             20'000);
    QCOMPARE(content->imageData().value<QImage>().size(), QSize(1600, 1000));
  }

  /// Forces are wanted and there are none: the copied picture says why, as the view does.
  void copiedPicturesOfForcesHaveTheirCaption() {
    const auto copied = [&](bool withForces) {
      ViewOptions options = window->view3d().options();
      options.marks.forces = withForces;
      window->view3d().setOptions(options);
      QApplication::clipboard()->clear();
      window->view3d().setFocus();
      QTest::keyClick(&window->view3d(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
      const auto hasImage = [] {
        const QMimeData* content = QApplication::clipboard()->mimeData();
        return content != nullptr && content->hasImage();
      };
      return QTest::qWaitFor(hasImage, 20'000) ? QApplication::clipboard()->image() : QImage();
    };
    QVERIFY(!window->view3d().forcesCaption().isEmpty());
    const QRect corner(0, 0, 800, 200);  // where the caption is
    const QImage plain = copied(false).copy(corner);
    const QImage told = copied(true).copy(corner);
    const QImage again = copied(false).copy(corner);
    QVERIFY(!plain.isNull() && plain == again);
    QVERIFY(plain != told);
  }

  void aPictureThatComesLateTakesNothingAway() {
    press(*window, Qt::Key_A);
    press(*window, Qt::Key_C);
    QApplication::clipboard()->setText(QStringLiteral("another"));
    QTest::qWait(300);
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("another"));
  }

  void everySheetsMenuCopiesItsPicture() {
    for (const char* name : {"digraph", "ttgraph", "schematic"}) {
      window->showDrawing(QLatin1String(name));
      QTRY_VERIFY(window->isSettled());
      const std::unique_ptr<QMenu> menu(window->drawing().contextMenuFor(std::nullopt, {}));
      QApplication::clipboard()->clear();
      for (QAction* action : menu->actions()) {
        if (action->text().remove(QLatin1Char('&')) == QLatin1String("Copy as picture")) action->trigger();
      }
      QTRY_VERIFY(QApplication::clipboard()->mimeData()->hasFormat(QStringLiteral("image/svg+xml")));
    }
  }

  void cutIsOneStep() {
    const MechanismPtr before = now();
    window->selection().select({LinkId("0"), LinkId("3"), JointId("14")});
    press(*window, Qt::Key_X);
    QCOMPARE(now()->n(), 6);
    QCOMPARE(now()->t(), 6);
    press(*window, Qt::Key_V);
    // Joint 14 was selected, so its tail, link 2, came along; the ground is the ground here.
    QCOMPARE(now()->n(), 8);
    QCOMPARE(now()->links.front().id, LinkId("0"));
    press(*window, Qt::Key_Z);
    press(*window, Qt::Key_Z);
    QCOMPARE(*now(), *before);
  }

  void duplicateLeavesTheClipboardAlone() {
    QApplication::clipboard()->setText(QStringLiteral("mine"));
    window->selection().select({LinkId("4")});
    press(*window, Qt::Key_D);
    QCOMPARE(now()->n(), 8);
    QCOMPARE(now()->links.back().name, now()->find(LinkId("4"))->name);
    QCOMPARE(window->document().undoStack().undoText(), QString("Duplicate"));
    QCOMPARE(QApplication::clipboard()->text(), QString("mine"));
  }

  /// What takes long goes in beside the window, and is one step as well.
  void aLargeTrainIsDuplicatedBesideTheWindow() {
    window->document().replace(test::randomTrain(3, 1100, 300), {});
    QTRY_VERIFY(window->isSettled());
    const MechanismPtr before = now();
    press(*window, Qt::Key_A);
    press(*window, Qt::Key_D);
    QCOMPARE(now(), before);  // not yet
    QTRY_COMPARE(now()->n(), 2 * before->n());
    QCOMPARE(window->document().undoStack().count(), 1);
    QTRY_COMPARE(window->selection().selected().size(), std::size_t(before->n() + before->t() + before->c()));
    QVERIFY(window->selection().isSelected(now()->links.back().id));
    QVERIFY(!window->selection().isSelected(before->links.back().id));
    window->document().undoStack().undo();
    QCOMPARE(*now(), *before);
  }

  void aLargeTrainIsPastedBesideTheWindow() {
    const Mechanism train = test::randomTrain(3, 1100, 300);
    QApplication::clipboard()->setText(QString::fromStdString(writeMechanism(train)));
    const MechanismPtr before = now();
    press(*window, Qt::Key_V);
    QCOMPARE(now(), before);  // not yet
    QTRY_COMPARE(now()->n(), before->n() + train.n());
    QCOMPARE(window->document().undoStack().count(), 1);
    QTRY_VERIFY(window->selection().isSelected(now()->links.back().id));
    QVERIFY(!window->selection().isSelected(before->links.back().id));
  }

  void inputsComeWithTheirJoints() {
    window->selection().select({JointId("8")});
    press(*window, Qt::Key_D);
    QCOMPARE(now()->inputs->size(), std::size_t{4});
    QCOMPARE(now()->inputs->back().joint, now()->turningJoints.back().id);
    QCOMPARE(now()->turningJoints.back().tail, LinkId("0"));
    QVERIFY(now()->find(now()->turningJoints.back().axis) != nullptr);
  }

  void garbageIsSaidAndNothingIsLost_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    QTest::newRow("empty") << ""
                           << "The clipboard";
    QTest::newRow("blanks") << "  \n "
                            << "holds no links.";
    QTest::newRow("prose") << "Dear Sir"
                           << "holds no links: ";
    QTest::newRow("cut off") << "{\"format\": \"geargraph\", \"links\": ["
                             << "holds no links: ";
    QTest::newRow("other json") << "{\"a\": 1}"
                                << "holds no links: ";
    QTest::newRow("the ground alone")
        << QString::fromStdString(writeMechanism(emptyMechanism())) << "no link or note in what was copied";
    QTest::newRow("bad reference")
        << R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "1"}], "axes": [],
              "turningJoints": [{"id": "2", "tail": "0", "head": "7", "axis": "z"}], "gearMeshes": []})"
        << "holds no links: ";
  }
  void garbageIsSaidAndNothingIsLost() {
    QFETCH(QString, text);
    QFETCH(QString, reason);
    const MechanismPtr before = now();
    const std::set<ElementId> selected{LinkId("4")};
    window->selection().select(selected);
    QApplication::clipboard()->setText(text);
    press(*window, Qt::Key_V);
    QCOMPARE(now().get(), before.get());
    QCOMPARE(window->document().undoStack().count(), 0);
    QCOMPARE(window->selection().selected(), selected);
    QVERIFY2(said().contains(reason), qPrintable(said()));
  }

  /// What is long is read beside the window.
  void longGarbageIsSaidToo() {
    const MechanismPtr before = now();
    QApplication::clipboard()->setText(QStringLiteral("Dear Sir, ").repeated(30'000));
    press(*window, Qt::Key_V);
    QTRY_VERIFY2(said().contains("holds no links: "), qPrintable(said()));
    QCOMPARE(now().get(), before.get());
    QCOMPARE(window->document().undoStack().count(), 0);
  }

  void binaryGarbageUnderOurOwnNameIsRejected() {
    auto* data = new QMimeData;
    data->setData(QStringLiteral("application/x-geargraph+json"), QByteArray("\xff\x00{]", 4));
    QApplication::clipboard()->setMimeData(data);
    press(*window, Qt::Key_V);
    QCOMPARE(window->document().undoStack().count(), 0);
    QVERIFY2(said().contains("holds no links"), qPrintable(said()));
  }

  void theGroundAloneIsNotCopied() {
    window->selection().select({LinkId("0")});
    QVERIFY(!window->actions()[CommandId::copy]->isEnabled());
    QCOMPARE(window->actions()[CommandId::copy]->toolTip(),
             QString("There is one ground in every document."));
  }

  void idsOfOnesOwnKeepTheirWord() {
    Mechanism with = *now();
    with.wheels.push_back({WheelId("pinion"), LinkId("4"), {}, {}, {}, {}});
    with.gearMeshes[0].tailWheel = WheelId("pinion");
    with.couplings.push_back({ShiftElementId("brake"), ShiftElementKind::brake, {LinkId("4")}, {}});
    const Mechanism fragment = fragmentOf(with, {MeshId("15")});
    const Mechanism twice = *withFragment(*withFragment(with, fragment), fragment);
    QCOMPARE(twice.wheels.size(), std::size_t{3});
    QCOMPARE(twice.wheels[1].id, WheelId("pinion-2"));
    QCOMPARE(twice.wheels[2].id, WheelId("pinion-3"));
    QCOMPARE(twice.gearMeshes.back().tailWheel, std::optional(WheelId("pinion-3")));
    QCOMPARE(twice.wheels[2].link, twice.gearMeshes.back().tail);
    QCOMPARE(twice.couplings[1].id, ShiftElementId("brake-2"));
    QVERIFY(readMechanism(writeMechanism(twice)).value() == twice);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowClipboardTest)
#include "test_window_clipboard.moc"
