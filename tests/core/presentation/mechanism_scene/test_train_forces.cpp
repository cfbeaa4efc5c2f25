#include <QTest>

#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/mechanism_scene/forces_caption.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_labels.h"
#include "core/presentation/mechanism_scene/train_forces.h"
#include "core/presentation/scene3d/force_arrow_shape.h"
#include "core/presentation/scene3d/scene_view.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {
namespace {

/// Sun driven with 10 N m, ring held, carrier out.
struct LoadedSet {
  Mechanism mechanism = test::planetary(24, 18);
  std::optional<test::StaticsCase> train;
  std::optional<StaticsReport> report;
  std::vector<SceneForce> forces;
  GearCache cache;
  MechanismScenePtr stage;

  explicit LoadedSet(const Number& torque = Number(10)) {
    const auto& joints = mechanism.turningJoints;
    mechanism.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    train.emplace(mechanism);
    StaticsOptions options;
    options.loads = {{{}, JointTorque{joints[0].id, torque}}};
    options.balances = {{joints[1].id}, {joints[2].id}};
    report =
        analyzeStatics(train->mechanism, train->model, train->placement, train->tt, train->analysis, options);
    forces = stageForces(mechanism, train->placement, *report);
    stage = mechanismScene(*analyzeLive(std::make_shared<const Mechanism>(mechanism)), cache);
  }
  [[nodiscard]] std::vector<Pose> poses() const {
    std::vector<Pose> all;
    for (const Instance& instance : stage->scene.instances) all.push_back(instance.pose);
    return all;
  }
};

}  // namespace

class TrainForcesTest : public QObject {
  Q_OBJECT

 private slots:
  void forcesOfMeshesAndJoints() {
    const LoadedSet set;
    QCOMPARE(set.forces.size(), std::size_t{2 + 4});
    for (std::size_t mesh = 0; mesh < 2; ++mesh) {
      const SceneForce& force = set.forces[mesh];
      QVERIFY(force.kind == ForceKind::tooth);
      QVERIFY(force.link == ElementId(set.mechanism.links[3].id));  // both mesh on the carrier
      const Vector3& tooth = set.report->forces.meshes[mesh].force;
      QVERIFY((force.force - Eigen::Vector3d(tooth[0], tooth[1], tooth[2])).norm() < 1e-9);
    }
    QVERIFY(set.forces[0].text.starts_with("mesh 9: ") && set.forces[0].text.ends_with(" N"));
    QVERIFY(set.forces[2].text.starts_with("joint 5: "));
    QVERIFY(!set.forces[2].link);  // it turns on the ground
    // At the joint of the planet the pin carries both meshes.
    const Eigen::Vector3d pin = set.forces[5].force;
    QVERIFY(pin.norm() > set.forces[0].force.norm());
  }

  void arrowsAreAsLongAsTheirForces() {
    const LoadedSet set;
    const auto arrows = forceArrows(*set.stage, set.forces, set.poses(), Pose::Identity());
    QVERIFY(arrows.size() >= 3);
    const double radius = boundsOf(set.stage->scene).radius();
    double longest = 0;
    for (const ForceArrow& arrow : arrows) {
      const double length = (arrow.to - arrow.from).norm();
      longest = std::max(longest, length);
      const Eigen::Vector3d& force = set.forces[arrow.force].force;
      QVERIFY(((arrow.to - arrow.from).normalized() - force.normalized()).norm() < 1e-9);
      QVERIFY((arrow.from - set.forces[arrow.force].point).norm() < 1e-9);
    }
    QVERIFY(std::abs(longest - 0.34 * radius) < 1e-9 * radius);
    const LoadedSet twice(Number(20));
    const auto same = forceArrows(*twice.stage, twice.forces, twice.poses(), Pose::Identity());
    for (std::size_t i = 0; i < arrows.size(); ++i) QVERIFY((same[i].to - arrows[i].to).norm() < 1e-9);
  }

  /// A force of a mesh goes round with the carrier.
  void forcesMoveWithTheirLinks() {
    const LoadedSet set;
    std::vector<Pose> poses = set.poses();
    const std::vector<double> angles{1.0, 0.0};
    set.stage->place(angles, poses);
    const auto still = forceArrows(*set.stage, set.forces, set.poses(), Pose::Identity());
    const auto turned = forceArrows(*set.stage, set.forces, poses, Pose::Identity());
    QCOMPARE(still.size(), turned.size());
    QVERIFY((still[0].from - turned[0].from).norm() > 1);
    QVERIFY(std::abs((still[0].to - still[0].from).norm() - (turned[0].to - turned[0].from).norm()) < 1e-9);
  }

  /// What is missing and why, for pictures; under which loads, where nothing is drawn at all.
  void captionsTellWhatIsMissing() {
    const LoadedSet set;
    QCOMPARE(forcesCaption(set.mechanism, &*set.report), std::string());
    QCOMPARE(loadsCaption(set.mechanism, &*set.report), std::string("Loads: joint 5: 10 N m."));
    QVERIFY(forcesCaption(set.mechanism, nullptr).starts_with("No forces without loads"));
    QVERIFY(loadsCaption(set.mechanism, nullptr).empty());
    StaticsOptions options;
    options.loads = {{{}, JointTorque{set.mechanism.turningJoints[0].id, Number(-10)}}};
    options.balances = {{set.mechanism.turningJoints[1].id}, {set.mechanism.turningJoints[2].id}};
    const auto captionOf = [&](Mechanism mechanism) {
      const test::StaticsCase train(std::move(mechanism));
      const auto report =
          analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis, options);
      return forcesCaption(train.mechanism, &*report);
    };
    Mechanism odd = set.mechanism;
    odd.unit = "ell";
    QVERIFY(captionOf(odd).starts_with("Forces need a unit of length"));
    options.balances = {{set.mechanism.turningJoints[1].id}};
    QVERIFY(captionOf(set.mechanism).starts_with("No forces: the loads are not in balance"));
    Mechanism planets = test::planetary(24, 18, 3);
    options.loads = {{{}, JointTorque{planets.turningJoints[0].id, Number(10)}}};
    options.balances = {{planets.turningJoints[1].id}, {planets.turningJoints[2].id}};
    const std::string open = captionOf(planets);
    QVERIFY2(open.starts_with("Not drawn, as shared in unknown parts: forces at meshes"), open.c_str());
    options.sharing = LoadSharing::stiffness;
    QCOMPARE(captionOf(planets), std::string("Shared by equal stiffness of all teeth: an assumption."));
  }

  /// A caption is wrapped to the picture, on plates, below the legend where there is one.
  void captionsAreInThePicture() {
    const LoadedSet set;
    for (const bool hasArrows : {true, false}) {
      SceneRendering rendering;
      rendering.stage = set.stage;
      rendering.size = {260, 200};
      rendering.view.marks.forces = true;
      if (hasArrows) rendering.view.forces = std::make_shared<const std::vector<SceneForce>>(set.forces);
      auto painter = ScenePainter::create(rendering);
      QVERIFY(painter);
      (void)(*painter)->paint(0);
      OverlayChoice choice;
      choice.forces = true;
      SceneLabels labels(choice);
      const auto textsOf = [&] {
        std::vector<Text> texts;
        for (const Mark& mark : labels.over(**painter).marks)
          if (const auto* text = std::get_if<Text>(&mark.what)) texts.push_back(*text);
        return texts;
      };
      const std::size_t without = textsOf().size();
      const std::string words =
          "Not drawn, as shared in unknown parts: forces at meshes 9, 10, 11, reactions in joints 5, 6.";
      labels.setCaption(words);
      const std::vector<Text> texts = textsOf();
      QVERIFY(texts.size() >= without + 2);
      std::string joined;
      for (std::size_t i = without; i < texts.size(); ++i) {
        joined += (joined.empty() ? "" : " ") + texts[i].text;
        const double half = textWidth(texts[i].text, texts[i].size, texts[i].bold) / 2;
        QVERIFY(texts[i].center.x - half >= 0 && texts[i].center.x + half <= 260);
        if (i > 0) QVERIFY(texts[i].center.y > texts[i - 1].center.y || i == without);
      }
      QCOMPARE(joined, words);
    }
  }

  void theViewShowsThemWhereItsMarksWantThem() {
    const LoadedSet set;
    SceneView view;
    view.forces = std::make_shared<const std::vector<SceneForce>>(set.forces);
    SeenStage seen(set.stage);
    seen.show(view);
    QVERIFY(seen.forceArrows().empty() && seen.frame({400, 300}, 1).marks.empty());
    view.marks.forces = true;
    seen.show(view);
    QVERIFY(!seen.forceArrows().empty());
    QCOMPARE(seen.frame({400, 300}, 1).marks.size(), 2 * seen.forceArrows().size());  // cased shafts
  }

  /// Shaft and head from where the force acts to the tip; along the line of sight a disc.
  void arrowsOfThePicture() {
    const LoadedSet set;
    const auto poses = set.poses();
    const Viewport viewport{900, 600};
    const Bounds bounds = boundsOf(set.stage->scene);
    const std::vector<Eigen::Vector3d> corners{bounds.box.min(), bounds.box.max()};
    const Camera camera = Camera::home().fitted(corners, viewport, 0.2);
    const LabelGround ground{*set.stage, poses, {}, camera, viewport, 2, nullptr};
    for (const ForceArrow& arrow : forceArrows(*set.stage, set.forces, poses, Pose::Identity())) {
      const ForceArrowShape shape = forceArrowShape(arrow, ground);
      const Eigen::Vector2d from = ground.project(arrow.from), tip = ground.project(arrow.to);
      QVERIFY((shape.from - from).norm() < 1e-9);
      QVERIFY(shape.isDisc == ((tip - from).norm() < 6));
      if (shape.isDisc) continue;
      QVERIFY((shape.head[0] - tip).norm() < 1e-9);
      // The neck is on the way to the tip, in the middle between the wings.
      QVERIFY((0.5 * (shape.head[1] + shape.head[2]) - shape.neck).norm() < 1e-9);
      const double walked = (shape.neck - from).dot((tip - from).normalized());
      QVERIFY(walked > 0 && walked < (tip - from).norm());
      QVERIFY(std::abs((shape.neck - from).norm() - walked) < 1e-9);
    }
    const Eigen::Vector3d middle = bounds.box.center();
    const Eigen::Vector3d sight = camera.right().cross(camera.up());
    QVERIFY(forceArrowShape({0, middle, middle + sight}, ground).isDisc);
  }

  void labelsOfTheGreatestForcesTouchNothing() {
    const LoadedSet set;
    const auto poses = set.poses();
    const auto arrows = forceArrows(*set.stage, set.forces, poses, Pose::Identity());
    const Viewport viewport{900, 600};
    const Bounds bounds = boundsOf(set.stage->scene);
    const std::vector<Eigen::Vector3d> corners{bounds.box.min(), bounds.box.max()};
    const Camera camera = Camera::home().fitted(corners, viewport, 0.2);
    const LabelGround ground{*set.stage, poses, {}, camera, viewport, 1, nullptr};
    const auto widthOf = [](const std::string& text) { return 7.0 * static_cast<double>(text.size()); };
    const auto labels = placeForceLabels(set.forces, arrows, {}, ground, widthOf);
    QVERIFY(labels.size() >= 2 && labels.size() <= kMaxForceLabels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Eigen::Vector2d apart = (labels[i].middle - labels[j].middle).cwiseAbs();
        const Eigen::Vector2d room = labels[i].half + labels[j].half;
        QVERIFY(apart.x() >= room.x() || apart.y() >= room.y());
      }
      if (i > 0)
        QVERIFY(set.forces[labels[i].force].force.norm() <=
                set.forces[labels[i - 1].force].force.norm() * (1 + 1e-6));
    }
    // Strips for controls stay free: one that ends where the lowest of these labels does.
    LabelGround narrow = ground;
    for (const ForceLabel& label : labels)
      narrow.above = std::max(narrow.above, label.middle.y() + label.half.y());
    narrow.below = 30;
    for (const ForceLabel& label : placeForceLabels(set.forces, arrows, {}, narrow, widthOf)) {
      QVERIFY(label.middle.y() - label.half.y() >= narrow.above);
      QVERIFY(label.middle.y() + label.half.y() <= 600 - narrow.below);
    }
    // What is pointed at comes first.
    const auto& last = set.forces[arrows.back().force];
    const auto highlighted = placeForceLabels(set.forces, arrows, {last.element}, ground, widthOf);
    QVERIFY(!highlighted.empty() && set.forces[highlighted.front().force].element == last.element);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TrainForcesTest)
#include "test_train_forces.moc"
