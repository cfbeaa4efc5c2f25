#include <QTest>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/arrow_flips.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/pose/link_twists.h"
#include "core/theory/pose/turning_lines.h"
#include "tests/core/support/snapshot_of.h"

using namespace geargraph;
using test::snapshotOf;

namespace {

using Whole = std::array<int, 3>;

Whole wholeSum(const Whole& a, int times, const Whole& b) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

NumberTriple tripleOf(const Whole& whole) {
  return {Number(Rational(whole[0])), Number(Rational(whole[1])), Number(Rational(whole[2]))};
}

MeshKind slideKind(const char* name) {
  return *meshKindFrom(name);
}

/// Writes mechanisms with slides down. Ids are counted.
class SlideSketch {
 public:
  SlideSketch() { m_mechanism = emptyMechanism(); }

  /// A link on `parent` and the joint between them; gives its number.
  int link(int parent, const Whole& point, const Whole& direction, JointKind kind, bool turned = false) {
    const int made = static_cast<int>(m_mechanism.links.size());
    m_mechanism.links.push_back({LinkId(std::to_string(made)), ""});
    const AxisId axis("a" + std::to_string(made));
    m_mechanism.axes.push_back({axis, tripleOf(point), tripleOf(direction)});
    TurningJoint joint{JointId("j" + std::to_string(made)), LinkId(std::to_string(parent)),
                       LinkId(std::to_string(made)), axis, Number()};
    if (turned) std::swap(joint.tail, joint.head);
    joint.kind = kind;
    m_mechanism.turningJoints.push_back(joint);
    return made;
  }

  GearMesh& mesh(int tail, int head, MeshKind kind) {
    GearMesh mesh;
    mesh.id = MeshId("m" + std::to_string(m_mechanism.gearMeshes.size()));
    mesh.tail = LinkId(std::to_string(tail));
    mesh.head = LinkId(std::to_string(head));
    mesh.kind = kind;
    m_mechanism.gearMeshes.push_back(mesh);
    return m_mechanism.gearMeshes.back();
  }

  GearMesh& rack(int tail, int head, int teeth, const Rational& module) {
    GearMesh& made = mesh(tail, head, slideKind("rack"));
    made.tailTeeth = made.headTeeth = teeth;
    made.module = Number(module);
    return made;
  }

  GearMesh& screw(int tail, int head, const Rational& lead) {
    GearMesh& made = mesh(tail, head, slideKind("screw"));
    made.tailTeeth = made.headTeeth = 1;
    made.lead = Number(lead);
    return made;
  }

  [[nodiscard]] Mechanism build() const { return m_mechanism; }

 private:
  Mechanism m_mechanism;
};

/// Three directions at right angles, of one length, from a whole quaternion.
std::array<Whole, 3> frameOf(std::mt19937& random) {
  std::uniform_int_distribution<int> any(-3, 3);
  int a = 0, b = 0, c = 0, d = 0;
  while (a * a + b * b + c * c + d * d == 0)
    a = any(random), b = any(random), c = any(random), d = any(random);
  return {Whole{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
          Whole{2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
          Whole{2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}};
}

/// Stages on carriers at random: racks straight and skewed, with helices; screws of both hands; gear pairs
/// whose wheels drive on. Every mesh closes a loop of its own.
Mechanism randomSlides(unsigned seed, bool withPi) {
  std::mt19937 random(seed);
  const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  SlideSketch sketch;
  int links = 1;
  const int stages = 2 + upTo(4);
  for (int stage = 0; stage < stages; ++stage) {
    const int carrier = upTo(links - 1);
    const auto [x, y, u] = frameOf(random);
    const Whole at{upTo(80) - 40, upTo(80) - 40, upTo(80) - 40};
    const bool isTurned = upTo(1) == 0;
    const int turning = sketch.link(carrier, at, u, JointKind::turning, isTurned);
    switch (upTo(2)) {
      case 0: {
        const Whole skewed = upTo(1) == 0 ? x : wholeSum({12 * x[0], 12 * x[1], 12 * x[2]}, 5, u);
        const int sliding = sketch.link(carrier, wholeSum(at, upTo(1) == 0 ? 1 : -1, y), skewed,
                                        JointKind::sliding, upTo(1) == 0);
        const bool isSwapped = upTo(1) == 0;
        GearMesh& mesh = sketch.rack(isSwapped ? sliding : turning, isSwapped ? turning : sliding,
                                     10 + upTo(40), Rational(1 + upTo(9), 4));
        if (withPi && upTo(1) == 0) std::swap(mesh.module, mesh.pitch);
        if (upTo(1) == 0) mesh.helixAngle = Number(Rational(5 + upTo(25)));
        if (upTo(1) == 0) mesh.hand = Hand::left;
        break;
      }
      case 1: {
        if (!withPi) break;
        const Whole along = upTo(1) == 0 ? u : Whole{-u[0], -u[1], -u[2]};
        const int sliding =
            sketch.link(carrier, wholeSum(at, upTo(1), y), along, JointKind::sliding, upTo(1) == 0);
        const bool isSwapped = upTo(1) == 0;
        GearMesh& mesh = sketch.screw(isSwapped ? sliding : turning, isSwapped ? turning : sliding,
                                      Rational(1 + upTo(9), 2));
        if (upTo(1) == 0) mesh.hand = Hand::left;
        break;
      }
      default: {
        const int other = sketch.link(carrier, wholeSum(at, 2, x), u, JointKind::turning, upTo(1) == 0);
        GearMesh& mesh = sketch.mesh(turning, other, MeshKind::external);
        mesh.tailTeeth = 12 + upTo(30);
        mesh.headTeeth = 12 + upTo(30);
      }
    }
    links = static_cast<int>(sketch.build().links.size());
  }
  return sketch.build();
}

/// The analysis of a mechanism without errors, on which both methods agree.
SnapshotPtr agreed(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  for (const Diagnostic& each : snapshot->diagnostics)
    if (each.severity() == Severity::error) throw std::runtime_error(each.message);
  if (!snapshot->solved || !snapshot->solved->agreement) throw std::runtime_error("no solution");
  const Agreement& agreement = *snapshot->solved->agreement;
  if (!agreement.equal) throw std::runtime_error("the methods disagree");
  return snapshot;
}

std::vector<PiNumber> ratesIn(const AnalysisSnapshot& snapshot) {
  if (snapshot.solved->pi) return snapshot.solved->pi->rates;
  std::vector<PiNumber> rates;
  for (const Rational& rate : snapshot.solved->exact->rates) rates.emplace_back(rate);
  return rates;
}

/// All joints' rates for these inputs at 1, 2, ..., each times its sign.
std::vector<PiNumber> ratesWith(Mechanism mechanism, const std::vector<int>& inputs,
                                const std::vector<int>& signs) {
  mechanism.inputs.emplace();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    mechanism.inputs->push_back(
        {mechanism.turningJoints[inputs[i]].id,
         Number(Rational(signs[static_cast<std::size_t>(inputs[i])] * (static_cast<int>(i) + 1))),
         {}});
  }
  return ratesIn(*agreed(mechanism));
}

/// The rate of a joint by its position, for a single input at 1.
std::string rateText(const Mechanism& mechanism, int joint) {
  return ratesIn(*agreed(mechanism))[static_cast<std::size_t>(joint)].toString();
}

std::vector<std::string> codesOf(const Mechanism& mechanism) {
  std::vector<std::string> codes;
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  for (const Diagnostic& each : snapshot->diagnostics) {
    codes.emplace_back(codeName(each.code));
  }
  return codes;
}

bool says(const Mechanism& mechanism, const char* code, const char* words) {
  const SnapshotPtr snapshot = snapshotOf(mechanism);
  for (const Diagnostic& each : snapshot->diagnostics) {
    if (codeName(each.code) == code && each.message.find(words) != std::string::npos) return true;
  }
  return false;
}

/// A pinion 1 about z and a slide 2 along x at y = 20.
SlideSketch pinionAndSlide() {
  SlideSketch sketch;
  sketch.link(0, {0, 0, 0}, {0, 0, 1}, JointKind::turning);
  sketch.link(0, {0, 20, 0}, {1, 0, 0}, JointKind::sliding);
  return sketch;
}

Mechanism simpleRack() {
  SlideSketch sketch = pinionAndSlide();
  sketch.rack(1, 2, 20, 2);
  return sketch.build();
}

/// A screw 1 about z and a nut 2 that slides along z.
Mechanism simpleScrew(Hand hand = Hand::right) {
  SlideSketch sketch;
  sketch.link(0, {0, 0, 0}, {0, 0, 1}, JointKind::turning);
  sketch.link(0, {10, 0, 0}, {0, 0, 1}, JointKind::sliding);
  sketch.screw(1, 2, 5).hand = hand;
  return sketch.build();
}

}  // namespace

class TestSlides : public QObject {
  Q_OBJECT
 private slots:
  void aRackTravelsByItsModule() {
    // The teeth at y = 20 move against x while the pinion turns forward about z.
    QCOMPARE(rateText(simpleRack(), 1), std::string("-20"));
    SlideSketch skewed;
    skewed.link(0, {0, 0, 0}, {0, 0, 1}, JointKind::turning);
    skewed.link(0, {0, -9, 0}, {12, 0, 5}, JointKind::sliding);
    GearMesh& mesh = skewed.rack(1, 2, 7, 2);
    mesh.helixAngle = Number(Rational(20));
    QCOMPARE(rateText(skewed.build(), 1), std::string("7"));
  }

  void aPitchTravelsByPi() {
    Mechanism rack = simpleRack();
    rack.gearMeshes.front().module.reset();
    rack.gearMeshes.front().pitch = Number(Rational(5));
    QCOMPARE(rateText(rack, 1), std::string("-50/pi"));
    rack.inputs = std::vector{Input{rack.turningJoints[1].id, Number(Rational(1)), {}}};
    QCOMPARE(rateText(rack, 0), std::string("-1/50*pi"));
  }

  void aNutComesBackFromARightHandScrew() {
    QCOMPARE(rateText(simpleScrew(), 1), std::string("-5/2/pi"));
    QCOMPARE(rateText(simpleScrew(Hand::left), 1), std::string("5/2/pi"));
  }

  void twoLeadsOnOneScrewMakeADifferentialScrew() {
    SlideSketch sketch;
    sketch.link(0, {0, 0, 0}, {0, 0, 1}, JointKind::sliding);
    sketch.link(1, {0, 0, 0}, {0, 0, 1}, JointKind::turning);
    sketch.link(1, {0, 0, 0}, {0, 0, 1}, JointKind::sliding);
    sketch.screw(2, 0, 5);
    sketch.screw(2, 3, 4);
    Mechanism mechanism = sketch.build();
    mechanism.inputs = std::vector{Input{mechanism.turningJoints[1].id, Number(Rational(1)), {}}};
    QCOMPARE(rateText(mechanism, 0), std::string("5/2/pi"));
    QCOMPARE(rateText(mechanism, 2), std::string("-2/pi"));
  }

  void numbersSymbolsAndMethodsAgree_data() {
    QTest::addColumn<bool>("withPi");
    QTest::newRow("modules") << false;
    QTest::newRow("with pi") << true;
  }
  void numbersSymbolsAndMethodsAgree() {
    QFETCH(bool, withPi);
    int compared = 0;
    int inPi = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
      const Mechanism mechanism = randomSlides(seed, withPi);
      const SnapshotPtr snapshot = agreed(mechanism);
      const std::vector<PiNumber> rates = ratesIn(*snapshot);
      const LiveSolution& live = *snapshot->matroid()->solution;
      for (std::size_t joint = 0; joint < rates.size(); ++joint) {
        const double exact = rates[joint].toDouble();
        const double number = live.rates[joint];
        QVERIFY2(std::abs(number - exact) <= 1e-9 * (1 + std::abs(exact)), qPrintable(QString::number(seed)));
      }
      if (!snapshot->solved->symbolic) continue;
      const SymbolicSolution& symbolic = *snapshot->solved->symbolic;
      for (std::size_t i = 0; i < symbolic.matrix.size(); ++i) {
        if (!symbolic.matrix[i]) continue;
        const Rational value = symbolic.matrix[i]->valueAt(symbolic.ring->values()).value();
        if (const auto& pi = snapshot->solved->pi) {
          const std::vector<PiNumber::Term>& terms = pi->matrix[i].terms();
          QVERIFY(terms.size() <= 1);
          QCOMPARE(value, terms.empty() ? Rational(0) : terms.front().factor);
          inPi += !terms.empty() && terms.front().power != 0 ? 1 : 0;
        } else {
          QCOMPARE(value, snapshot->solved->exact->matrix[i]);
        }
        ++compared;
      }
    }
    QVERIFY(compared > 150);
    QCOMPARE(inPi > 0, withPi);
  }

  /// The row of a mesh says that its two links have the same velocity along the line of action, in any pose.
  void pointsOfContactKeepTogetherAlongTheLineOfAction() {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> anyAngle(-3, 3);
    int seen = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
      const Mechanism mechanism = randomSlides(seed, true);
      const SnapshotPtr snapshot = agreed(mechanism);
      const Placement& placement = snapshot->kinematics->placement();
      const ForwardKinematics kinematics(*snapshot->tree, turningLines(placement));
      std::vector<double> angles(static_cast<std::size_t>(mechanism.t()));
      for (double& angle : angles) angle = anyAngle(random);
      const auto poses = kinematics.poses(angles);
      const auto twists =
          linkTwists(*snapshot->tree, kinematics, poses, snapshot->matroid()->solution->rates);
      for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
        const MeshGeometry& geometry = *placement.meshes[mesh];
        const Eigen::Isometry3d& carrier = poses[geometry.carrier];
        const Eigen::Vector3d point = carrier * Eigen::Vector3d(geometry.pitchPoint.data());
        const Eigen::Vector3d normal = carrier.linear() * Eigen::Vector3d(geometry.normal.data());
        const Eigen::Vector3d ofTail = twists[static_cast<std::size_t>(geometry.tail)].at(point);
        const Eigen::Vector3d ofHead = twists[static_cast<std::size_t>(geometry.head)].at(point);
        const double size = 1 + ofTail.norm() + ofHead.norm();
        QVERIFY2(std::abs(normal.dot(ofTail - ofHead)) <= 1e-9 * size, qPrintable(QString::number(seed)));
        seen += slides(geometry.kind) ? 1 : 0;
      }
    }
    QVERIFY(seen > 50);
  }

  /// Axes turned round, arrows exchanged and a mirror image change signs only.
  void sensesAreWhatTheyAreDrawn() {
    std::mt19937 random(4);
    for (unsigned seed = 1; seed <= 25; ++seed) {
      const Mechanism drawn = randomSlides(seed, true);
      const std::vector<int> inputs = agreed(drawn)->matroid()->choice.joints;
      const std::vector<int> none(static_cast<std::size_t>(drawn.t()), 1);
      const std::vector<PiNumber> rates = ratesWith(drawn, inputs, none);
      const auto isSame = [&](const Mechanism& changed, const std::vector<int>& signs) {
        const std::vector<PiNumber> found = ratesWith(changed, inputs, signs);
        for (std::size_t joint = 0; joint < found.size(); ++joint) {
          const PiNumber& was = rates[joint];
          if (!(found[joint] == (signs[joint] < 0 ? -was : was))) return false;
        }
        return true;
      };
      Mechanism reversed = drawn;
      std::vector<int> signs = none;
      for (int joint = 0; joint < drawn.t(); ++joint) {
        if (random() % 2 == 0) continue;
        for (Number& component : *reversed.axes[joint].direction) component = Number(-component.exact());
        signs[static_cast<std::size_t>(joint)] = -1;
      }
      QVERIFY2(isSame(reversed, signs), qPrintable(QString::number(seed)));

      Mechanism flipped = drawn;
      signs = none;
      for (int joint = 0; joint < drawn.t(); ++joint) {
        if (random() % 2 == 0) continue;
        flip(flipped.turningJoints[joint]);
        signs[static_cast<std::size_t>(joint)] = -1;
      }
      for (GearMesh& mesh : flipped.gearMeshes) flip(mesh);
      QVERIFY2(isSame(flipped, signs), qPrintable(QString::number(seed)));

      Mechanism mirrored = drawn;
      signs = none;
      for (Axis& axis : mirrored.axes) {
        (*axis.point)[0] = Number(-(*axis.point)[0].exact());
        (*axis.direction)[0] = Number(-(*axis.direction)[0].exact());
      }
      for (GearMesh& mesh : mirrored.gearMeshes)
        mesh.hand = mesh.hand == Hand::left ? Hand::right : Hand::left;
      for (int joint = 0; joint < drawn.t(); ++joint)
        if (!slides(drawn.turningJoints[joint])) signs[static_cast<std::size_t>(joint)] = -1;
      QVERIFY2(isSame(mirrored, signs), qPrintable(QString::number(seed)));
    }
  }

  void oldDocumentsKeepTheirVersion() {
    Mechanism plain = simpleRack();
    plain.gearMeshes.clear();
    QCOMPARE(fileVersionOf(plain), 2);
    plain.turningJoints[1].kind = JointKind::turning;
    QCOMPARE(fileVersionOf(plain), 1);
    for (const Mechanism& mechanism : {simpleRack(), simpleScrew(Hand::left)}) {
      const auto back = readMechanism(writeMechanism(mechanism));
      QVERIFY(back.has_value());
      QCOMPARE(*back == mechanism, true);
    }
  }

  void jointsAreOfOneKindInAClass() {
    // A screw that turns and slides about one line, through a link between.
    SlideSketch sketch;
    sketch.link(0, {0, 0, 0}, {0, 0, 1}, JointKind::sliding);
    sketch.link(1, {0, 0, 0}, {0, 0, 1}, JointKind::turning);
    sketch.link(1, {5, 0, 0}, {0, 0, -1}, JointKind::sliding);
    const SnapshotPtr snapshot = snapshotOf(sketch.build());
    const AxisGroups& classes = *snapshot->kinematics->placement().classes;
    QCOMPARE(classes.classes.size(), std::size_t(2));
    QCOMPARE(int(classes.classOf[0]), int(classes.classOf[2]));
    QCOMPARE(classes.orientationSign[2], -1);
    QCOMPARE(snapshot->kinematics->ttGraph->levels().count(), 2);
  }

  void whatDoesNotFitIsSaid() {
    Mechanism rack = simpleRack();
    rack.turningJoints[1].kind = JointKind::turning;
    QVERIFY(says(rack, "pitch-geometry", "both of its sides turn"));
    rack = simpleRack();
    rack.turningJoints[0].kind = JointKind::sliding;
    QVERIFY(says(rack, "pitch-geometry", "both of its sides slide"));
    rack = simpleRack();
    rack.gearMeshes.front().kind = MeshKind::external;
    rack.gearMeshes.front().module.reset();
    QVERIFY(says(rack, "pitch-geometry", "one of its gears slides"));
    rack = simpleRack();
    rack.axes[1].direction = tripleOf({0, 0, 1});
    QVERIFY(says(rack, "pitch-geometry", "slides along the axis of its pinion"));
    Mechanism screw = simpleScrew();
    screw.axes[1].direction = tripleOf({1, 0, 0});
    QVERIFY(says(screw, "pitch-geometry", "does not slide along the axis"));
    rack = simpleRack();
    rack.gearMeshes.front().pitchPoint = tripleOf({0, 21, 0});
    QVERIFY(says(rack, "teeth-geometry", "off the place"));
    rack.gearMeshes.front().pitchPoint = tripleOf({0, -20, 7});
    QCOMPARE(rateText(rack, 1), std::string("20"));
    rack = simpleRack();
    rack.axes[1].direction = tripleOf({1, 0, 1});
    rack.gearMeshes.front().helixAngle = Number(Rational(45));
    rack.gearMeshes.front().hand = Hand::left;
    QVERIFY(says(rack, "teeth-geometry", "run along the slide"));
  }

  void membersThatDoNotFitAreRejected() {
    const auto isRejected = [](const Mechanism& mechanism, const char* words) {
      for (const Diagnostic& each : wellFormedDiagnostics(mechanism))
        if (each.message.find(words) != std::string::npos) return true;
      return false;
    };
    Mechanism rack = simpleRack();
    rack.gearMeshes.front().module.reset();
    QVERIFY(isRejected(rack, "a module or a pitch"));
    rack = simpleRack();
    rack.gearMeshes.front().pitch = Number(Rational(6));
    QVERIFY(isRejected(rack, "a module or a pitch"));
    rack = simpleRack();
    rack.gearMeshes.front().module = Number(Rational(1, 1'000'003));
    QVERIFY(isRejected(rack, "two whole numbers"));
    rack = simpleRack();
    rack.gearMeshes.front().lead = Number(Rational(6));
    QVERIFY(isRejected(rack, "Only a screw"));
    Mechanism screw = simpleScrew();
    screw.gearMeshes.front().lead.reset();
    QVERIFY(isRejected(screw, "needs a lead"));
    screw.gearMeshes.front().lead = Number(Rational(-1));
    QVERIFY(isRejected(screw, "above 0"));
    screw = simpleScrew();
    screw.gearMeshes.front().module = Number(Rational(2));
    QVERIFY(isRejected(screw, "no module"));
  }

  void mixedPowersOfPiHaveNoNumbers() {
    // Bevel gears tie a pinion about z to a screw about x; both drive one slide.
    SlideSketch sketch = pinionAndSlide();
    const int screw = sketch.link(0, {0, 0, 0}, {1, 0, 0}, JointKind::turning);
    GearMesh& bevel = sketch.mesh(1, screw, MeshKind::bevel);
    bevel.tailTeeth = bevel.headTeeth = 20;
    sketch.rack(1, 2, 20, 2);
    sketch.screw(screw, 2, 5);
    const Mechanism mixed = sketch.build();
    const std::vector<std::string> codes = codesOf(mixed);
    QVERIFY(std::find(codes.begin(), codes.end(), "pi-mixed") != codes.end());
    QVERIFY(snapshotOf(mixed)->matroid() == nullptr);
    // By its pitch the rack has pi as well: a loop that only its numbers lock.
    Mechanism alike = mixed;
    alike.gearMeshes[1].module.reset();
    alike.gearMeshes[1].pitch = Number(Rational(6));
    const std::vector<std::string> locked = codesOf(alike);
    QVERIFY(std::find(locked.begin(), locked.end(), "pi-mixed") == locked.end());
    QCOMPARE(snapshotOf(alike)->matroid()->dof, 0);
    // 1/8 a turn of the pitch is the lead of 1: both say the same then.
    alike.gearMeshes[1].pitch = Number(Rational(1, 4));
    const int same = snapshotOf(alike)->matroid()->dof;
    alike.gearMeshes[2].hand = Hand::left;
    QCOMPARE(same + snapshotOf(alike)->matroid()->dof, 1);
  }
};

QTEST_APPLESS_MAIN(TestSlides)
#include "test_slides.moc"
