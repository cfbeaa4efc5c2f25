#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QTest>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/scene/render_style.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/view3d/measure_layer.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/measured_ink.h"
#include "ui/workbench/measuring.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

/// Measuring in drawings and in the 3D view of a window, by mouse and by keys.
class MeasuringTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  Measuring& measuring() { return window->workbench().measuring(); }
  const Mechanism& now() { return *window->document().mechanism(); }
  QAction& tool() { return *window->actions().tool[static_cast<std::size_t>(ToolKind::measure)]; }
  [[nodiscard]] QString said() { return window->statusLine().text(); }

  void open(const char* example) {
    window = test::openedWindow(QStringLiteral(":/examples/%1.geargraph").arg(QLatin1String(example)));
    QVERIFY(window != nullptr);
    QTRY_VERIFY(window->isSettled());
  }
  /// The spur pair's centre distance as the document has it.
  QString centres() {
    const double distance = axisReach(window->document().placed(), now().axes[1].id)->distance;
    return QStringLiteral("centre distance %1 mm").arg(distance);
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void cleanup() { window.reset(); }

  void aKeyTakesTheToolAndTwoClicksMeasure() {
    open("spur-pair");
    window->digraph().setFocus();
    QTest::keyClick(&window->digraph(), Qt::Key_M);
    QVERIFY(tool().isChecked() && measuring().isOn());
    QVERIFY(said().contains(QStringLiteral("click an axis")));
    test::Hand hand(*window);
    hand.press(1);
    hand.release(1);
    QCOMPARE(measuring().taken().size(), std::size_t{1});
    QVERIFY(measuring().lines().front().startsWith(QStringLiteral("pitch diameter ")));
    QVERIFY(said().contains(QStringLiteral("centre of gear 1")));
    hand.press(2);
    hand.release(2);
    QVERIFY2(measuring().lines().contains(centres()), qPrintable(measuring().lines().join(u'|')));
    QVERIFY(window->selection().selected().empty());  // measuring selects nothing
  }

  void keysWalkTakeAndGoBack() {
    open("spur-pair");
    tool().trigger();
    DrawingView& drawing = window->drawing();
    window->selection().select({now().turningJoints[0].id});
    QTest::keyClick(&drawing, Qt::Key_Return);
    window->selection().select({now().turningJoints[1].id});
    QTest::keyClick(&drawing, Qt::Key_Return);
    QCOMPARE(measuring().lines(), QStringList{centres()});
    QTest::keyClick(&drawing, Qt::Key_Escape);
    QCOMPARE(measuring().taken().size(), std::size_t{1});
    QTest::keyClick(&drawing, Qt::Key_Escape);
    QVERIFY(measuring().taken().empty() && measuring().isOn());
    QTest::keyClick(&drawing, Qt::Key_Escape);
    QVERIFY(!measuring().isOn());
    QVERIFY(drawing.tool() == ToolKind::select && !tool().isChecked());
  }

  void theResultIsCopied() {
    open("spur-pair");
    window->selection().clear();
    QAction& copy = *window->actions()[CommandId::copy];
    QVERIFY(!copy.isEnabled());
    tool().trigger();
    measuring().take(now().turningJoints[0].id);
    QVERIFY(!copy.isEnabled());  // an axis alone measures nothing
    measuring().take(now().turningJoints[1].id);
    QVERIFY(copy.isEnabled());
    copy.trigger();
    const QString axes = QStringLiteral("axis %1 – axis %2: ")
                             .arg(QString::fromStdString(now().axes[0].id.text()),
                                  QString::fromStdString(now().axes[1].id.text()));
    QCOMPARE(QApplication::clipboard()->text(), axes + centres());
  }

  void anEditIsMeasuredAnew() {
    open("spur-pair");
    tool().trigger();
    measuring().take(now().turningJoints[0].id);
    measuring().take(now().turningJoints[1].id);
    const QString before = centres();
    const MeshId mesh = now().gearMeshes[0].id;
    const int tail = now().gearMeshes[0].tailTeeth + 8, head = now().gearMeshes[0].headTeeth;
    QVERIFY(window->document().apply({QStringLiteral("teeth"), [=](const PlacedMechanism& placed) {
                                        return withTeethFitted(placed, mesh, tail, head);
                                      }}));
    QVERIFY(centres() != before);
    QCOMPARE(measuring().lines(), QStringList{centres()});
    window->document().undoStack().undo();
    QCOMPARE(measuring().lines(), QStringList{before});
  }

  void theSchematicKnowsFacesAndTheDigraphSharesWhatWasTaken() {
    open("spur-pair");
    window->showDrawing(QStringLiteral("schematic"));
    auto* schematic = qobject_cast<SchematicView*>(&window->drawing());
    QVERIFY(schematic != nullptr);
    QTRY_VERIFY(schematic->isUpToDate());
    tool().trigger();
    const QPoint axis = schematic->boxOf(now().axes[0].id).center();
    QTest::mouseClick(schematic->viewport(), Qt::LeftButton, {}, axis);
    QCOMPARE(measuring().taken().size(), std::size_t{1});
    const QImage before = schematic->viewport()->grab().toImage();
    window->selection().select({now().gearMeshes[0].id});
    QTest::keyClick(schematic, Qt::Key_Return);
    QVERIFY2(measuring().lines().front().startsWith(QStringLiteral("pitch radius ")),
             qPrintable(measuring().lines().join(u'|')));
    window->selection().clear();
    QVERIFY(schematic->viewport()->grab().toImage() != before);
    window->showDrawing(QStringLiteral("digraph"));
    QCOMPARE(measuring().taken().size(), std::size_t{2});
    QVERIFY(window->digraph().tool() == ToolKind::measure);
  }

  void clicksIn3DSnapToTheNearestSpot() {
    open("spur-pair");
    QTRY_VERIFY(window->view3d().stage() != nullptr && !window->view3d().stage()->labels.empty());
    View3D& view = window->view3d();
    view.showFrom(StandardView::front);
    view.fit();
    tool().trigger();
    auto* viewer = view.findChild<Viewer*>();
    auto* layer = view.findChild<MeasureLayer*>();
    QVERIFY(viewer != nullptr && layer != nullptr);
    const auto onScreen = [&](const Vector3& point) {
      const ScreenPoint at = viewer->camera().project({point[0], point[1], point[2]}, viewer->viewport());
      return QPointF(at.x, at.y) / viewer->pixelRatio();
    };
    const Spot pitch = *measuring().spots().of(now().gearMeshes[0].id);
    const Spot* const found = layer->spotAt(onScreen(pitch.point) + QPointF(2, 2), std::nullopt);
    QVERIFY(found != nullptr && found->kind == Spot::Kind::pitchPoint);
    QCOMPARE(layer->spotAt(QPointF(-1000, -1000), std::nullopt), nullptr);
    // Far from every point a part is measured by the face that was hit.
    const Hit hit{0, now().links[1].id, Eigen::Vector3d(0, 0, 1000)};
    const Spot* const face = layer->spotAt(QPointF(-1000, -1000), hit);
    QVERIFY(face != nullptr && face->isPoint() && face->wheel);
  }

  void the3DViewStandsStillAndTakesKeys() {
    open("spur-pair");
    QTRY_VERIFY(window->view3d().stage() != nullptr && !window->view3d().stage()->labels.empty());
    View3D& view = window->view3d();
    view.playback().setTime(0.3);
    tool().trigger();
    QCOMPARE(view.playback().time(), 0.0);  // what is measured is the reference pose
    const auto layers = view.findChildren<OverlayLayer*>();
    QCOMPARE(layers.size(), 2);
    view.select(now().links[1].id);
    QTest::keyClick(&view, Qt::Key_Return);
    view.select(now().links[2].id);
    QTest::keyClick(&view, Qt::Key_Return);
    QVERIFY(measuring().lines().contains(centres()));
    QVERIFY(layers.back()->painting());
    QTest::keyClick(&view, Qt::Key_Escape);
    QTest::keyClick(&view, Qt::Key_Escape);
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(!measuring().isOn() && !layers.back()->painting());
    QVERIFY(window->drawing().tool() == ToolKind::select);
  }

  void allViewsSelectInOneColour() {
    const auto isSame = [](const RenderStyle& style, Theme theme) {
      const Color drawn = colorOf(ColorRole::accent, theme);
      return style.accent ==
             Rgb::fromHex((unsigned{drawn.red} << 16U) | (unsigned{drawn.green} << 8U) | drawn.blue);
    };
    QVERIFY(isSame(RenderStyle::light(), Theme::light));
    QVERIFY(isSame(RenderStyle::dark(), Theme::dark));
    QCOMPARE(measuredInk(false), QColor(0x2A, 0x68, 0xE4));
  }

  void whatHasNoPlaceIsSaid() {
    open("spur-pair");
    tool().trigger();
    QVERIFY(!measuring().take(now().links[0].id));  // the ground has no wheel in it
    QVERIFY(said().contains(QStringLiteral("no place to measure from")));
    QVERIFY(measuring().taken().empty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::MeasuringTest)
#include "test_measuring.moc"
