#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/model/edits.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/scene3d/scene_lines.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

MechanismScenePtr stageOf(const Mechanism& mechanism, GearCache& cache) {
  return mechanismScene(*analyzeLive(std::make_shared<const Mechanism>(mechanism)), cache);
}

Mechanism paperRobot() {
  return test::example("robot");
}

std::vector<Pose> posesAt(const MechanismScene& stage, const std::vector<double>& angles) {
  std::vector<Pose> poses(stage.scene.instances.size());
  stage.place(angles, poses);
  return poses;
}

/// Where the link of an instance went from its reference pose.
Pose displacement(const MechanismScene& stage, const std::vector<Pose>& poses, const ElementId& link) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Instance& instance = stage.scene.instances[i];
    if (instance.element == link) return poses[i] * instance.pose.inverse();
  }
  return Pose::Identity();
}

/// An instance that is a wheel of this mesh on this link.
bool isWheelOf(const Instance& instance, const ElementId& mesh) {
  return std::find(instance.also.begin(), instance.also.end(), mesh) != instance.also.end();
}

/// Simple trains of every kind: spur pair, ring, planetary, bevel differential.
std::vector<Mechanism> trains() {
  std::vector<Mechanism> result;
  test::TrainBuilder planetary("planetary");
  const int centre = planetary.axis({0, 0, 0}, {0, 0, 1}), side = planetary.axis({45, 0, 0}, {0, 0, 1});
  const int sun = planetary.link(0, centre), ring = planetary.link(0, centre),
            arm = planetary.link(0, centre);
  const int planet = planetary.linkReversed(arm, side);
  planetary.external(sun, centre, 24, planet, side, 21);
  planetary.internal(planet, side, 21, ring, centre, 66);
  planetary.input(0, 2);
  planetary.input(1, Rational(-1, 3));
  result.push_back(planetary.mechanism());
  test::TrainBuilder differential("differential");
  const int x = differential.axis({0, 0, 0}, {1, 0, 0}), y = differential.axis({0, 0, 0}, {0, 1, 0});
  const int left = differential.link(0, x), right = differential.link(0, x), cage = differential.link(0, x);
  const int spider = differential.link(cage, y);
  differential.bevel(left, x, 30, spider, y, 20, 1);
  differential.bevel(right, x, 30, spider, y, 20, -1);
  differential.input(0, 1);
  differential.input(1, Rational(1, 2));
  result.push_back(differential.mechanism());
  result.push_back(test::robot());
  result.push_back(paperRobot());
  return result;
}

}  // namespace

class TrainStageTest : public QObject {
  Q_OBJECT

 private slots:
  /// Joint 8 turns at 1 rad/s, its mesh turns joint 10 back at half of that.
  void limitsOfJointsLimitTheMotion() {
    Mechanism robot = paperRobot();
    for (TurningJoint& joint : robot.turningJoints) joint.limits = {};
    GearCache cache;
    const std::vector<double> none(3, 0);
    QVERIFY(!stageOf(robot, cache)->range);
    robot = withJointLimits(robot, JointId("8"), {std::nullopt, Number(180)}).value();
    robot = withJointLimits(robot, JointId("10"), {Number(-60), Number(45)}).value();
    const MechanismScenePtr stage = stageOf(robot, cache);
    const SceneRange range = stage->range(none);
    constexpr double kDegree = std::numbers::pi / 180;
    QVERIFY(std::abs(range.to.time - 120 * kDegree) < 1e-12);
    QCOMPARE(range.to.text, std::string("joint 10 at -60°"));
    QVERIFY(std::abs(range.from.time + 90 * kDegree) < 1e-12);
    QCOMPARE(range.from.text, std::string("joint 10 at 45°"));
    const std::vector<double> added = {20 * kDegree, 0, 0};  // by hand
    QVERIFY(std::abs(stage->range(added).to.time - 100 * kDegree) < 1e-12);
    const std::vector<double> within = {119 * kDegree, 0, 0};
    const std::vector<double> beyond = {121 * kDegree, 0, 0};
    QVERIFY(stage->beyondLimits(within).empty());
    QCOMPARE(stage->beyondLimits(beyond), std::string("joint 10 at -60°"));
  }

  void theRobotHasEightWheelsInTheColoursOfTheirLinks() {
    const Mechanism robot = paperRobot();
    std::multiset<std::pair<int, int>> linkAndTeeth;
    for (const TrainGear& gear : trainOf(robot, placementOf(robot)).gears) {
      linkAndTeeth.emplace(gear.link, gear.spec.teeth);
    }
    QCOMPARE(linkAndTeeth, (std::multiset<std::pair<int, int>>{
                               {1, 36}, {2, 30}, {3, 24}, {4, 18}, {5, 20}, {6, 24}, {7, 16}, {7, 18}}));
    GearCache cache;
    const MechanismScenePtr stage = stageOf(robot, cache);
    for (const Instance& instance : stage->scene.instances) {
      const std::size_t link = std::stoul(instance.element.id.text());
      const Color color = linkColor(static_cast<int>(link));
      QCOMPARE(instance.colour,
               Rgb::fromHex(static_cast<unsigned>(color.red << 16 | color.green << 8 | color.blue)));
    }
  }

  /// Wheels come in four details, bodies in two, each finer than the last and made when somebody looks so
  /// close; equal wheels share them.
  void partsComeInDetails() {
    GearCache cache;
    const MechanismScenePtr stage = stageOf(paperRobot(), cache);
    std::size_t wheels = 0;
    QCOMPARE(stage->scene.levels.size(), stage->scene.solids.size());
    for (std::size_t i = 0; i < stage->scene.levels.size(); ++i) {
      const DetailLevels& levels = stage->scene.levels[i];
      QVERIFY(levels.finer.size() == 3 || levels.finer.size() == 1);
      wheels += levels.finer.size() == 3 ? 1 : 0;
      QVERIFY(std::abs(levels.unit - 2) < 1e-9);
      double error = levels.error;
      std::size_t triangles = stage->scene.solids[i]->triangles.size();
      for (const DetailLevels::LodLevel& level : levels.finer) {
        QVERIFY(level.solid->solidIfReady() == nullptr);
        QVERIFY(level.error < error);
        QVERIFY(level.solid->solid()->triangles.size() > triangles);
        QCOMPARE(signedVolume(*level.solid->solid()) > 0, true);
        error = level.error;
        triangles = level.solid->solid()->triangles.size();
      }
    }
    QCOMPARE(wheels, std::size_t{8});
    QCOMPARE(cache.size(), std::size_t{32});
  }

  void whatFollowsFromSolidsComesWithTheSceneAndStaysFromOneEditToTheNext() {
    GearCache cache;
    SceneMemory known;
    known.setFindsEdges(true);
    const auto snapshot = analyzeLive(std::make_shared<const Mechanism>(paperRobot()));
    const MechanismScenePtr first = mechanismScene(*snapshot, cache, nullptr, &known);
    const MechanismScenePtr second = mechanismScene(*snapshot, cache, nullptr, &known);
    const double pixels = 1000 / (2 * boundsOf(first->scene).radius());
    std::set<const Solid*> shown;
    for (std::size_t i = 0; i < first->scene.solids.size(); ++i) {
      const DetailLevels& levels = first->scene.levels[i];
      for (const double size : {0.0, pixels}) {
        const Solid* solid = levels.chosen(first->scene.solids[i], size * levels.unit).get();
        QCOMPARE(*first->scene.edges.at(solid), featureEdges(*solid));
        QCOMPARE(second->scene.edges.at(solid), first->scene.edges.at(solid));  // the same list
        shown.insert(solid);
      }
    }
    QVERIFY(shown.size() > first->scene.solids.size());
    QCOMPARE(first->scene.edges.size(), shown.size());
    QCOMPARE(first->scene.boxes.size(), first->scene.solids.size());
    for (std::size_t i = 0; i < first->scene.solids.size(); ++i)
      QVERIFY(first->scene.boxes[i].isApprox(boundsOf(*first->scene.solids[i]), 0));
    Scene bare = first->scene;
    bare.outlines.reset();
    QVERIFY(first->scene.outlines != nullptr && *first->scene.outlines == *solidOutlines(bare));
    QVERIFY(solidOutlines(first->scene) == first->scene.outlines);
    QCOMPARE(second->scene.solids, first->scene.solids);  // bodies too
    known.setFindsEdges(false);
    const MechanismScenePtr third = mechanismScene(*snapshot, cache, nullptr, &known);
    QVERIFY(third->scene.edges.empty());  // another thread paints, and finds its own
    QCOMPARE(third->scene.boxes.size(), third->scene.solids.size());
  }

  void marksOfWhatTheSectionTakesAwayAreGone() {
    GearCache cache;
    const MechanismScenePtr stage = stageOf(paperRobot(), cache);
    const std::vector<double> angles(stage->inputSpeeds.size(), 0.3);
    const std::vector<Pose> poses = posesAt(*stage, angles);
    const CutPlane cut{{0, 1, 0}, boundsOf(stage->scene).centre().y()};
    for (const bool velocities : {false, true}) {
      MarkChoice choice;
      (velocities ? choice.velocities : choice.pitchCircles) = true;
      Moment moment{poses, angles, stage->inputSpeeds, Pose::Identity(), std::nullopt, {}, {}, std::nullopt};
      const auto all = stageLines(*stage, choice, moment);
      moment.cut = cut;
      const auto left = stageLines(*stage, choice, moment);
      QVERIFY(!left.empty());
      QVERIFY(!velocities || left.size() < all.size());
      for (const MarkLine& line : left) {
        // An arrow's shaft begins at its point; the strokes of its head have three.
        const auto checked = velocities ? (line.points.size() == 2 ? 1 : 0) : line.points.size();
        for (std::size_t i = 0; i < checked; ++i) QVERIFY(line.points[i].y() <= cut.offset);
      }
    }
  }

  void meshingWheelsHaveOneVelocityWhereTheyTouch() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      QVERIFY(stage->place);
      const Placement placement = placementOf(mechanism);
      constexpr double kStep = 1e-5;
      for (const double time : {0.0, 0.7, 31.4}) {
        std::vector<double> before, after;
        for (const double speed : stage->inputSpeeds) {
          before.push_back(speed * time);
          after.push_back(speed * (time + kStep));
        }
        const auto then = posesAt(*stage, before), now = posesAt(*stage, after);
        for (const auto& mesh : placement.meshes) {
          const auto id = [&](int link) {
            return ElementId(mechanism.links[static_cast<std::size_t>(link)].id);
          };
          const Eigen::Vector3d point =
              displacement(*stage, then, id(mesh->carrier)) * Eigen::Vector3d::Map(mesh->pitchPoint.data());
          const auto velocity = [&](int link) -> Eigen::Vector3d {
            const Pose step =
                displacement(*stage, now, id(link)) * displacement(*stage, then, id(link)).inverse();
            return (step * point - point) / kStep;
          };
          const Eigen::Vector3d slip = velocity(mesh->tail) - velocity(mesh->head);
          QVERIFY2(slip.norm() < 0.01, qPrintable(QString::number(slip.norm())));
        }
      }
    }
  }

  void handlesTellHowPartsTurnAgainstWhatCarriesThem() {
    GearCache cache;
    int checked = 0;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      const Placement placement = placementOf(mechanism);
      QCOMPARE(stage->handles.size(), stage->scene.instances.size());
      std::vector<double> angles;
      for (std::size_t k = 0; k < stage->inputSpeeds.size(); ++k)
        angles.push_back(0.3 + 0.2 * static_cast<double>(k));
      const auto poses = posesAt(*stage, angles);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const SceneHandle& handle = stage->handles[i];
        const Instance& instance = stage->scene.instances[i];
        QCOMPARE(handle.gains.empty(), instance.element == ElementId(mechanism.links.front().id));
        if (handle.gains.empty()) continue;
        ++checked;
        double angle = 0;
        for (std::size_t k = 0; k < angles.size(); ++k) angle += handle.gains[k] * angles[k];
        const auto links = mechanism.links;
        const auto link = std::find_if(links.begin(), links.end(),
                                       [&](const Link& l) { return instance.element == ElementId(l.id); });
        const int parent = placement.tree->parent[static_cast<std::size_t>(link - links.begin())];
        const Pose carrier = displacement(*stage, poses, links[static_cast<std::size_t>(parent)].id);
        const Pose turned = Eigen::Translation3d(handle.point) * Eigen::AngleAxisd(angle, handle.direction) *
                            Eigen::Translation3d(-handle.point);
        const Pose own = poses[i] * instance.pose.inverse();
        QVERIFY((own.matrix() - (carrier * turned).matrix()).norm() < 1e-6);
      }
    }
    QVERIFY2(checked > 20, qPrintable(QString::number(checked)));
  }

  void afterOnePeriodEverythingIsWhereItWas() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      QVERIFY(stage->period > 0);
      std::vector<double> angles;
      for (const double speed : stage->inputSpeeds) angles.push_back(speed * stage->period);
      const auto poses = posesAt(*stage, angles);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        QVERIFY((poses[i].matrix() - stage->scene.instances[i].pose.matrix()).norm() < 1e-6);
      }
    }
  }

  void everyLinkButTheGroundHasItsNumber() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      std::vector<SceneLabel> labels;
      std::copy_if(stage->labels.begin(), stage->labels.end(), std::back_inserter(labels),
                   [](const SceneLabel& label) { return label.kind == LabelKind::link; });
      QCOMPARE(static_cast<int>(labels.size()), mechanism.n());
      for (std::size_t i = 0; i < labels.size(); ++i) {
        QCOMPARE(labels[i].text, std::to_string(i + 1));
        QCOMPARE(labels[i].element, ElementId(mechanism.links[i + 1].id));
        QCOMPARE(stage->scene.instances[labels[i].instance].element, labels[i].element);
      }
    }
  }

  void jointsAndAxesHaveTheirLabelsOnTheirLines() {
    GearCache cache;
    const Mechanism robot = paperRobot();
    const MechanismScenePtr stage = stageOf(robot, cache);
    const Placement placement = placementOf(robot);
    std::set<std::string> joints, axes;
    for (const SceneLabel& label : stage->labels) {
      if (label.kind == LabelKind::link) continue;
      (label.kind == LabelKind::joint ? joints : axes).insert(label.text);
      const Pose& pose = stage->scene.instances[label.instance].pose;
      const Eigen::Vector3d at = pose * label.place;
      double nearest = 1e9;
      for (const AxisLine& line : placement.axes) {
        const Eigen::Vector3d point(line.point.data()), direction(line.direction.data());
        nearest = std::min(nearest, (at - point).cross(direction).norm());
      }
      QVERIFY(nearest < 1e-6);
    }
    QCOMPARE(joints, (std::set<std::string>{"8", "9", "10", "11", "12", "13", "14"}));
    QVERIFY(!axes.empty());
  }

  void pitchCirclesPassThroughThePitchPointsAndRollThere() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      QCOMPARE(static_cast<int>(stage->contacts.size()), mechanism.c());
      std::vector<double> angles;
      for (std::size_t k = 0; k < stage->inputSpeeds.size(); ++k) angles.push_back(0.4 + double(k));
      const auto poses = posesAt(*stage, angles);
      std::vector<Twist3> twists(poses.size());
      stage->twists(angles, stage->inputSpeeds, twists);
      for (const SceneContact& contact : stage->contacts) {
        for (const std::size_t wheel : {contact.tail, contact.head}) {
          const Eigen::Vector3d at = stage->scene.instances[wheel].pose.inverse() * contact.point;
          const bool onCircle =
              std::any_of(stage->marks.begin(), stage->marks.end(), [&](const SceneMark& mark) {
                return mark.kind == MarkKind::pitchCircle && mark.instance == wheel &&
                       mark.points.size() > 2 &&
                       std::abs(mark.points[0].head<2>().norm() - at.head<2>().norm()) < 1e-9 &&
                       std::abs(mark.points[0].z() - at.z()) < 1e-9;
              });
          QVERIFY(onCircle);
        }
        Eigen::Vector3d now = contact.point;
        if (contact.carrier) {
          now = poses[*contact.carrier] * stage->scene.instances[*contact.carrier].pose.inverse() * now;
        }
        const Eigen::Vector3d slip = twists[contact.tail].at(now) - twists[contact.head].at(now);
        QVERIFY2(slip.norm() < 1e-9 * (1 + twists[contact.tail].at(now).norm()),
                 qPrintable(QString::number(slip.norm())));
      }
    }
  }

  // Angles are products, never sums of steps: nothing has drifted, however long it ran.
  void aMillionPeriodsLaterTheTeethStillMesh() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      std::vector<double> now, later;
      for (const double speed : stage->inputSpeeds) {
        now.push_back(speed * 0.37);
        later.push_back(speed * (0.37 + 1e6 * stage->period));
      }
      const auto poses = posesAt(*stage, now), after = posesAt(*stage, later);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const Eigen::Matrix4d drift = after[i].matrix() - poses[i].matrix();
        QVERIFY2(drift.norm() < 1e-3, qPrintable(QString::number(drift.norm())));
      }
    }
  }

  void wheelsAreHighlightedWithTheirMeshesAndShaftsWithTheirJoints() {
    GearCache cache;
    const Mechanism robot = paperRobot();
    const MechanismScenePtr stage = stageOf(robot, cache);
    const auto& instances = stage->scene.instances;
    for (const GearMesh& mesh : robot.gearMeshes) {
      for (const LinkId link : {mesh.tail, mesh.head}) {
        QCOMPARE(std::count_if(instances.begin(), instances.end(),
                               [&](const Instance& i) {
                                 return isWheelOf(i, mesh.id) && i.element == ElementId(link);
                               }),
                 1);
      }
    }
    for (const TurningJoint& joint : robot.turningJoints) {
      QCOMPARE(std::count_if(instances.begin(), instances.end(),
                             [&](const Instance& i) {
                               return isWheelOf(i, joint.id) && i.element == ElementId(joint.head);
                             }),
               1);
    }
  }

  void allPartsAreClosedAndTurnedOutwards() {
    GearCache cache;
    for (const Mechanism& mechanism : trains()) {
      const MechanismScenePtr stage = stageOf(mechanism, cache);
      for (const auto& solid : stage->scene.solids) QVERIFY(signedVolume(*solid) > 0);
    }
  }

  void anEditMakesOnlyWhatChangedAnew() {
    GearCache cache;
    const Mechanism robot = paperRobot();
    const MechanismScenePtr before = stageOf(robot, cache);
    const MechanismScenePtr after = stageOf(withOffset(robot, JointId("14"), Number(-44)).value(), cache);
    int kept = 0;
    for (const auto& solid : after->scene.solids) {
      kept += std::count(before->scene.solids.begin(), before->scene.solids.end(), solid) != 0;
    }
    QVERIFY2(kept >= 8, qPrintable(QString::number(kept)));  // the wheels; shafts are made anew
  }

  void everyWheelOfTheRobotCanBePickedWhereItIs() {
    GearCache cache;
    const MechanismScenePtr stage = stageOf(paperRobot(), cache);
    auto host = EglHost::create();
    QVERIFY(host.has_value());
    (*host)->setScene(stage->scene);
    Frame frame;
    frame.viewport = {500, 400};
    frame.style = RenderStyle::light();
    std::map<std::size_t, int> seen;
    for (const double yaw : {-0.5, 2.6}) {
      frame.camera = Camera::from(yaw, 0.3).fitted(cornersOf(stage->scene), frame.viewport);
      for (int y = 2; y < 400; y += 10) {
        for (int x = 2; x < 500; x += 10) {
          const auto hit = (*host)->pick(frame, x, y);
          if (!hit) continue;
          ++seen[hit->instance];
          const Instance& instance = stage->scene.instances[hit->instance];
          QCOMPARE(hit->element, instance.element);
          const Eigen::Vector3d local = instance.pose.inverse() * hit->point;
          QVERIFY(boundsOf(*stage->scene.solids[instance.solid]).exteriorDistance(local) < 0.6);
        }
      }
    }
    for (std::size_t i = 0; i < stage->scene.instances.size(); ++i) {
      const auto& also = stage->scene.instances[i].also;
      const bool wheel = !also.empty() && also.front().kind == ElementKind::gearMesh;
      if (wheel) QVERIFY2(seen[i] > 2, qPrintable(QString::number(i)));
    }
  }

  void aPictureShowsTheTrainAtItsTime() {
    GearCache cache;
    const MechanismScenePtr stage = stageOf(paperRobot(), cache);
    SceneRendering rendering;
    rendering.stage = stage;
    rendering.size = {300, 200};
    rendering.view.style = pictureStyle(Theme::light, false);
    const auto light = stagePicture(rendering);
    QVERIFY(light.has_value());
    QCOMPARE(light->width, 300);
    const auto differing = [&](const Image& image) {
      int count = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        count +=
            std::abs(image.rgba[i] - light->rgba[i]) + std::abs(image.rgba[i + 1] - light->rgba[i + 1]) > 30;
      }
      return count;
    };
    QCOMPARE(differing(*stagePicture(rendering)), 0);
    rendering.view.time = 1;
    QVERIFY(differing(*stagePicture(rendering)) > 1000);
    rendering.view.time = stage->period;
    QVERIFY(differing(*stagePicture(rendering)) < 20);
    rendering.view.style = pictureStyle(Theme::light, true);
    QCOMPARE(int(stagePicture(rendering)->at(2, 2)[3]), 0);
    rendering.size = {1'000'000, 10};
    const auto tooLarge = stagePicture(rendering);
    QVERIFY(!tooLarge.has_value());
    QCOMPARE(tooLarge.error().front().code, Code::graphics);
  }

  void trainsTooLargeForAPictureHaveNone() {
    GearCache cache;
    QVERIFY(stageOf(test::randomTree(1, kMaxStageLinks + 1, 10), cache)->scene.instances.empty());
    QVERIFY(!stageOf(test::planetary(24, 18, 3), cache)->scene.instances.empty());
  }

  void whatIsNoTrainYetIsStillShownOrEmpty() {
    GearCache cache;
    QVERIFY(stageOf(emptyMechanism(), cache)->scene.instances.empty());
    Mechanism loose = paperRobot();
    loose.turningJoints.pop_back();
    QVERIFY(stageOf(loose, cache)->scene.instances.empty());
    Mechanism undriven = paperRobot();
    undriven.inputs = std::vector<Input>{{JointId("8"), Number(1), {}}};
    const MechanismScenePtr still = stageOf(undriven, cache);
    QVERIFY(!still->scene.instances.empty());
    QVERIFY(!still->place);
    undriven.inputs.reset();  // then the program chooses
    QCOMPARE(stageOf(undriven, cache)->inputSpeeds.size(), std::size_t{3});
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const MechanismScenePtr stage = stageOf(test::randomTree(seed, static_cast<int>(seed % 12), 3), cache);
      for (const auto& solid : stage->scene.solids) {
        for (const Float3& p : solid->positions) QVERIFY(std::isfinite(p[0] + p[1] + p[2]));
      }
    }
  }

  /// The teeth would be invisible and fill the memory; a note in the view reports that they are left out.
  void wheelsOfVeryManyTeethAreShownWithoutThem() {
    Mechanism robot = paperRobot();
    for (GearMesh& mesh : robot.gearMeshes) {
      mesh.tailTeeth *= 1000;
      mesh.headTeeth *= 1000;
    }
    GearCache cache;
    const MechanismScenePtr stage = stageOf(robot, cache);
    QCOMPARE(stage->scene.instances.size(), stageOf(paperRobot(), cache)->scene.instances.size());
    QVERIFY(!stage->notes.empty());
    QVERIFY(stage->notes.front().text.find("18000 teeth") != std::string::npos);
    for (const auto& solid : stage->scene.solids) QVERIFY(solid->triangles.size() < 200'000);
    QVERIFY(stageOf(paperRobot(), cache)->notes.empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TrainStageTest)
#include "test_train_stage.moc"
