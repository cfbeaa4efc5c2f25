#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/dxf/dxf_file.h"
#include "core/presentation/dxf/gear_profile.h"

using namespace geargraph;
using Eigen::Vector2d;

namespace {

std::vector<Vector2d> circlePoints(double radius, double from, double to, int count) {
  std::vector<Vector2d> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// The pieces as many short chords.
std::vector<Vector2d> sampledArcs(const std::vector<ArcVertex>& vertices, bool isClosed, int parts) {
  std::vector<Vector2d> points;
  const std::size_t pieces = isClosed ? vertices.size() : vertices.size() - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    for (int part = 0; part < parts; ++part) {
      const double along = static_cast<double>(part) / parts;
      points.push_back(pointOn(vertices[i], vertices[(i + 1) % vertices.size()].at, along));
    }
  }
  if (!isClosed) points.push_back(vertices.back().at);
  return points;
}

double distanceToChords(const Vector2d& point, const std::vector<Vector2d>& chords) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < chords.size(); ++i) {
    const Vector2d along = chords[i + 1] - chords[i];
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp((point - chords[i]).dot(along) / length, 0.0, 1.0) : 0;
    least = std::min(least, (chords[i] + part * along - point).norm());
  }
  return least;
}

double signedArea(const std::vector<Vector2d>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d& a = points[i];
    const Vector2d& b = points[(i + 1) % points.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

}  // namespace

class DxfTest : public QObject {
  Q_OBJECT

 private slots:
  void circleIsOnePieceInEitherDirection() {
    for (const double end : {2.0, -2.0}) {
      const auto arcs = fittedArcs(circlePoints(3, 0, end, 200), 1e-9);
      QCOMPARE(arcs.size(), std::size_t{2});
      QVERIFY(std::abs(arcs[0].bulge - std::tan(end / 4)) < 1e-9);
      const Vector2d middle = pointOn(arcs[0], arcs[1].at, 0.5);
      QVERIFY((middle - 3 * Vector2d(std::cos(end / 2), std::sin(end / 2))).norm() < 1e-9);
    }
  }

  void lineIsOnePieceAndCornersEndPieces() {
    const std::vector<Vector2d> points = {{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 1}, {2, 3}};
    const auto arcs = fittedArcs(points, 1e-6);
    QCOMPARE(arcs.size(), std::size_t{3});
    QVERIFY(arcs[0].bulge == 0 && arcs[1].bulge == 0);
    QVERIFY(arcs[1].at == Vector2d(2, 0) && arcs[2].at == Vector2d(2, 3));
  }

  void spiralIsWithinItsTolerance() {
    std::vector<Vector2d> points;
    for (int i = 0; i <= 2000; ++i) {
      const double angle = i / 200.0;
      points.emplace_back(angle * std::cos(angle), angle * std::sin(angle));
    }
    std::size_t before = 1000;
    for (const double tolerance : {1e-4, 1e-3, 1e-2}) {
      const auto arcs = fittedArcs(points, tolerance);
      const auto chords = sampledArcs(arcs, false, 400);
      for (std::size_t i = 0; i < points.size(); i += 40)
        QVERIFY(distanceToChords(points[i], chords) < 1.2 * tolerance);
      QVERIFY(arcs.size() < before);
      before = arcs.size();
    }
  }

  void outlinesAreClosedAndNearTheGeneratedTeeth_data() {
    QTest::addColumn<int>("teeth");
    QTest::addColumn<bool>("ring");
    QTest::addColumn<double>("shift");
    QTest::newRow("pinion with undercut") << 9 << false << 0.0;
    QTest::newRow("spur") << 24 << false << 0.3;
    QTest::newRow("large") << 100 << false << 0.0;
    QTest::newRow("ring") << 60 << true << 0.1;
  }
  void outlinesAreClosedAndNearTheGeneratedTeeth() {
    QFETCH(int, teeth);
    QFETCH(bool, ring);
    QFETCH(double, shift);
    GearSpec spec = standardGear(ring ? GearKind::internal : GearKind::external, teeth, 2, 10);
    spec.profileShift = shift;
    const HalfTooth exact = toothOf(spec, 1e-6);
    for (const double deviation : {5e-4, 1e-2}) {
      const auto outline = toothOutline(spec, deviation);
      QCOMPARE(outline.size() % static_cast<std::size_t>(teeth), std::size_t{0});
      const std::size_t perTooth = outline.size() / static_cast<std::size_t>(teeth);
      QVERIFY2(perTooth <= 40, qPrintable(QString::number(perTooth)));
      const auto points = sampledArcs(outline, true, 40);
      // Counter-clockwise, and the teeth take the room between root and tip.
      const double area = signedArea(points);
      const double low = std::min(nominalRootRadius(spec), nominalTipRadius(spec));
      const double high = std::max(nominalRootRadius(spec), nominalTipRadius(spec));
      QVERIFY(area > std::numbers::pi * low * low && area < std::numbers::pi * high * high);
      // Every generated point of tooth 0, on both sides, is near the pieces of that tooth and its neighbours.
      std::vector<Vector2d> near(points.begin(),
                                 points.begin() + static_cast<std::ptrdiff_t>(perTooth * 40 + 1));
      for (std::size_t i = 0; i < exact.points.size(); i += 1 + exact.points.size() / 200) {
        const ProfilePoint& point = exact.points[i];
        for (const int side : {-1, 1}) {
          const Vector2d at =
              spec.module * point.rad * Vector2d(std::cos(point.gam), side * std::sin(point.gam));
          QVERIFY2(distanceToChords(at, near) <= 1.1 * deviation * spec.module,
                   qPrintable(QString::number(distanceToChords(at, near) / spec.module)));
        }
      }
    }
  }

  void bevelsHaveNoPlane() {
    QVERIFY(isDrawnPlane(standardGear(GearKind::external, 20, 1, 5)));
    QVERIFY(isDrawnPlane(standardGear(GearKind::internal, 60, 1, 5)));
    QVERIFY(!isDrawnPlane(standardGear(GearKind::bevel, 20, 1, 5)));
  }

  void unitsAreThoseOfTheHeader() {
    QCOMPARE(dxfUnits(0.001), 4);
    QCOMPARE(dxfUnits(0.01), 5);
    QCOMPARE(dxfUnits(1), 6);
    QCOMPARE(dxfUnits(0.0254), 1);
    QCOMPARE(dxfUnits(0.3048), 2);
    QCOMPARE(dxfUnits(0.123), 0);
    DxfFile file({{"WORDS", 2, false}});
    file.addText(0, {1, 2}, 3, "20\u00b0 m\n");
    const std::string text = file.text(1);
    QVERIFY(text.find("$INSUNITS\n 70\n1\n") != std::string::npos);
    QVERIFY(text.find("20\\U+00B0 m\n") != std::string::npos);
    QVERIFY(text.ends_with("  0\nEOF\n"));
  }
};

QTEST_APPLESS_MAIN(DxfTest)
#include "test_dxf.moc"
