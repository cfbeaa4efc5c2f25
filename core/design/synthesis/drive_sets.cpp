#include "core/design/synthesis/drive_sets.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
namespace {

Diagnostics driveRejection(Detail detail, std::string message) {
  Diagnostic why;
  why.code = codeOf(detail);
  why.detail = detail;
  why.message = std::move(message);
  return {why};
}

Diagnostics driveRejection(Code code, std::string message) {
  Diagnostic why;
  why.code = code;
  why.message = std::move(message);
  return {why};
}

Diagnostics tooFewPins() {
  return driveRejection(Detail::teethAgainstRadii, translated("A cycloidal disc runs on 4 pins or more."));
}

constexpr int kFewestPins = 4;
const NumberTriple kAlongZ{Number(0), Number(0), Number(1)};

NumberTriple aside(const Number& distance) {
  return {distance, Number(0), Number(0)};
}

/// A driven pinion and the gear that it turns, both on the ground; `teeth`: of the pinion and of the gear.
Expected<Mechanism> pinionAndGear(std::string title, std::pair<int, int> teeth, std::string gearName,
                                  MeshKind kind) {
  SetSketch set(std::move(title));
  const LinkOrdinal pinion = set.link(0, "a", translated("pinion"));
  const LinkOrdinal gear = set.link(0, "b", std::move(gearName));
  set.mesh(pinion, gear, teeth.first, teeth.second, kind);
  set.input(pinion, Number(1));
  return std::move(set).build();
}

}  // namespace

Expected<Mechanism> wormStage(const WormStage& stage) {
  if (stage.starts < 1 || stage.starts > kMaxStarts || stage.starts >= stage.teeth) {
    return driveRejection(Detail::wormTeeth,
                          translated("A worm has 1 to %1 starts, fewer than its wheel has teeth.",
                                     {std::to_string(kMaxStarts)}));
  }
  SetSketch set(translated("Worm stage"));
  const LinkOrdinal worm = set.link(0, "a", translated("worm"));
  const LinkOrdinal wheel = set.link(0, "b", translated("worm wheel"));
  GearMesh& mesh = set.mesh(worm, wheel, stage.starts, stage.teeth, MeshKind::worm);
  if (stage.hand == Hand::left) mesh.hand = Hand::left;
  set.input(worm, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> faceDrive(int pinionTeeth, int faceTeeth) {
  if (pinionTeeth >= faceTeeth) {
    return driveRejection(Detail::teethAgainstRadii,
                          translated("A face gear has more teeth than its pinion."));
  }
  return pinionAndGear(translated("Face gear drive"), {pinionTeeth, faceTeeth}, translated("face gear"),
                       MeshKind::faceGear);
}

Expected<Mechanism> hypoidAxle(int pinionTeeth, int gearTeeth) {
  if (pinionTeeth >= gearTeeth) {
    return driveRejection(Detail::teethAgainstRadii,
                          translated("The gear of an axle has more teeth than its pinion."));
  }
  return pinionAndGear(translated("Hypoid axle"), {pinionTeeth, gearTeeth}, translated("axle gear"),
                       MeshKind::hypoid);
}

Expected<Mechanism> beltStage(const BeltStage& stage) {
  if (stage.pitch.value() <= 0)
    return driveRejection(Detail::beltGeometry, translated("The pitch of a belt is above 0."));
  SetSketch set(translated("Belt drive"));
  // Three diameters of the larger pulley, p z / pi: in whole pitches.
  const Rational apart = stage.pitch.exact() * Rational(std::max(stage.driver, stage.driven));
  set.axis("a", aside(Number(0)), kAlongZ);
  set.axis("b", aside(Number(apart)), kAlongZ);
  const LinkOrdinal driver = set.link(0, "a", translated("driving pulley"));
  const LinkOrdinal driven = set.link(0, "b", translated("driven pulley"));
  GearMesh& belt = set.mesh(driver, driven, stage.driver, stage.driven, MeshKind::belt);
  belt.pitch = stage.pitch;
  belt.crossed = stage.crossed;
  set.input(driver, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> strainWave(int flexTeeth, int circularTeeth) {
  if (circularTeeth <= flexTeeth) {
    return driveRejection(Detail::equalInternalTeeth,
                          translated("The circular spline has more teeth than the flexspline, usually two."));
  }
  SetSketch set(translated("Strain wave drive"));
  set.axis("a", aside(Number(0)), kAlongZ);
  set.axis("x", aside(Number(Rational(circularTeeth - flexTeeth, 2))), kAlongZ);  // a module of 1
  const LinkOrdinal wave = set.link(0, "a", translated("wave generator"));
  const LinkOrdinal flexspline = set.link(wave, "x", translated("flexspline"));
  const LinkOrdinal cup = set.link(0, "a", translated("output"));
  set.mesh(flexspline, 0, flexTeeth, circularTeeth, MeshKind::internal);
  set.mesh(flexspline, cup, 1, 1, MeshKind::pins);
  set.input(wave, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> cycloidalDrive(int pins) {
  if (pins < kFewestPins) return tooFewPins();
  SetSketch set(translated("Cycloidal drive"));
  set.axis("a", aside(Number(0)), kAlongZ);
  set.axis("x", aside(Number(1)), kAlongZ);
  const LinkOrdinal crank = set.link(0, "a", translated("crank"));
  const LinkOrdinal disc = set.link(crank, "x", translated("cycloidal disc"));
  const LinkOrdinal output = set.link(0, "a", translated("output"));
  set.mesh(disc, 0, pins - 1, pins, MeshKind::internal);
  set.mesh(disc, output, 1, 1, MeshKind::pins);
  set.input(crank, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> rvReducer(int sunTeeth, int planetTeeth, int pins) {
  if (pins < kFewestPins) return tooFewPins();
  SetSketch set(translated("RV reducer"));
  set.axis("a", aside(Number(0)), kAlongZ);
  set.axis("p", aside(Number(Rational(sunTeeth + planetTeeth, 2))), kAlongZ);  // a module of 1
  set.axis("x", aside(Number(Rational(3, 2))), kAlongZ);
  const LinkOrdinal sun = set.link(0, "a", translated("sun"));
  const LinkOrdinal output = set.link(0, "a", translated("output"));
  const LinkOrdinal planet = set.link(output, "p", translated("planet"));
  const LinkOrdinal eccentric = set.link(output, "a", translated("eccentric"));
  const LinkOrdinal disc = set.link(eccentric, "x", translated("cycloidal disc"));
  set.mesh(sun, planet, sunTeeth, planetTeeth, MeshKind::external);
  set.mesh(planet, eccentric, 1, 1, MeshKind::pins);
  set.mesh(disc, 0, pins - 1, pins, MeshKind::internal);
  set.mesh(disc, output, 1, 1, MeshKind::pins);
  set.input(sun, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> rackDrive(const RackDrive& drive) {
  if (drive.module.value() <= 0 || drive.travel.value() <= 0)
    return driveRejection(Code::schema, translated("Travel and module of a rack are above 0."));
  const double wanted = drive.travel.value() / (std::numbers::pi * drive.module.value());
  if (wanted < kFewestPinionTeeth - 0.5 || wanted >= kMostPinionTeeth + 0.5) {
    return driveRejection(
        Detail::teethAgainstRadii,
        translated(
            "A pinion of this module has %1 teeth for this travel a turn, and %2 to %3 fit.",
            {readableNumber(wanted), std::to_string(kFewestPinionTeeth), std::to_string(kMostPinionTeeth)}));
  }
  const int teeth = static_cast<int>(std::lround(wanted));
  SetSketch set(translated("Rack drive"));
  const Rational radius = drive.module.exact() * Rational(teeth, 2);
  set.axis("a", aside(Number(0)), kAlongZ);
  set.axis("b", {Number(0), Number(radius), Number(0)}, aside(Number(1)));
  const LinkOrdinal pinion = set.link(0, "a", translated("pinion"));
  const LinkOrdinal rack = set.slidingLink(0, "b", translated("rack"));
  set.mesh(pinion, rack, teeth, 2 * teeth, MeshKind::rack).module = drive.module;
  set.input(pinion, Number(1));
  return std::move(set).build();
}

Expected<Mechanism> screwDrive(const ScrewDrive& drive) {
  if (drive.lead.value() <= 0)
    return driveRejection(Code::schema, translated("The lead of a screw is above 0."));
  SetSketch set(translated("Screw drive"));
  set.axis("a", aside(Number(0)), kAlongZ);
  const LinkOrdinal screw = set.link(0, "a", translated("screw"));
  const LinkOrdinal nut = set.slidingLink(0, "a", translated("nut"));
  GearMesh& mesh = set.mesh(screw, nut, 1, 1, MeshKind::screw);
  mesh.lead = drive.lead;
  if (drive.hand == Hand::left) mesh.hand = Hand::left;
  set.input(screw, Number(1));
  return std::move(set).build();
}

std::optional<SetRatio> ratioOfSet(const Mechanism& set) {
  if (!set.inputs || set.inputs->size() != 1) return std::nullopt;
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(set));
  const MatroidAnalysis* matroid = snapshot->matroid();
  if (matroid == nullptr || !matroid->solution || hasErrors(snapshot->diagnostics)) return std::nullopt;
  const SolvedKinematicsPtr solved = solvedKinematics(set, *snapshot->kinematics, {.symbolic = false});
  if (!solved->exact && !solved->pi) return std::nullopt;
  SetRatio ratio;
  const auto linkOf = [&](LinkId id) {
    const auto found =
        std::find_if(set.links.begin(), set.links.end(), [&](const Link& link) { return link.id == id; });
    return static_cast<LinkOrdinal>(found - set.links.begin());
  };
  PiNumber inputSpeed;
  for (JointOrdinal joint = 0; joint < set.t(); ++joint) {
    const TurningJoint& drawn = set.turningJoints[joint];
    if (drawn.tail != set.links.front().id) continue;
    const PiNumber speed = solved->exact ? PiNumber(solved->exact->rates[joint]) : solved->pi->rates[joint];
    if (drawn.id == set.inputs->front().joint) {
      ratio.input = linkOf(drawn.head);
      inputSpeed = speed;
    } else if (!speed.isZero()) {
      ratio.output = linkOf(drawn.head);
      ratio.speed = speed;
      ratio.slides = slides(drawn);
    }
  }
  if (!inputSpeed.isRational() || inputSpeed.isZero() || int{ratio.output} == 0) return std::nullopt;
  ratio.speed *= Rational(1) / inputSpeed.rational();
  return ratio;
}

}  // namespace geargraph
