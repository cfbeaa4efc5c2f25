#include <QTest>
#include <algorithm>

#include "core/presentation/drawing/curve_chart.h"

namespace geargraph {

/// Curves as a drawing that can be read in print, too.
class CurveChartTest : public QObject {
  Q_OBJECT

  static CurveChart chart(const std::string& title, double steepness) {
    CurveChart made{title, "moving links", {{"Inverse and product", {}}, {"Substitution", {}}}};
    for (const double x : {2.0, 7.0, 30.0}) {
      made.curves[0].points.push_back({x, steepness * x * x});
      made.curves[1].points.push_back({x, steepness * x});
    }
    return made;
  }
  template <class What>
  static std::vector<What> all(const DisplayList& list) {
    std::vector<What> found;
    for (const Mark& mark : list.marks) {
      if (const auto* what = std::get_if<What>(&mark.what)) found.push_back(*what);
    }
    return found;
  }
  static bool overlap(const Extent& a, const Extent& b) {
    return std::abs(a.center.x - b.center.x) < a.halfWidth + b.halfWidth &&
           std::abs(a.center.y - b.center.y) < a.halfHeight + b.halfHeight;
  }

 private slots:
  void ticksAreRound() {
    QCOMPARE(tickStep(10, 5), 2.0);
    QCOMPARE(tickStep(100, 4), 50.0);
    QCOMPARE(tickStep(1, 1), 1.0);
    QCOMPARE(tickStep(30, 5), 10.0);
    for (double most = 1; most < 1e6; most *= 1.37) {
      for (const int parts : {2, 4, 5, 9}) {
        const double step = tickStep(most, parts);
        QVERIFY(most / step <= parts);
        QVERIFY(most / step > parts / 2.5 - 1e-9);
      }
    }
  }

  /// Every point at its place: from 0 in the corner to the largest value at the end of each axis.
  void pointsAreWhereTheirNumbersSay() {
    const DisplayList list = chartDrawing({chart("one", 1)});
    std::vector<Polyline> curves;
    for (const Stroke& stroke : all<Stroke>(list)) {
      const auto* line = std::get_if<Polyline>(&stroke.shape);
      if (line != nullptr && stroke.tint.link && line->points.size() == 3) curves.push_back(*line);
    }
    QCOMPARE(curves.size(), std::size_t{2});
    const CanvasPoint end = curves[0].points.back();
    QVERIFY(end.x > 0 && end.y < 0);
    for (const auto& [curve, power] : {std::pair{0, 2}, std::pair{1, 1}}) {
      const auto& points = curves[static_cast<std::size_t>(curve)].points;
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = std::array{2.0, 7.0, 30.0}[i];
        QVERIFY(std::abs(points[i].x - end.x * x / 30) < 1e-9);
        QVERIFY(std::abs(points[i].y - end.y * std::pow(x, power) / 900) < 1e-9);
      }
    }
  }

  void noTextLiesOnAnother() {
    const DisplayList list = chartDrawing({chart("chain", 1), chart("stack", 17), chart("wrist", 1234)});
    std::vector<Extent> texts;
    for (const Mark& mark : list.marks) {
      if (std::holds_alternative<Text>(mark.what)) texts.push_back(extentOf(mark));
    }
    QVERIFY(texts.size() > 25);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) QVERIFY(!overlap(texts[i], texts[j]));
    }
  }

  void theLegendNamesEachCurveOnce() {
    const DisplayList list = chartDrawing({chart("chain", 1), chart("stack", 2)});
    const auto texts = all<Text>(list);
    for (const char* name : {"Inverse and product", "Substitution"}) {
      QCOMPARE(std::count_if(texts.begin(), texts.end(), [&](const Text& text) { return text.text == name; }),
               1);
    }
    QVERIFY(chartDrawing({}).marks.empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::CurveChartTest)
#include "test_curve_chart.moc"
