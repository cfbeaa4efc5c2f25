#include <QTest>
#include <algorithm>

#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "ui/models/axis_choices.h"

namespace geargraph {
namespace {

/// Which axes an axis is offered to lie square to, in order.
std::vector<AxisId> offeredFor(const Mechanism& mechanism, const AxisId& axis) {
  std::vector<AxisId> offered;
  for (const NamedAxisChoice& each : axisChoices(mechanism, {axis}))
    if (each.choice.way == AxisChoice::Way::squareTo) offered.push_back(each.choice.other);
  return offered;
}

/// By how many joints two links are apart that turn about these axes; two axes of one link: 1.
int jointsBetween(const Mechanism& mechanism, const AxisId& from, const AxisId& to) {
  std::set<AxisId> reached{from};
  for (int steps = 0; steps <= mechanism.n(); ++steps) {
    if (reached.contains(to)) return steps;
    std::set<LinkId> links;
    for (const TurningJoint& joint : mechanism.turningJoints)
      if (reached.contains(joint.axis)) links.insert({joint.tail, joint.head});
    for (const TurningJoint& joint : mechanism.turningJoints)
      if (links.contains(joint.tail) || links.contains(joint.head)) reached.insert(joint.axis);
  }
  return mechanism.n();
}

}  // namespace

/// The ways to lay an axis, for menus.
class AxisChoicesTest : public QObject {
  Q_OBJECT

 private slots:
  void allAxesOfASmallTrainAreOffered() {
    const Mechanism robot = test::example("robot");
    const AxisId& first = robot.axes.front().id;
    const std::vector<AxisId> offered = offeredFor(robot, first);
    QCOMPARE(offered.size(), robot.axes.size() - 1);
    for (std::size_t i = 0; i < offered.size(); ++i) QCOMPARE(offered[i], robot.axes[i + 1].id);
    const auto choices = axisChoices(robot, {first});
    QCOMPARE(choices.size(), 3 + 3 * offered.size());
    QCOMPARE(choices[3].group, QString("Square to"));
  }

  void theNearestAxesOfALargeTrainAreOffered() {
    const Mechanism train = test::randomTrain(7, 400, 160);
    const AxisId& asked = train.axes[train.axes.size() / 2].id;
    QVERIFY(train.axes.size() > kMaxAxesOffered + 1);
    const std::vector<AxisId> offered = offeredFor(train, asked);
    QCOMPARE(offered.size(), kMaxAxesOffered);
    QVERIFY(std::find(offered.begin(), offered.end(), asked) == offered.end());
    int farthest = 0;
    for (const AxisId& each : offered) farthest = std::max(farthest, jointsBetween(train, asked, each));
    int others = 0;
    for (const Axis& axis : train.axes) {
      if (axis.id == asked || std::find(offered.begin(), offered.end(), axis.id) != offered.end()) continue;
      QVERIFY2(jointsBetween(train, asked, axis.id) >= farthest, axis.id.text().c_str());
      ++others;
    }
    QVERIFY(others > 0);
    QCOMPARE(axisChoices(train, {asked})[3].group, QString("Square to (nearest axes)"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::AxisChoicesTest)
#include "test_axis_choices.moc"
