#include <QTest>
#include <numbers>

#include "core/presentation/meshfile/turn_keys.h"

using namespace geargraph;

class TurnKeysTest : public QObject {
  Q_OBJECT
 private slots:
  void turnsCloseToTheLastBit() {
    const Eigen::Quaterniond rest(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()));
    const auto keys = uniformTurn(Eigen::Vector3d::UnitY(), rest, 4 * 12345, 7.5);
    QCOMPARE(keys.size(), std::size_t(4 * 12345 + 1));
    QCOMPARE(keys.back().seconds, 7.5);
    QVERIFY(keys.back().rotation.coeffs() == -keys.front().rotation.coeffs());  // an odd number of turns
    QVERIFY(keys[8].rotation.coeffs() == keys[0].rotation.coeffs());
  }

  /// Some seconds of a turn end where it is then, a key at each quarter before.
  void aStretchNeedNotBeWholeQuarters() {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 2) / 3;
    const Eigen::Quaterniond rest(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()));
    for (const double rate : {0.7, -3.1, 1e-6}) {
      MeshNode node;
      node.keys = turnFor(axis, rest, rate, 5);
      QCOMPARE(node.keys.size(), std::size_t(2 + std::floor(5 * std::abs(rate) / (std::numbers::pi / 2))));
      QCOMPARE(node.keys.back().seconds, 5.0);
      for (const double time : {0.0, 0.3, 2.2, 4.9, 5.0}) {
        const Eigen::Matrix3d wanted = (Eigen::AngleAxisd(rate * time, axis) * rest).toRotationMatrix();
        QVERIFY((poseAt(node, time).linear() - wanted).norm() < 1e-12);
      }
    }
  }

  void keysTurnTheWayTheyAreTold() {
    const Eigen::Vector3d axis = Eigen::Vector3d(2, -1, 2) / 3;
    const Eigen::Quaterniond rest(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
    MeshNode node;
    for (const long long quarters : {-6LL, -1LL, 1LL, 8LL}) {
      node.keys = uniformTurn(axis, rest, quarters, 2);
      for (int i = 0; i <= 20; ++i) {
        const double angle = std::numbers::pi / 2 * static_cast<double>(quarters) * i / 20;
        const Eigen::Quaterniond expected = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * rest;
        QVERIFY(poseAt(node, 0.1 * i).linear().isApprox(expected.toRotationMatrix(), 1e-12));
      }
    }
  }

  void aNodeAtRestHasTwoEqualKeys() {
    const auto keys = uniformTurn(Eigen::Vector3d::UnitZ(), Eigen::Quaterniond::Identity(), 0, 2);
    QCOMPARE(keys.size(), std::size_t(2));
    QVERIFY(keys[0].rotation.coeffs() == keys[1].rotation.coeffs());
    QCOMPARE(keys[1].seconds, 2.0);
  }
};

QTEST_APPLESS_MAIN(TurnKeysTest)
#include "test_turn_keys.moc"
