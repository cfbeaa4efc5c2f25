#include <QTest>
#include <numbers>

#include "core/foundations/files/file.h"
#include "core/presentation/meshfile/link_scene.h"
#include "core/presentation/meshfile/mesh_reader.h"
#include "core/theory/pose/turning_lines.h"
#include "tests/core/presentation/meshfile/cogs.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// The paper's robot with a cog on each moving link, and rates of its joints that need not obey the teeth.
struct Robot {
  Mechanism mechanism;
  Digraph graph;
  SpanningTree tree;
  ForwardKinematics kinematics;
  std::vector<LinkPart> parts;
  std::vector<Rational> rates;

  explicit Robot(Mechanism robot)
      : mechanism(std::move(robot)),
        graph(mechanism),
        tree(SpanningTree::of(graph).value()),
        kinematics(tree, turningLines(placementOf(mechanism))) {
    const auto solid = std::make_shared<const Solid>(cog(9, 5, 3));
    for (int link = 1; link <= mechanism.n(); ++link) {
      Eigen::Isometry3d pose(Eigen::Translation3d(kinematics.line(tree.jointToParent(link)).point));
      pose.rotate(Eigen::AngleAxisd(0.3 * link, Eigen::Vector3d(1, link, 2).normalized()));
      parts.push_back({link, "cog " + std::to_string(link), pose, solid});
    }
    for (int joint = 0; joint < mechanism.t(); ++joint) rates.emplace_back(joint - 2, 1 + joint % 3);
  }

  [[nodiscard]] LinkSceneSource source() const {
    return {mechanism, tree, kinematics, parts, [](int label) {
              return Float3{0.1F * float(label), 0.5F, 0.5F};
            }};
  }
  [[nodiscard]] MeshScene scene(std::optional<double> seconds) const {
    const auto made = linkScene(source(), UniformMotion{rates, seconds});
    return std::get<MeshScene>(made);
  }
  /// Poses of the parts when the joints have turned for `seconds` at their rates.
  [[nodiscard]] std::vector<Eigen::Isometry3d> expected(double seconds) const {
    std::vector<double> angles;
    for (const Rational& rate : rates) angles.push_back(rate.toDouble() * seconds);
    const auto links = kinematics.poses(angles);
    std::vector<Eigen::Isometry3d> poses;
    for (const LinkPart& part : parts)
      poses.push_back(links[static_cast<std::size_t>(part.link)] * part.pose);
    return poses;
  }
};

Robot paperRobot() {
  return Robot(test::example("robot"));
}

}  // namespace

class LinkSceneTest : public QObject {
  Q_OBJECT
 private slots:
  void aPartIsWhereForwardKinematicsPutsIt() {
    const Robot robot = paperRobot();
    const MeshScene scene = robot.scene(std::nullopt);
    const std::size_t first = scene.nodes.size() - robot.parts.size();
    for (int i = 0; i <= 50; ++i) {
      const double time = 0.25 * i;
      const auto world = worldPosesAt(scene, time);
      const auto expected = robot.expected(time);
      for (std::size_t k = 0; k < expected.size(); ++k) QVERIFY(world[first + k].isApprox(expected[k], 1e-9));
    }
  }

  void onePeriodBringsEverythingBack() {
    const Robot robot = paperRobot();
    const MeshScene scene = robot.scene(std::nullopt);
    QVERIFY(std::abs(durationOf(scene) - 2 * std::numbers::pi * 2) <
            1e-9);  // rates with denominators 1 and 2
    const auto rest = worldPoses(scene);
    const auto end = worldPosesAt(scene, durationOf(scene));
    const auto half = worldPosesAt(scene, durationOf(scene) / 2);
    for (std::size_t i = 0; i < rest.size(); ++i) QVERIFY(end[i].isApprox(rest[i], 1e-12));
    const bool isHalf = std::abs(robot.rates[1].toDouble()) == 0.5;
    const LinkOrdinal away = isHalf ? robot.tree.child(1) : LinkOrdinal(0);  // half a turn
    const std::size_t node = rest.size() - robot.parts.size() + static_cast<std::size_t>(away) - 1;
    QVERIFY(away > 0 && !half[node].isApprox(rest[node], 1e-3));
  }

  void thePeriodPlaysInTheTimeThatIsAskedFor() {
    const Robot robot = paperRobot();
    const MeshScene slow = robot.scene(std::nullopt);
    const MeshScene fast = robot.scene(4.0);
    QVERIFY(std::abs(durationOf(fast) - 4) < 1e-12);
    const auto expected = worldPosesAt(slow, durationOf(slow) * 0.3);
    const auto world = worldPosesAt(fast, 4 * 0.3);
    for (std::size_t i = 0; i < world.size(); ++i) QVERIFY(world[i].isApprox(expected[i], 1e-9));
  }

  void theMotionSurvivesGlb() {
    const Robot robot = paperRobot();
    const auto encoded = encodedMesh(robot.scene(10.0), MeshFormat::glb, "robot");
    const auto read = readMesh(std::get<std::vector<EncodedFile>>(encoded)[0].bytes, MeshFormat::glb);
    const MeshScene& back = std::get<MeshScene>(read);
    QVERIFY(std::abs(durationOf(back) - 10) < 1e-5);
    const double period = 2 * std::numbers::pi * 2;
    for (int i = 0; i <= 40; ++i) {
      const auto world = worldPosesAt(back, 0.25 * i);
      const auto expected = robot.expected(period * 0.025 * i);
      std::size_t found = 0;
      for (std::size_t k = 0; k < back.nodes.size(); ++k) {
        if (back.nodes[k].name.rfind("cog ", 0) != 0) continue;
        const auto part = static_cast<std::size_t>(std::stoi(back.nodes[k].name.substr(4)) - 1);
        QVERIFY((world[k].linear() - expected[part].linear()).norm() < 1e-5);
        QVERIFY((world[k].translation() * 1e3 - expected[part].translation()).norm() < 1e-3);
        ++found;
      }
      QCOMPARE(found, robot.parts.size());
    }
  }

  void nodesFollowTheTreeOfTheLinks() {
    const Robot robot = paperRobot();
    const MeshScene scene = robot.scene(1.0);
    for (int link = 1; link <= robot.mechanism.n(); ++link) {
      const auto nodeOf = [&](int l) {
        const std::string& name = robot.mechanism.links[static_cast<std::size_t>(l)].name;
        const std::string wanted = name.empty() ? "link " + std::to_string(l) : name;
        const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                        [&](const MeshNode& node) { return node.name == wanted; });
        return static_cast<std::size_t>(found - scene.nodes.begin());
      };
      QVERIFY(nodeOf(link) < scene.nodes.size());
      QCOMPARE(scene.nodes[nodeOf(link)].parent, nodeOf(robot.tree.parent(link)));
    }
    QCOMPARE(scene.materials.size(), robot.mechanism.links.size());
    QCOMPARE(scene.nodes.back().material, robot.mechanism.links.size() - 1);
  }

  void withoutMotionThereAreNoKeys() {
    Robot robot = paperRobot();
    const auto still = linkScene(robot.source(), std::nullopt);
    QCOMPARE(durationOf(std::get<MeshScene>(still)), 0.0);
    for (Rational& rate : robot.rates) rate = Rational(0);
    QCOMPARE(durationOf(robot.scene(3.0)), 0.0);
  }

  /// What repeats too late for a file is shown for some seconds, at the speed that it has.
  void aStretchOfAMotionWithoutAShortPeriod() {
    Robot robot = paperRobot();
    robot.rates[0] = Rational(1, 1'000'003);
    const auto made = linkScene(robot.source(), UniformMotion{robot.rates, {}, 7.3});
    QVERIFY(std::holds_alternative<MeshScene>(made));
    const auto& scene = std::get<MeshScene>(made);
    QCOMPARE(durationOf(scene), 7.3);
    for (const double time : {0.0, 1.7, 4.1, 7.3}) {
      const auto poses = worldPosesAt(scene, time);
      const auto wanted = robot.expected(time);
      for (std::size_t part = 0; part < wanted.size(); ++part)
        QVERIFY((poses[poses.size() - wanted.size() + part].matrix() - wanted[part].matrix()).norm() < 1e-9);
    }
    robot.rates[0] = Rational(10'000'000);
    const auto tooFast = linkScene(robot.source(), UniformMotion{robot.rates, {}, 7.3});
    QVERIFY(std::get<MeshFileError>(tooFast).kind == MeshFileError::Kind::limit);
  }

  /// Between limits the motion goes there and back: to 0.7 s, back to -1.2 s and on to 0.
  void aRangeIsShownThereAndBack() {
    const Robot robot = paperRobot();
    for (const std::optional<double> seconds : {std::optional<double>(), std::optional(10.0)}) {
      UniformMotion motion{robot.rates, seconds};
      motion.range = {-1.2, 0.7};
      const auto made = linkScene(robot.source(), motion);
      QVERIFY(std::holds_alternative<MeshScene>(made));
      const auto& scene = std::get<MeshScene>(made);
      const double scale = seconds.value_or(3.8) / 3.8;
      QVERIFY(std::abs(durationOf(scene) - 3.8 * scale) < 1e-12);
      for (const auto& [time, motionTime] :
           {std::pair{0.0, 0.0}, {0.4, 0.4}, {0.7, 0.7}, {1.0, 0.4}, {2.6, -1.2}, {3.0, -0.8}, {3.8, 0.0}}) {
        const auto poses = worldPosesAt(scene, time * scale);
        const auto wanted = robot.expected(motionTime);
        for (std::size_t part = 0; part < wanted.size(); ++part)
          QVERIFY((poses[poses.size() - wanted.size() + part].matrix() - wanted[part].matrix()).norm() <
                  1e-9);
      }
    }
  }

  void aPeriodBeyondTheLimitIsRejectedWithItsLength() {
    Robot robot = paperRobot();
    robot.rates[0] = Rational(1, 1'000'003);
    const auto made = linkScene(robot.source(), UniformMotion{robot.rates, 5.0});
    const auto* error = std::get_if<MeshFileError>(&made);
    QVERIFY(error != nullptr && error->kind == MeshFileError::Kind::limit);
    QVERIFY(error->message.find("2000006 turns") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(LinkSceneTest)
#include "test_link_scene.moc"
