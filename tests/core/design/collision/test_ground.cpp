#include <QTest>
#include <algorithm>
#include <numeric>
#include <set>

#include <fcl/narrowphase/collision.h>

#include "core/design/collision/collision_shape.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/part_solids.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

/// Do the surfaces of two parts meet?
bool touch(const CollisionPart& a, const CollisionPart& b) {
  if ((a.centre - b.centre).norm() > a.radius + b.radius) return false;
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  fcl::CollisionResult<double> result;
  fcl::collide(&a.shape->model(), here, &b.shape->model(), here, fcl::CollisionRequest<double>(), result);
  return result.isCollision();
}

/// By part: the first part that it hangs together with.
std::vector<std::size_t> groupsOf(const std::vector<CollisionPart>& parts) {
  std::vector<std::size_t> groups(parts.size());
  std::iota(groups.begin(), groups.end(), std::size_t{0});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (groups[i] == groups[k] || !touch(parts[i], parts[k])) continue;
      const std::size_t to = std::min(groups[i], groups[k]), from = std::max(groups[i], groups[k]);
      std::replace(groups.begin(), groups.end(), from, to);
    }
  }
  return groups;
}

std::vector<CollisionPart> partsOfGround(const Mechanism& mechanism) {
  std::vector<CollisionPart> parts = collisionParts(trainOf(mechanism, placementOf(mechanism)));
  std::erase_if(parts, [](const CollisionPart& part) { return part.link != 0; });
  return parts;
}

}  // namespace

/// The ground hangs together.
class GroundTest : public QObject {
  Q_OBJECT
 private slots:
  void groundIsOneBodyInTheExamples_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  /// Walks the contacts of the ground's gears, bearings, housings, bars and base.
  void groundIsOneBodyInTheExamples() {
    QFETCH(QString, name);
    const Mechanism mechanism = test::example(name.toStdString());
    if (!placementOf(mechanism).tree) {  // shows no train
      QCOMPARE(name, QStringLiteral("robot-to-mend"));
      return;
    }
    const std::vector<CollisionPart> parts = partsOfGround(mechanism);
    QVERIFY(!parts.empty());
    const std::vector<std::size_t> groups = groupsOf(parts);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Eigen::Vector3d& at = parts[p].centre;
      QVERIFY2(groups[p] == 0, qPrintable(QString("part %1 of %2 at %3, %4, %5 touches no other")
                                              .arg(p)
                                              .arg(parts.size())
                                              .arg(at.x())
                                              .arg(at.y())
                                              .arg(at.z())));
    }
  }

  /// The walk itself: parts that are apart are told apart.
  void partsThatAreApartAreSeveralGroups() {
    std::vector<CollisionPart> parts = partsOfGround(test::example("planetary-ring-held"));
    const Eigen::Isometry3d away(Eigen::Translation3d(1e4, 0, 0));
    const Solid bar = moved(tube(3, 0, 0, 10, 0.1), away);
    parts.push_back(collisionPart(0, bar, 1));
    const std::vector<std::size_t> groups = groupsOf(parts);
    QCOMPARE(std::set<std::size_t>(groups.begin(), groups.end()).size(), std::size_t{2});
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::GroundTest)
#include "test_ground.moc"
