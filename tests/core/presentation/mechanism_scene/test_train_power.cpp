#include <QTest>

#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/power_overlay.h"
#include "core/presentation/mechanism_scene/scene_labels.h"
#include "core/presentation/mechanism_scene/train_power.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {
namespace {

struct Powered {
  test::StaticsCase train;
  StaticsReport report;
  MechanismScenePtr stage;

  Powered(Mechanism mechanism, const StaticsOptions& options)
      : train(std::move(mechanism)),
        report(*analyzeStatics(train.mechanism, train.model, train.placement, train.tt, train.analysis,
                               options)) {
    GearCache cache;
    stage = mechanismScene(*analyzeLive(std::make_shared<const Mechanism>(train.mechanism)), cache);
  }
  [[nodiscard]] PowerPicture picture(int observer = 0) const {
    return powerPicture(train.mechanism, train.model, train.placement, report, observer);
  }
  [[nodiscard]] ScenePower power(int observer = 0) const {
    return stagePower(picture(observer), train.mechanism, train.placement, *stage);
  }
};

/// Sun at 100 rad/s with 10 N m, ring held, carrier out.
Powered planetarySet(int planets = 1, bool stiffness = false) {
  Mechanism set = test::planetary(24, 18, planets);
  set.inputs = std::vector<Input>{{set.turningJoints[0].id, Number(100), {}},
                                  {set.turningJoints[1].id, Number(0), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{set.turningJoints[0].id, Number(10)}}};
  options.balances = {{set.turningJoints[1].id}, {set.turningJoints[2].id}};
  if (stiffness) options.sharing = LoadSharing::stiffness;
  return {set, options};
}

/// 10 N m at the pinion of a pair whose wheel is held by a balance.
Powered pair(double speed = 100) {
  Mechanism mechanism =
      test::TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40, MeshKind::external).build();
  mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(Rational(int(speed))), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{mechanism.turningJoints[0].id, Number(10)}}};
  options.balances = {{mechanism.turningJoints[1].id}};
  return {mechanism, options};
}

/// Sun and carrier joined by a countershaft: power goes round.
Powered closedTrain() {
  Mechanism mechanism = test::TrainSketch(5)
                            .joint(0, 1, "a")
                            .joint(0, 2, "a")
                            .joint(0, 3, "a")
                            .joint(2, 4, "b")
                            .joint(0, 5, "c")
                            .mesh(1, 4, 24, 18, MeshKind::external)
                            .mesh(4, 3, 18, 60, MeshKind::internal)
                            .mesh(2, 5, 40, 20, MeshKind::external)
                            .mesh(5, 1, 30, 30, MeshKind::external)
                            .build();
  mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[2].id, Number(1), {}}};
  StaticsOptions options;
  options.loads = {{{}, JointTorque{mechanism.turningJoints[2].id, Number(1)}}};
  options.balances = {{mechanism.turningJoints[1].id}};
  return {mechanism, options};
}

/// What arrows deliver to a link and take from it.
std::vector<double> sumsOf(const ScenePower& power, int links) {
  std::vector<double> sums(static_cast<std::size_t>(links));
  for (const PowerArrow& arrow : power.arrows) {
    if (arrow.giver) sums[static_cast<std::size_t>(*arrow.giver)] -= arrow.given;
    if (arrow.taker) sums[static_cast<std::size_t>(*arrow.taker)] += arrow.delivered;
  }
  return sums;
}

/// Of what bands show at an element.
double deliveredTo(const PowerPicture& picture, const ElementId& element, int link) {
  double sum = 0;
  for (const DrawnFlow& flow : picture.flows)
    if (flow.element == element)
      for (const DrawnPort& port : flow.ports)
        if (port.link == link) sum += port.power;
  return sum;
}

std::vector<const PowerArrow*> arrowsOf(const ScenePower& power, const ElementId& element) {
  std::vector<const PowerArrow*> found;
  for (const PowerArrow& arrow : power.arrows)
    if (arrow.element == element) found.push_back(&arrow);
  return found;
}

/// The drawing over a picture of 900 x 600.
DisplayList drawn(const Powered& train, const ScenePower& power,
                  const std::set<ElementId>& highlighted = {}) {
  std::vector<Pose> poses;
  for (const Instance& instance : train.stage->scene.instances) poses.push_back(instance.pose);
  const Viewport viewport{900, 600};
  const Bounds bounds = boundsOf(train.stage->scene);
  const std::vector<Eigen::Vector3d> corners{bounds.box.min(), bounds.box.max()};
  const Camera camera = Camera::home().fitted(corners, viewport, 0.4);
  return powerOver(power, {*train.stage, poses, {}, camera, viewport, 1, nullptr}, Pose::Identity(), 20,
                   highlighted);
}

std::vector<std::string> textsOf(const DisplayList& list) {
  std::vector<std::string> texts;
  for (const Mark& mark : list.marks)
    if (const auto* text = std::get_if<Text>(&mark.what)) texts.push_back(text->text);
  return texts;
}

bool has(const DisplayList& list, const std::string& words) {
  const auto texts = textsOf(list);
  return std::find(texts.begin(), texts.end(), words) != texts.end();
}

double widestOf(const DisplayList& list, const ElementId& element) {
  double widest = 0;
  for (const Mark& mark : list.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark.what); stroke != nullptr && mark.element == element &&
                                                              mark.role == MarkRole::line &&
                                                              stroke->tint != Tint(ColorRole::sheet))
      widest = std::max(widest, stroke->width);
  return widest;
}

}  // namespace

class TrainPowerTest : public QObject {
  Q_OBJECT

 private slots:
  /// Of every example under a load in each of its joints, seen from the ground and from a link: at every link
  /// the arrows deliver what they take, and at every element what the bands show.
  void arrowsOfAllExamplesSumAsTheBandsDo() {
    int trains = 0;
    int unknown = 0;
    for (const std::string& name : test::exampleNames()) {
      if (name == "robot-to-mend") continue;
      const Mechanism mechanism = test::example(name);
      for (const TurningJoint& joint : mechanism.turningJoints) {
        StaticsOptions options;
        options.loads = {{{}, JointTorque{joint.id, Number(10)}}};
        const Powered train(mechanism, options);
        for (const int observer : {0, train.train.model.n()}) {
          const ScenePower power = train.power(observer);
          if (power.picture.isEmpty() || train.stage->scene.instances.empty()) continue;
          ++trains;
          const double little = 1e-6 * power.picture.largest;
          for (const PowerArrow& arrow : power.arrows) {
            QVERIFY(arrow.given >= 0 && arrow.delivered >= 0 && (arrow.to - arrow.from).norm() > 1e-6);
            QVERIFY(arrow.giver || arrow.taker);
            unknown += arrow.isKnown ? 0 : 1;
          }
          bool isWhole = true;
          for (const DrawnFlow& flow : power.picture.flows) {
            QVERIFY2(!arrowsOf(power, flow.element).empty(), name.c_str());
            isWhole = isWhole && flow.isDetermined;
            if (!flow.isDetermined) continue;
            for (const DrawnPort& port : flow.ports) {
              double sum = 0;
              for (const PowerArrow* arrow : arrowsOf(power, flow.element))
                sum += (arrow->taker == port.link ? arrow->delivered : 0) -
                       (arrow->giver == port.link ? arrow->given : 0);
              QVERIFY2(std::abs(sum - deliveredTo(power.picture, flow.element, port.link)) <= little,
                       name.c_str());
            }
          }
          if (!isWhole) continue;
          const std::vector<double> sums = sumsOf(power, train.train.model.n() + 1);
          for (std::size_t link = 1; link < sums.size(); ++link)
            QVERIFY2(std::abs(sums[link]) <= little, (name + " " + std::to_string(link)).c_str());
        }
      }
    }
    QVERIFY2(trains > 30 && unknown > 0, qPrintable(QString("%1 %2").arg(trains).arg(unknown)));
  }

  /// From the driving gear to the driven one, whichever way they turn.
  void theArrowOfAMeshPointsFromTheDriverToTheDriven() {
    const Powered train = pair();
    const ScenePower power = train.power();
    const ElementId mesh = train.train.mechanism.gearMeshes[0].id;
    const auto arrows = arrowsOf(power, mesh);
    QCOMPARE(arrows.size(), std::size_t{1});
    QVERIFY(arrows[0]->giver == 1 && arrows[0]->taker == 2);
    QVERIFY(std::abs(arrows[0]->given - 1000) < 1e-9 && std::abs(arrows[0]->delivered - 1000) < 1e-9);
    QVERIFY(arrows[0]->tint == Tint::ofLink(1, 1));
    const MeshGeometry& geometry = *train.train.placement.meshes[0];
    const Vector3& wide = geometry.tailToHead;
    const Eigen::Vector3d way = (arrows[0]->to - arrows[0]->from).normalized();
    QVERIFY(way.dot(Eigen::Vector3d(wide[0], wide[1], wide[2]).normalized()) > 0.999);
    const Eigen::Vector3d middle = 0.5 * (arrows[0]->from + arrows[0]->to);
    const Vector3& pitch = geometry.pitchPoint;
    QVERIFY((middle - Eigen::Vector3d(pitch[0], pitch[1], pitch[2])).norm() < 1e-9);
    // Against its speed the torque takes power: the wheel drives.
    const Powered braked = pair(-100);
    const ScenePower backwards = braked.power();
    const auto reversed = arrowsOf(backwards, mesh);
    QVERIFY(reversed[0]->giver == 2 && reversed[0]->taker == 1);
    QVERIFY((reversed[0]->to - reversed[0]->from).normalized().dot(way) < -0.999);
  }

  /// An internal gear lies outside of the pitch point: towards it is outwards.
  void theArrowIntoARingPointsOutwards() {
    const Powered set = planetarySet();
    const ScenePower power = set.power(3);  // the carrier sees rolling alone
    const auto ring = arrowsOf(power, set.train.mechanism.gearMeshes[1].id);
    QCOMPARE(ring.size(), std::size_t{1});
    const MeshGeometry& geometry = *set.train.placement.meshes[1];
    const AxisLine& axis = set.train.placement.lineOfClass(geometry.headClass);
    const Eigen::Vector3d out(geometry.pitchPoint[0] - axis.point[0], geometry.pitchPoint[1] - axis.point[1],
                              0);
    const int ringLabel =
        geometry.tailRadius * geometry.tailRadius > geometry.headRadius * geometry.headRadius ? geometry.tail
                                                                                              : geometry.head;
    const double along = (ring[0]->to - ring[0]->from).normalized().dot(out.normalized());
    QVERIFY2(ring[0]->taker == ringLabel ? along > 0.99 : along < -0.99, qPrintable(QString::number(along)));
  }

  /// Power enters at the sun's end and leaves at the carrier's.
  void loadsAndBalancesAreInAndOut() {
    const Powered set = planetarySet();
    const ScenePower power = set.power();
    const auto in = arrowsOf(power, set.train.mechanism.turningJoints[0].id);
    const auto out = arrowsOf(power, set.train.mechanism.turningJoints[2].id);
    QCOMPARE(in.size(), std::size_t{1});
    QCOMPARE(out.size(), std::size_t{1});
    QVERIFY(!in[0]->giver && in[0]->taker == 1 && out[0]->giver && !out[0]->taker);
    QVERIFY(std::abs(in[0]->delivered - 1000) < 1e-6 && std::abs(out[0]->given - 1000) < 1e-6);
    // Both lie beyond the solids, and apart.
    const Eigen::Vector3d a = 0.5 * (in[0]->from + in[0]->to), b = 0.5 * (out[0]->from + out[0]->to);
    QVERIFY((a - b).norm() > 0.3 * boundsOf(set.stage->scene).radius());
    // The ring is at rest: nothing passes it.
    QVERIFY(arrowsOf(power, set.train.mechanism.turningJoints[1].id).empty());
  }

  void widthsAndWordsAreThoseOfTheBands() {
    const Powered set = planetarySet();
    const ScenePower power = set.power();
    const DisplayList list = drawn(set, power);
    QVERIFY(has(list, "1000 W") && has(list, "seen from the ground"));
    const auto texts = textsOf(list);
    QVERIFY(std::any_of(texts.begin(), texts.end(),
                        [](const std::string& each) { return each == "\u21921: 1000 W 100 %"; }));
    double most = 0;
    for (const PowerArrow& arrow : power.arrows) most = std::max(most, widestOf(list, arrow.element));
    QVERIFY(std::abs(widestOf(list, set.train.mechanism.turningJoints[0].id) - most) < 1e-9);
    QVERIFY(has(drawn(set, set.power(3)), "seen from link 3"));
    QVERIFY(drawn(set, {}).marks.empty());
  }

  void whatIsNotDeterminedOrAssumedIsTold() {
    const Powered open = planetarySet(3);
    const DisplayList unknown = drawn(open, open.power());
    QVERIFY(has(unknown, "? W: shared in unknown parts, not determined"));
    const auto dashed = [](const Mark& mark) {
      const auto* stroke = std::get_if<Stroke>(&mark.what);
      return stroke != nullptr && stroke->dash == Dash::dashed && mark.element != ElementId();
    };
    QVERIFY(std::any_of(unknown.marks.begin(), unknown.marks.end(), dashed));
    const Powered shared = planetarySet(3, true);
    const DisplayList assumed = drawn(shared, shared.power());
    QVERIFY(has(assumed, "* shared by equal stiffness: an assumption"));
    QVERIFY(std::none_of(assumed.marks.begin(), assumed.marks.end(), dashed));
    const auto texts = textsOf(assumed);
    QVERIFY(std::any_of(texts.begin(), texts.end(),
                        [](const std::string& each) { return each.find(" W*") != std::string::npos; }));
  }

  void whatCirculatesIsInAccent() {
    const Powered train = closedTrain();
    const ScenePower power = train.power();
    const DisplayList list = drawn(train, power);
    QVERIFY(has(list, "circulates: links 1, 2 and 5, meshes 11, 12, 13 and 14"));
    std::set<ElementId> inAccent;
    for (const Mark& mark : list.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark.what);
          stroke != nullptr && stroke->tint == Tint(ColorRole::accent) && mark.element != ElementId())
        inAccent.insert(mark.element);
    std::set<ElementId> round;
    for (const DrawnFlow& flow : power.picture.flows)
      for (const DrawnPort& port : flow.ports)
        if (port.circulating != 0) round.insert(flow.element);
    QVERIFY(!round.empty());
    QVERIFY(inAccent == round);
  }

  /// With `--show power` the drawing over a picture has them; a caption says why there are none.
  void theLabelsOfAPictureHaveThem() {
    const Powered set = planetarySet();
    SceneRendering rendering;
    rendering.stage = set.stage;
    rendering.size = {640, 480};
    auto painter = ScenePainter::create(rendering);
    QVERIFY(painter);
    (void)(*painter)->paint(0);
    OverlayChoice choice;
    choice.power = true;
    SceneLabels labels(choice);
    QVERIFY(textsOf(labels.over(**painter)).empty());
    labels.setPower(std::make_shared<const ScenePower>(set.power()));
    QVERIFY(has(labels.over(**painter), "seen from the ground"));
    labels.setPower(nullptr);
    labels.setCaption("None.");
    QCOMPARE(textsOf(labels.over(**painter)), std::vector<std::string>{"None."});
    SceneLabels without(OverlayChoice{});
    without.setPower(std::make_shared<const ScenePower>(set.power()));
    QVERIFY(without.over(**painter).marks.empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TrainPowerTest)
#include "test_train_power.moc"
