#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <set>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/motion_plot.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

MechanismScenePtr turningToy() {
  auto stage = std::make_shared<MechanismScene>(*test::toyStage());
  stage->joints = {{JointId("4"), "4", Rgb::fromHex(0x0072B2), {1}},
                   {JointId("5"), "5", Rgb::fromHex(0xD55E00), {-1}}};
  stage->twists = [](std::span<const double> angles, std::span<const double> speeds,
                     std::span<Twist3> twists) {
    twists[0].angular = {0, 0, speeds[0]};
    twists[0].linear = twists[0].angular.cross(Eigen::Vector3d(0, 22, 0));
    twists[1].angular = {0, 0, -speeds[0]};
    twists[2].linear = {0, 10 * std::cos(angles[0]) * speeds[0], 0};
  };
  return stage;
}

CurveSheet sineSheet() {
  CurveSheet sheet{"Angular speed", "rad/s", {}, {{"link 1", Rgb::fromHex(0x0072B2), false, {}}}};
  for (int i = 0; i <= 100; ++i) {
    sheet.times.push_back(0.1 * i);
    sheet.curves[0].values.push_back(3 * std::sin(0.1 * i));
  }
  return sheet;
}

void wheel(QWidget& on, const QPointF& at, int delta, Qt::KeyboardModifiers keys = Qt::NoModifier) {
  QWheelEvent event(at, on.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&on, &event);
}

}  // namespace

class MotionPlotTest : public QObject {
  Q_OBJECT

 private slots:
  void ticksReadWellAndLieInside() {
    QCOMPARE(niceTicks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    QCOMPARE(niceTicks(-0.3, 0.3, 3).size(), std::size_t{3});
    for (const double tick : niceTicks(1234.5, 1234.9, 6)) QVERIFY(tick >= 1234.49 && tick <= 1234.91);
  }

  void theWheelZoomsAtThePointerAndADoubleClickShowsAll() {
    MotionPlot plot;
    plot.resize(600, 200);
    plot.setSheet(sineSheet());
    plot.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    const QPointF at = plot.area().center() + QPointF(40, 0);
    const double time = plot.timeAt(at.x());
    wheel(plot, at, 240);
    QVERIFY(plot.times().size() < 7);
    QVERIFY(std::abs(plot.timeAt(at.x()) - time) < 1e-9);
    const double tall = plot.values().size();
    wheel(plot, at, 120, Qt::ControlModifier);
    QVERIFY(plot.values().size() < tall);
    const double low = plot.times().low;
    QTest::mousePress(&plot, Qt::LeftButton, {}, at.toPoint());
    QTest::mouseMove(&plot, at.toPoint() - QPoint(50, 0));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, at.toPoint() - QPoint(50, 0));
    QVERIFY(plot.times().low > low);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, at.toPoint());
    QCOMPARE(plot.times().low, 0.0);
    QCOMPARE(plot.times().high, 10.0);
    for (int i = 0; i < 100; ++i) wheel(plot, at, -120);
    QCOMPARE(plot.times().high, 10.0);  // never farther than all
  }

  void whilePlayingOnlyTheMomentIsPainted() {
    MotionPlot plot;
    plot.resize(600, 200);
    plot.setSheet(sineSheet());
    const QImage before = plot.grab().toImage();
    const qint64 kept = plot.pictureKey();
    plot.setTime(4);
    const QImage after = plot.grab().toImage();
    QCOMPARE(plot.pictureKey(), kept);
    QVERIFY(before != after);  // the moment has moved
    wheel(plot, plot.area().center(), 240);
    (void)plot.grab();
    QVERIFY(plot.pictureKey() != kept);
    const qint64 zoomed = plot.pictureKey();
    plot.setSheet(sineSheet());
    (void)plot.grab();
    QVERIFY(plot.pictureKey() != zoomed);
  }

  void aClickGoesToItsTime() {
    MotionPlot plot;
    plot.resize(600, 200);
    plot.setSheet(sineSheet());
    plot.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    QSignalSpy wanted(&plot, &MotionPlot::timeWanted);
    const QPoint at = plot.area().center().toPoint();
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at);
    QCOMPARE(wanted.size(), qsizetype{1});
    QVERIFY(std::abs(wanted.front().front().toDouble() - plot.timeAt(at.x())) < 1e-9);
  }

  void aStraightCurveIsPaintedAsOneLine() {
    std::vector<QPointF> constant;
    std::vector<QPointF> sine;
    for (int i = 0; i <= 2880; ++i) {
      const double x = i / 4.0;
      constant.emplace_back(x, 30);
      sine.emplace_back(x, 40 * std::sin(x / 60));
    }
    QCOMPARE(simplified(constant, 0.2), (std::vector<QPointF>{{0, 30}, {720, 30}}));
    const std::vector<QPointF> few = simplified(sine, 0.2);
    QVERIFY2(few.size() < 200, qPrintable(QString::number(few.size())));
    for (const QPointF& each : sine) {
      const auto after = std::lower_bound(few.begin(), few.end(), each,
                                          [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
      if (after == few.begin()) continue;
      const QPointF& from = *std::prev(after);
      const double along = (each.x() - from.x()) / (after->x() - from.x());
      const double y = from.y() + along * (after->y() - from.y());
      QVERIFY2(std::abs(y - each.y()) <= 0.2 + 1e-9, qPrintable(QString::number(y - each.y())));
    }
  }

  void aCurveOfManyTurnsIsPaintedPlainly() {
    const auto colorsOf = [](const CurveSheet& sheet) {
      MotionPlot plot;
      plot.resize(600, 200);
      plot.setSheet(sheet);
      const QImage image = plot.grab().toImage();
      std::set<QRgb> colors;
      for (int y = 40; y < 140; ++y) {
        for (int x = 100; x < 300; ++x) colors.insert(image.pixel(x, y));
      }
      return colors.size();
    };
    CurveSheet dense = sineSheet();
    for (std::size_t i = 0; i < dense.times.size(); ++i) dense.curves[0].values[i] = i % 2 == 0 ? 3 : -3;
    QVERIFY(colorsOf(dense) > 20);  // smooth edges
    for (int i = 101; i <= 2000; ++i) {
      dense.times.push_back(0.1 * i);
      dense.curves[0].values.push_back(i % 2 == 0 ? 3 : -3);
    }
    QVERIFY2(colorsOf(dense) < 10, qPrintable(QString::number(colorsOf(dense))));
  }

  void theSelectionAndTheTracesChooseTheCurves() {
    Selection selection;
    View3D view(&selection);
    MotionPanel panel(&selection, &view);
    view.setScene(turningToy());
    QVERIFY(panel.sheets().empty());  // nobody looks
    panel.resize(700, 240);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const auto settle = [&] { QTRY_VERIFY(panel.isUpToDate()); };
    settle();
    QCOMPARE(panel.sheets().front().curves.size(), std::size_t{2});
    selection.select({JointId("5")});
    settle();
    QCOMPARE(panel.sheets().front().curves.size(), std::size_t{1});
    QCOMPARE(panel.sheets().front().curves[0].values.front(), -1.5);
    selection.select({LinkId("2")});
    settle();
    QCOMPARE(panel.sheets().front().curves[0].name, std::string("link 2"));
    view.trace({0, LinkId("1"), {15, -22, 4}});
    settle();
    QCOMPARE(panel.sheets().size(), std::size_t{2});
    QVERIFY(std::abs(panel.sheets()[1].curves[0].values[17] - 15 * 1.5) < 1e-9);
    panel.setComponents(true);
    settle();
    QCOMPARE(panel.sheets()[1].curves.size(), std::size_t{4});
    auto* plot = panel.findChild<MotionPlot*>("motionPlot1");
    QVERIFY(plot->isVisible());
    QTest::mouseClick(plot, Qt::LeftButton, {}, plot->area().center().toPoint());
    QVERIFY(std::abs(view.playback().time() - 2) < 0.05);
    view.setScene(test::toyStage());  // without twists
    settle();
    QVERIFY(panel.sheets().empty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::MotionPlotTest)
#include "test_motion_plot.moc"
