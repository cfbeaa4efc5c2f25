#include <QTest>

#include "core/machine/solids/solid.h"

using namespace geargraph;

namespace {

/// The tetrahedron of the origin and the unit points of the axes, volume 1/6.
Solid tetrahedron() {
  Solid solid;
  solid.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  solid.normals.assign(4, {0, 0, 1});
  solid.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return solid;
}

}  // namespace

class SolidTest : public QObject {
  Q_OBJECT
 private slots:
  void volumeOfATetrahedronIsASixth() { QCOMPARE(signedVolume(tetrahedron()), 1.0 / 6); }

  void volumeDoesNotChangeWithTheMotion() {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()))
        .pretranslate(Eigen::Vector3d(4, 5, 6));
    QVERIFY(std::abs(signedVolume(moved(tetrahedron(), place)) - 1.0 / 6) < 1e-5);
  }

  void motionTurnsNormalsWithoutMovingThem() {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.translate(Eigen::Vector3d(4, 5, 6)).rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    const Float3 normal = moved(tetrahedron(), place).normals.front();
    QVERIFY(std::abs(normal[2] + 1) < 1e-6F && std::abs(normal[0]) < 1e-6F && std::abs(normal[1]) < 1e-6F);
  }

  void appendingKeepsBothShells() {
    Solid whole = tetrahedron();
    append(whole, tetrahedron(), Eigen::Isometry3d(Eigen::Translation3d(10, 0, 0)));
    QCOMPARE(whole.positions.size(), std::size_t(8));
    QCOMPARE(whole.triangles.back(), (Triangle{5, 6, 7}));
    QVERIFY(std::abs(signedVolume(whole) - 2.0 / 6) < 1e-5);
    QCOMPARE(boundsOf(whole).max().x(), 11.0);
  }
};

QTEST_APPLESS_MAIN(SolidTest)
#include "test_solid.moc"
