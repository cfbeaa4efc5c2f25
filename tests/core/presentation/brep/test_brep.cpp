#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/worm.h"
#include "core/machine/teeth/worm_cut.h"
#include "core/presentation/brep/body_brep.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/cubic_spline.h"
#include "core/presentation/brep/wheel_brep.h"

using namespace geargraph;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double kNormal = 20 * pi / 180;

GearSpec bevel(int teeth, double coneAngle) {
  GearSpec spec = standardGear(GearKind::bevel, teeth, 2, 8);
  spec.coneAngle = coneAngle;
  return spec;
}

GearSpec dressed(GearSpec spec, double bore) {
  spec.body = GearBody::dressed;
  spec.bore = bore;
  return spec;
}

GearSpec herringbone(GearSpec spec) {
  spec.herringbone = true;
  return spec;
}

std::map<std::string, GearSpec> wheels() {
  return {{"spur", standardGear(GearKind::external, 20, 2, 10)},
          {"few teeth, undercut", standardGear(GearKind::external, 7, 2, 10)},
          {"with windows", dressed(standardGear(GearKind::external, 60, 2, 20), 10)},
          {"helical", helical(standardGear(GearKind::external, 30, 2, 20), 0.35)},
          {"herringbone", herringbone(helical(standardGear(GearKind::external, 30, 2, 20), -0.35))},
          {"steep helix", helical(standardGear(GearKind::external, 3, 2, 100), 1.2)},
          {"ring", standardGear(GearKind::internal, 60, 2, 10)},
          {"helical ring", helical(standardGear(GearKind::internal, 60, 2, 10), -0.3)},
          {"bevel", dressed(bevel(21, 0.6), 6)},
          {"crown", bevel(30, pi / 2)},
          {"internal cone", bevel(40, 2)},
          {"pulley", standardGear(GearKind::pulley, 20, 2, 8)},
          {"worm", wormSpec(1, 2, 10, 1, kNormal, 40)},
          {"worm of three starts", wormSpec(3, 3, 22, -1, kNormal, 60)},
          {"worm wheel", dressed(wormWheelSpec(40, 1, 2, 10, 1, kNormal, 17), 12)}};
}

/// The point of a patch at shares of both of its directions.
Vector3d pointOf(const SplineSurface& patch, double u, double v) {
  const auto width = static_cast<Eigen::Index>(patch.uKnots.size() + 2);
  MatrixXd poles(3 * width, static_cast<Eigen::Index>(patch.poles.size()) / width);
  for (std::size_t i = 0; i < patch.poles.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    poles.block<3, 1>(3 * (at % width), at / width) = patch.poles[i];
  }
  const auto within = [](const std::vector<double>& knots, double share) {
    return knots.front() + share * (knots.back() - knots.front());
  };
  const Eigen::VectorXd row = patch.isRuled ? Eigen::VectorXd((1 - v) * poles.col(0) + v * poles.col(1))
                                            : splinePoint(patch.vKnots, poles, within(patch.vKnots, v));
  return splinePoint(patch.uKnots, row.reshaped(3, width), within(patch.uKnots, u));
}

double distanceTo(const std::vector<Vector2d>& line, const Vector2d& point) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d way = line[i + 1] - line[i];
    const double length = way.squaredNorm();
    const double part = length > 0 ? std::clamp((point - line[i]).dot(way) / length, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (line[i] + part * way - point).norm());
  }
  return nearest;
}

/// Angle against the middle of the nearest tooth.
double inTooth(double angle, int teeth) {
  const double pitch = 2 * pi / teeth;
  return angle - pitch * std::round(angle / pitch);
}

/// How far a point is from the exact teeth, a length.
double offTeeth(const GearSpec& spec, const std::vector<Vector2d>& profile, const Vector3d& point) {
  if (isConical(spec)) {  // on the sphere about the apex
    const double colatitude = std::atan2(std::hypot(point.x(), point.y()), point.z());
    const double gam = std::abs(inTooth(std::atan2(point.y(), point.x()), spec.teeth));
    return point.norm() * distanceTo(profile, {colatitude, gam * std::sin(colatitude)});
  }
  const double angle = std::atan2(point.y(), point.x()) - twistOf(spec, point.z());
  const double radius = std::hypot(point.x(), point.y());
  const double gam = std::abs(inTooth(angle, spec.teeth));
  return distanceTo(profile, {radius * std::cos(gam), radius * std::sin(gam)});
}

std::vector<Vector2d> exactProfile(const GearSpec& spec) {
  std::vector<Vector2d> line;
  for (const ProfilePoint& p : toothOf(spec, 1e-7).points) {
    line.push_back(isConical(spec) ? Vector2d(p.rad, p.gam * std::sin(p.rad))
                                   : spec.module * p.rad * Vector2d(std::cos(p.gam), std::sin(p.gam)));
  }
  return line;
}

/// The outline of a worm wheel's tooth and the spaces beside it, in a section.
std::vector<Vector2d> exactThroat(const GearSpec& spec, const WormCut& cut, double height) {
  constexpr int kPoints = 600;
  const double half = pi / spec.teeth, root = cut.root(height).radius, tip = cut.tip(height).radius;
  const auto at = [](double radius, double angle) -> Vector2d {
    return radius * Vector2d(std::cos(angle), std::sin(angle));
  };
  std::vector<Vector2d> line{at(root, -half)};
  const auto share = [](int i) { return std::pow(static_cast<double>(i) / kPoints, 2); };
  for (int i = 0; i <= kPoints; ++i) {
    const double radius = root + share(i) * (tip - root);
    line.push_back(at(radius, cut.flank(radius, height).angle - half));
  }
  const double land = half - cut.flank(tip, -height).angle, from = cut.flank(tip, height).angle - half;
  for (int i = 1; i < kPoints; ++i) line.push_back(at(tip, from + (land - from) * i / kPoints));
  for (int i = kPoints; i >= 0; --i) {
    const double radius = root + share(i) * (tip - root);
    line.push_back(at(radius, half - cut.flank(radius, -height).angle));
  }
  line.push_back(at(root, half));
  return line;
}

void addWheels() {
  QTest::addColumn<QString>("name");
  for (const auto& [name, spec] : wheels()) QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

GearSpec wheelOfRow() {
  QFETCH(QString, name);
  return wheels().at(name.toStdString());
}

}  // namespace

class BrepTest : public QObject {
  Q_OBJECT

 private slots:
  void wheelsAreClosed_data() { addWheels(); }
  void wheelsAreClosed() {
    const GearSpec spec = wheelOfRow();
    QVERIFY(specDiagnostics(spec).empty());
    for (const double deviation : {1e-3, 1e-4}) {
      const WheelBrep wheel = wheelBrep(spec, deviation);
      const auto flaw = flawOf(wheel.solid);
      QVERIFY2(!flaw, flaw.value_or("").c_str());
      QVERIFY2(wheel.deviation <= deviation * toothSize(spec), std::to_string(wheel.deviation).c_str());
    }
  }

  void splinesKeepTheStatedDeviation_data() { addWheels(); }
  void splinesKeepTheStatedDeviation() {
    const GearSpec spec = wheelOfRow();
    constexpr double kDeviation = 1e-3;
    const WheelBrep wheel = wheelBrep(spec, kDeviation);
    const bool isThroat = spec.kind == GearKind::wormWheel;
    const std::vector<Vector2d> profile =
        isToothed(spec) && !isThroat ? exactProfile(spec) : std::vector<Vector2d>();
    std::map<double, std::vector<Vector2d>> sections;
    int checked = 0;
    double farthest = 0;
    for (std::size_t f = 0; f < wheel.solid.faces.size(); ++f) {
      const auto* patch = std::get_if<SplineSurface>(&wheel.solid.faces[f].surface);
      if (patch == nullptr || (f > 40 && f % 7 != 0)) continue;
      constexpr int kSteps = 9;
      for (int i = 0; i <= kSteps; ++i) {
        for (int k = 0; k <= kSteps; k += isThroat ? 3 : 1) {
          const Vector3d point =
              pointOf(*patch, static_cast<double>(i) / kSteps, static_cast<double>(k) / kSteps);
          double off = 0;
          if (isThroat) {
            auto& section = sections[point.z()];
            if (section.empty()) section = exactThroat(spec, WormCut(spec), point.z());
            const double angle = inTooth(std::atan2(point.y(), point.x()), spec.teeth);
            const double radius = std::hypot(point.x(), point.y());
            off = HUGE_VAL;  // off the mid plane a tooth is not centred on its mark
            for (const int beside : {-1, 0, 1}) {
              const double there = angle + 2 * pi * beside / spec.teeth;
              off = std::min(off, distanceTo(section, {radius * std::cos(there), radius * std::sin(there)}));
            }
          } else {
            off = offTeeth(spec, profile, point);
          }
          farthest = std::max(farthest, off);
          ++checked;
        }
      }
    }
    QCOMPARE(checked > 0, isToothed(spec));
    QVERIFY2(farthest <= kDeviation * toothSize(spec), std::to_string(farthest / toothSize(spec)).c_str());
  }

  /// Cylinders, cones and planes are what the solid says they are: edges of arcs and lines lie on them.
  void straightAndRoundEdgesLieOnTheirFaces_data() { addWheels(); }
  void straightAndRoundEdgesLieOnTheirFaces() {
    const Brep solid = wheelBrep(wheelOfRow(), 1e-3).solid;
    for (const BrepFace& face : solid.faces) {
      for (const auto& loop : face.loops) {
        for (const LoopEdge& each : loop) {
          const BrepEdge& edge = solid.edges[static_cast<std::size_t>(each.edge)];
          for (const int end : {edge.from, edge.to}) {
            const Vector3d& point = solid.points[static_cast<std::size_t>(end)];
            if (const auto* plane = std::get_if<PlaneSurface>(&face.surface)) {
              QVERIFY(std::abs((point - plane->origin).dot(plane->normal)) < 1e-9);
            } else if (const auto* round = std::get_if<RoundSurface>(&face.surface)) {
              const double height = (point - round->origin).dot(round->axis);
              const double radius = (point - round->origin - height * round->axis).norm();
              QVERIFY(std::abs(radius - round->radius - round->slope * height) < 1e-9);
            }
          }
        }
      }
    }
  }

  void aSplineGoesThroughItsPoints() {
    const std::vector<double> knots{0, 0.5, 2, 2.5, 4};
    MatrixXd points(1, 5);
    const auto cubic = [](double t) { return 2 - t + 3 * t * t - 0.5 * t * t * t; };
    for (Eigen::Index i = 0; i < 5; ++i) points(0, i) = cubic(knots[static_cast<std::size_t>(i)]);
    // A cubic is its own spline, also by slopes that are estimated from four points.
    const EndSlopes slopes = estimatedSlopes(knots, points);
    QVERIFY(std::abs(slopes.first(0) - -1) < 1e-12);
    QVERIFY(std::abs(slopes.last(0) - (-1 + 6 * 4 - 1.5 * 16)) < 1e-11);
    const MatrixXd poles = splinePoles(knots, points, slopes.first, slopes.last);
    for (double t = 0; t <= 4; t += 0.125)
      QVERIFY(std::abs(splinePoint(knots, poles, t)(0) - cubic(t)) < 1e-11);
    // Two points are enough.
    const std::vector<double> two{1, 3};
    const MatrixXd ends = (MatrixXd(1, 2) << cubic(1), cubic(3)).finished();
    const auto slope = [](double t) { return Eigen::VectorXd::Constant(1, -1 + 6 * t - 1.5 * t * t); };
    const MatrixXd single = splinePoles(two, ends, slope(1), slope(3));
    QVERIFY(std::abs(splinePoint(two, single, 2.2)(0) - cubic(2.2)) < 1e-12);
  }

  void bodiesAreClosed_data() {
    QTest::addColumn<int>("kind");
    for (int i = 0; i < 8; ++i) QTest::addRow("%d", i) << i;
  }
  void bodiesAreClosed() {
    QFETCH(int, kind);
    const Boss hub{{0, 0}, 8, 4};
    const Boss near{{30, 5}, 5, 2}, left{{-20, 25}, 5, 2}, right{{-20, -25}, 4, 0};
    const std::vector<BodyRecipe> recipes{
        {BodyPart{TubePart{10, 4, 0, 20}}, BodyPart{TubePart{3, 0, 0, 20}}},
        {BodyPart{BarPart{10, 8, 0, 20, 0.3}}, BodyPart{BarPart{10, 8, 0, 20, 2.9}}},
        {BodyPart{SpiderPart{hub, {near}, 0, 4}}},
        {BodyPart{SpiderPart{hub, {near, left, right}, 0, 4}}},
        {BodyPart{
            SpiderPart{hub, {near, Boss{{30, -4}, 5, 2}}, 0, 4}}},  // too near to each other for one piece
        {BodyPart{SpiderPart{hub, {Boss{{1, 0}, 2, 0}}, 0, 4}}},    // in the hub
        {BodyPart{PlatePart{
            {{{0, 0}, 3, 0}, {{30, 0}, 5, 0}, {{30, 30}, 3, 0}, {{0, 30}, 3, 0}, {{10, 10}, 3, 0}}, 0, 4}}},
        {BodyPart{PlatePart{{{{2, 1}, 3, 0}}, 0, 4}}}};
    const std::vector<Brep> solids = bodyBreps(recipes[static_cast<std::size_t>(kind)]);
    QVERIFY(!solids.empty());
    for (const Brep& solid : solids) {
      const auto flaw = flawOf(solid);
      QVERIFY2(!flaw, flaw.value_or("").c_str());
    }
  }

  void thePlateIsTheHullOfItsCorners() {
    const std::vector<Boss> corners{
        {{0, 0}, 3, 0}, {{30, 0}, 5, 0}, {{30, 30}, 3, 0}, {{0, 30}, 3, 0}, {{10, 10}, 3, 0}};
    const FlatShape shape = plateShape(corners, 0, 1);
    QCOMPARE(shape.outline.size(), std::size_t{4});  // the fifth is inside
    for (std::size_t i = 0; i < shape.outline.size(); ++i) {
      const PlanarArc &arc = shape.outline[i], &next = shape.outline[(i + 1) % 4];
      const Vector2d way = next.at(next.from) - arc.at(arc.to);
      const Vector2d out(std::cos(arc.to), std::sin(arc.to));
      QVERIFY(std::abs(way.normalized().dot(out)) < 1e-9);  // tangent to both
      for (const Boss& corner : corners)
        QVERIFY((corner.centre - arc.at(arc.to)).dot(out) + corner.radius < 1e-9);  // nothing is outside
    }
  }

  void bytesComeBack() {
    CadAssembly assembly{"Name äß", "text", "program", {}, {}};
    assembly.parts.push_back({"wheel", {0.25F, 0.5F, 1}, {wheelBrep(wheels().at("helical"), 1e-3).solid}});
    assembly.parts.push_back({"cone", {0, 0, 0}, {wheelBrep(wheels().at("bevel"), 1e-3).solid}});
    CadNode link{"link", Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3)), -1, -1};
    assembly.nodes = {link, {"part", Eigen::Isometry3d::Identity(), 0, 1}};
    const std::string bytes = packedAssembly(assembly);
    const auto back = unpackedAssembly(bytes);
    QVERIFY(back.has_value());
    QCOMPARE(packedAssembly(*back), bytes);
    QCOMPARE(back->parts[1].solids[0].faces.size(), assembly.parts[1].solids[0].faces.size());
    QCOMPARE(back->name, assembly.name);
    QCOMPARE(back->nodes[1].parent, 0);
    QVERIFY(back->nodes[0].pose.isApprox(link.pose) && back->parts[0].colour == assembly.parts[0].colour);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97)
      QVERIFY(!unpackedAssembly(std::string_view(bytes).substr(0, size)));
    QVERIFY(!unpackedAssembly(bytes + ' '));
    CadAssembly open = assembly;
    open.parts[0].solids[0].faces.pop_back();
    QVERIFY(flawOf(open.parts[0].solids[0]).has_value());
    QVERIFY(!unpackedAssembly(packedAssembly(open)));
    open = assembly;
    open.nodes[1].part = 2;
    QVERIFY(!unpackedAssembly(packedAssembly(open)));
  }
};

QTEST_GUILESS_MAIN(BrepTest)
#include "test_brep.moc"
