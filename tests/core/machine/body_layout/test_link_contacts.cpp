#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/solid.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

using Corners = std::array<Vector3d, 3>;

/// A closed surface as triangles, with places all over it.
struct Piece {
  std::vector<Corners> triangles;
  std::vector<Vector3d> places;
  Eigen::AlignedBox3d box;
};

/// Places on each triangle, no farther from each other than `spacing` along its edges.
Piece pieceOf(const Solid& solid, const Eigen::Isometry3d& pose, double spacing) {
  Piece piece;
  const auto corner = [&](std::uint32_t i) -> Vector3d {
    const auto& p = solid.positions[i];
    return pose * Vector3d(p[0], p[1], p[2]);
  };
  for (const auto& t : solid.triangles) {
    const Corners triangle{corner(t[0]), corner(t[1]), corner(t[2])};
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, (triangle[(i + 1) % 3] - triangle[i]).norm());
    const int steps = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, 40);
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; i + k <= steps; ++k) {
        const double u = static_cast<double>(i) / steps, v = static_cast<double>(k) / steps;
        piece.places.push_back(triangle[0] + u * (triangle[1] - triangle[0]) +
                               v * (triangle[2] - triangle[0]));
      }
    }
    for (const Vector3d& p : triangle) piece.box.extend(p);
    piece.triangles.push_back(triangle);
  }
  return piece;
}

/// Is a place inside of a closed surface? By the crossings of a ray in a direction that meets no edge.
bool isInside(const Piece& piece, const Vector3d& place) {
  if (!piece.box.contains(place)) return false;
  const Vector3d way = Vector3d(0.5377, 0.2713, 0.7983).normalized();
  int crossings = 0;
  for (const auto& [a, b, c] : piece.triangles) {
    const Vector3d ab = b - a, ac = c - a, across = way.cross(ac);
    const double volume = ab.dot(across);
    if (volume == 0) continue;
    const Vector3d from = place - a, other = from.cross(ab);
    const double u = from.dot(across) / volume, v = way.dot(other) / volume;
    if (u < 0 || v < 0 || u + v > 1) continue;
    crossings += ac.dot(other) / volume > 0;
  }
  return crossings % 2 == 1;
}

/// Do two pieces share room, or does a place of one lie in the other?
bool touch(const Piece& a, const Piece& b) {
  if (a.box.intersection(b.box).isEmpty()) return false;
  const auto reaches = [](const Piece& one, const Piece& other) {
    return std::any_of(one.places.begin(), one.places.end(),
                       [&](const Vector3d& place) { return isInside(other, place); });
  };
  return reaches(a, b) || reaches(b, a);
}

/// The pieces of a link's body and its wheels in the reference pose.
std::vector<Piece> piecesOf(const GearTrain& train, int link) {
  std::vector<Piece> pieces;
  for (const LinkBody& body : train.bodies) {
    if (body.link != link) continue;
    for (const BodyPart& part : *body.recipe)
      pieces.push_back(pieceOf(madeBy({part}, 0.02), Eigen::Isometry3d::Identity(), 0.5 * part.module));
  }
  for (const TrainGear& gear : train.gears) {
    if (gear.link == link)
      pieces.push_back(pieceOf(*gearSolid(gear.spec, kScreenTolerance), gear.pose, 0.5 * gear.spec.module));
  }
  return pieces;
}

/// How many bodies that hang together the pieces make.
int bodiesOf(const std::vector<Piece>& pieces) {
  std::vector<std::size_t> root(pieces.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto rootOf = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t a = 0; a < pieces.size(); ++a) {
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      if (rootOf(a) != rootOf(b) && touch(pieces[a], pieces[b]))
        root[std::max(rootOf(a), rootOf(b))] = std::min(rootOf(a), rootOf(b));
    }
  }
  int bodies = 0;
  for (std::size_t i = 0; i < root.size(); ++i) bodies += root[i] == i;
  return bodies;
}

Solid cylinder(double from, double to) {
  return tube(1, 0, from, to, 0.01);
}

}  // namespace

/// The solids of a link hang together: nothing of it floats.
class LinkContactsTest : public QObject {
  Q_OBJECT
 private slots:
  /// What the walk itself can tell: two cylinders that reach into each other, and two with a gap.
  void piecesTouchWhereTheyReachIntoEachOther() {
    const auto none = Eigen::Isometry3d::Identity();
    const Piece low = pieceOf(cylinder(0, 2), none, 0.2), high = pieceOf(cylinder(1.9, 4), none, 0.2);
    const Piece apart = pieceOf(cylinder(2.1, 4), none, 0.2);
    QVERIFY(touch(low, high) && !touch(low, apart));
    QCOMPARE(bodiesOf({low, high}), 1);
    QCOMPARE(bodiesOf({low, apart, high}), 1);
    QCOMPARE(bodiesOf({low, apart}), 2);
    const Piece inside = pieceOf(tube(0.5, 0, 0.5, 1.5, 0.01), none, 0.2);
    QVERIFY(touch(low, inside));
  }

  /// A standoff reaches into the wall of its boss and leaves the hole free, at any angle, from either side,
  /// thicker or thinner than the boss is.
  void standoffsReachTheBossesThatTheySupport() {
    int standoffs = 0;
    for (const double degrees : {20.0, 35.0, 50.0, 60.0, 75.0, 85.0, 90.0, 120.0}) {
      for (const double module : {0.5, 1.0, 2.0}) {
        for (const double side : {-1.0, 1.0}) {
          Arrangement plan;
          plan.axes.resize(2);
          plan.axes[0].module = module;
          const double angle = degrees * std::numbers::pi / 180;
          plan.axes[1].direction = {0, std::sin(angle), std::cos(angle)};
          plan.shaftsOn.resize(2);
          plan.shaftsOn[1].push_back(0);
          plan.shafts.push_back({1, 2, -100, 100, 0, kShaftRadius});
          const double high = plan.axes[1].at(8).z() + side * 12 * (1 + module);
          const ArmPlan arm{1, 0, high, 1, 8, 2};
          const auto standoff = standoffOf(plan, arm);
          QVERIFY(standoff.has_value());
          const double hole = holeFor(plan, 1, 8, 1);
          const Eigen::Isometry3d line = frameAlong(plan.axes[1].at(8), plan.axes[1].direction);
          const Piece boss = pieceOf(tube(hole + 1, hole, -1.5, 1.5, 0.01), line, 0.1);
          const Piece shaft = pieceOf(tube(hole, 0, -50, 50, 0.01), line, 0.5);
          const Piece bar = pieceOf(tube(standoff->radius, 0, 0, standoff->reach, 0.01),
                                    frameAlong(standoff->foot, standoff->way), 0.1);
          QVERIFY2(touch(boss, bar), qPrintable(QString("%1, module %2").arg(degrees).arg(module)));
          QVERIFY2(!touch(shaft, bar), qPrintable(QString("%1, module %2").arg(degrees).arg(module)));
          const Boss end = endOf(plan, arm);
          QVERIFY((end.centre - standoff->foot.head<2>()).norm() < 1e-9);
          ++standoffs;
        }
      }
    }
    QCOMPARE(standoffs, 48);
  }

  void everyLinkOfTheExamplesIsOneBody_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames())
      if (placementOf(test::example(name)).tree) QTest::newRow(name.c_str()) << QString(name.c_str());
  }

  void everyLinkOfTheExamplesIsOneBody() {
    QFETCH(QString, name);
    const Mechanism mechanism = test::example(name.toStdString());
    const GearTrain train = trainOf(mechanism, placementOf(mechanism));
    int grounds = 0;
    QStringList parted;
    for (const LinkBody& body : train.bodies) {
      const int bodies = bodiesOf(piecesOf(train, body.link));
      if (body.link == 0) {
        ++grounds;
        QCOMPARE(bodies, 1);
      } else if (bodies != 1) {
        parted << QString("link %1 is %2 bodies").arg(body.link).arg(bodies);
      }
    }
    QCOMPARE(grounds, 1);
    QVERIFY2(parted.isEmpty(), qPrintable(parted.join(", ")));
  }
};

QTEST_APPLESS_MAIN(LinkContactsTest)
#include "test_link_contacts.moc"
