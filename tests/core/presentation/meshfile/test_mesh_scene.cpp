#include <QTest>
#include <numbers>

#include "tests/core/presentation/meshfile/cogs.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// The unit cube with its least corner at a place.
Solid cube(float x, float y, float z) {
  Solid solid;
  for (int i = 0; i < 8; ++i) {
    solid.positions.push_back({x + float(i & 1), y + float(i >> 1 & 1), z + float(i >> 2 & 1)});
  }
  solid.normals.assign(8, {0, 0, 1});
  solid.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return solid;
}

}  // namespace

class MeshSceneTest : public QObject {
  Q_OBJECT
 private slots:
  void splitVerticesWeldToAClosedMesh() {
    const Solid wheel = cog(9, 4, 2);
    const WeldedMesh mesh = welded(wheel);
    QVERIFY(mesh.positions.size() < wheel.positions.size());
    QCOMPARE(mesh.triangles.size(), wheel.triangles.size());
    QVERIFY(isClosed(mesh));
    QVERIFY(signedVolume(wheel) > 0);
  }

  void weldingTakesMinusZeroForZeroAndNothingElse() {
    Solid solid;
    solid.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, -0.0F}, {1, 1e-30F, 0}, {0, 1, 0}};
    solid.triangles = {{0, 1, 2}, {3, 4, 5}, {0, 3, 1}};
    const WeldedMesh mesh = welded(solid);
    QCOMPARE(mesh.positions.size(), std::size_t(4));
    QCOMPARE(mesh.triangles.size(), std::size_t(2));  // the third lost a corner
  }

  void shellsThatTouchStayApartWhereEdgesNeedIt() {
    // Two cubes that share an edge, and a third that touches one of them in a corner.
    Solid three = cube(0, 0, 0);
    append(three, cube(1, 1, 0));
    append(three, cube(-1, -1, -1));
    QVERIFY(!isClosed(welded(three)));
    const WeldedMesh mesh = weldedToManifold(three);
    QVERIFY(isClosed(mesh));
    QCOMPARE(mesh.positions.size(), std::size_t(24));
    QCOMPARE(mesh.triangles.size(), std::size_t(36));
  }

  void aSolidThatDoesNotTouchItselfWeldsTheSameBothWays() {
    const Solid wheel = cog(9, 4, 2);
    const WeldedMesh mesh = weldedToManifold(wheel);
    QVERIFY(isClosed(mesh));
    QCOMPARE(mesh.positions.size(), welded(wheel).positions.size());
  }

  void anOpenSolidWeldsAsFarAsItGoes() {
    Solid wheel = cog(9, 4, 2);
    wheel.triangles.pop_back();
    const WeldedMesh mesh = weldedToManifold(wheel);
    QCOMPARE(mesh.triangles.size(), wheel.triangles.size());
    QCOMPARE(mesh.positions.size(), welded(wheel).positions.size());
  }

  void aMissingTriangleIsSeen() {
    Solid wheel = cog(9, 4, 2);
    wheel.triangles.pop_back();
    QVERIFY(!isClosed(welded(wheel)));
  }

  void rotationBetweenKeysIsThatOfAUniformTurn() {
    const MeshScene scene = movingScene();
    const Eigen::Isometry3d pose = poseAt(scene.nodes[3], 1.3);
    Eigen::Isometry3d expected(Eigen::Translation3d(3, 7, -2));
    expected.rotate(Eigen::AngleAxisd(2 * std::numbers::pi * 1.3 / 4, Eigen::Vector3d::UnitZ()));
    QVERIFY(pose.isApprox(expected, 1e-12));
    QCOMPARE(durationOf(scene), 4.0);
  }

  void motionBeginsAndEndsAtRest() {
    const MeshScene scene = movingScene();
    const auto rest = worldPoses(scene);
    for (const double time : {-1.0, 0.0, 4.0, 9.0}) {
      const auto poses = worldPosesAt(scene, time);
      for (std::size_t i = 0; i < rest.size(); ++i) QVERIFY(poses[i].isApprox(rest[i], 1e-12));
    }
    QVERIFY(!worldPosesAt(scene, 1)[4].isApprox(rest[4], 1e-3));
  }

  void childrenRideOnTheirParents() {
    const MeshScene scene = movingScene();
    const Eigen::Vector3d centre = worldPosesAt(scene, 1)[4].translation();  // a quarter turn
    QVERIFY((centre - Eigen::Vector3d(3, 28, -2)).norm() < 1e-12);
  }

  void flatteningKeepsEveryPoint() {
    const MeshScene scene = movingScene();
    const MeshScene flat = flattened(scene);
    QCOMPARE(flat.nodes.size(), std::size_t(4));
    QCOMPARE(triangleCount(flat), triangleCount(scene));
    const auto world = worldPoses(scene);
    const Float3& p = scene.nodes[4].solid->positions[17];
    const Eigen::Vector3d moved = world[4] * Eigen::Vector3d(p[0], p[1], p[2]);
    const Float3& q = flat.nodes[3].solid->positions[17];
    QVERIFY((moved - Eigen::Vector3d(q[0], q[1], q[2])).norm() < 1e-5);
    QVERIFY(isClosed(welded(*flat.nodes[3].solid)));
  }

  void namesAreMadeDistinct() {
    MeshScene scene = movingScene();
    scene.nodes[0].name.clear();
    scene.nodes[3].name = "wheel (2)";
    const MeshScene named = withDistinctNames(scene);
    QCOMPARE(named.nodes[0].name, std::string("node"));
    QCOMPARE(named.nodes[1].name, std::string("wheel"));
    QCOMPARE(named.nodes[2].name, std::string("wheel (2)"));
    QCOMPARE(named.nodes[3].name, std::string("wheel (2) (2)"));
  }

  void unitsAreKnownInMetres() {
    QCOMPARE(metresPerUnit("mm"), 1e-3);
    QCOMPARE(metresPerUnit("in"), 0.0254);
    QCOMPARE(metresPerUnit("m"), 1.0);
    QCOMPARE(metresPerUnit("furlong"), 1e-3);
  }
};

QTEST_APPLESS_MAIN(MeshSceneTest)
#include "test_mesh_scene.moc"
