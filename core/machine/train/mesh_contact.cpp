#include "core/machine/train/mesh_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/involute.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_wheels.h"

namespace geargraph {
namespace {

/// A gear in its transverse plane, a bevel on its back cone. Lengths in its module.
struct PlaneGear {
  double teeth = 0;  ///< real ones; virtual of a bevel
  double tip = 0;
  bool isRing = false;
};

PlaneGear planeGear(const GearSpec& spec) {
  if (isConical(spec)) {
    const double teeth = spec.teeth / wheelKind(spec.kind).shareOfVirtual(spec);
    return {teeth, teeth / 2 + spec.addendum + spec.profileShift, teeth < 0};
  }
  return {static_cast<double>(spec.teeth), nominalTipRadius(spec) / spec.module, isRing(spec)};
}

/// From the pitch point to where contact ends at this gear's tip, in base pitches: no further than where the
/// line of action touches the partner's base circle.
double addendumRatio(const PlaneGear& gear, const PlaneGear& partner, double pressureAngle, double working) {
  const double base = gear.teeth / 2 * std::cos(pressureAngle);
  const double onTip = std::sqrt(std::max(gear.tip * gear.tip - base * base, 0.0));
  const double atPitchPoint = base * std::tan(working);
  const double length = gear.isRing ? atPitchPoint - onTip : onTip - atPitchPoint;
  const double pitch = std::numbers::pi * std::cos(pressureAngle);
  const double limit =
      partner.isRing ? length : partner.teeth / 2 * std::cos(pressureAngle) * std::tan(working);
  return std::clamp(length, 0.0, std::max(limit, 0.0)) / pitch;
}

/// A pinion on its face gear, which is a rack where their pitch circles touch.
MeshContact rackContact(const GearSpec& pinion, const GearSpec& face, bool isTailFace) {
  const PlaneGear gear = planeGear(pinion);
  const double angle = pinion.pressureAngle;
  const double base = gear.teeth / 2 * std::cos(angle);
  const double atPitchPoint = base * std::tan(angle);
  const double pitch = std::numbers::pi * std::cos(angle);
  const double ofPinion = std::sqrt(std::max(gear.tip * gear.tip - base * base, 0.0)) - atPitchPoint;
  const double ofFace = std::min((face.addendum + face.profileShift) / std::sin(angle), atPitchPoint);
  MeshContact contact;
  contact.pressureAngle = angle;
  contact.tailAddendum = (isTailFace ? ofFace : ofPinion) / pitch;
  contact.headAddendum = (isTailFace ? ofPinion : ofFace) / pitch;
  contact.slidingTeeth = 1 / gear.teeth;
  return contact;
}

MeshContact contactOf(const TrainPair& pair, const GearSpec& tailSpec, const GearSpec& headSpec) {
  if (hasSkewAxes(pair.kind)) {
    MeshContact crossed;
    crossed.pressureAngle = normalPressureAngle(tailSpec);
    crossed.crossing = {tailSpec.helixAngle, headSpec.helixAngle};
    return crossed;
  }
  if (pairKind(pair.kind).hasFace) {
    const bool isTailFace = isFaceGear(tailSpec);
    return rackContact(isTailFace ? headSpec : tailSpec, isTailFace ? tailSpec : headSpec, isTailFace);
  }
  const PlaneGear tail = planeGear(tailSpec);
  const PlaneGear head = planeGear(headSpec);
  MeshContact contact;
  const double angle = tailSpec.pressureAngle;
  contact.pressureAngle = angle;
  if (hasParallelAxes(pair.kind)) {
    const int sum = distanceTeeth(pair.kind, tailSpec.teeth, headSpec.teeth);
    contact.pressureAngle = workingPressureAngle(sum, pair.distance / tailSpec.module, angle);
  }
  contact.tailAddendum = addendumRatio(tail, head, angle, contact.pressureAngle);
  contact.headAddendum = addendumRatio(head, tail, angle, contact.pressureAngle);
  if (tailSpec.helixAngle != 0) {
    const double tangent = std::tan(tailSpec.helixAngle) * std::cos(angle);
    contact.baseHelix = std::abs(std::atan(tangent));
    if (!tailSpec.herringbone) contact.helix = std::atan(tangent / std::cos(contact.pressureAngle));
  }
  // A crown gear has no virtual teeth: 1 / z is 0.
  const auto inverse = [](const PlaneGear& gear) { return std::isfinite(gear.teeth) ? 1 / gear.teeth : 0; };
  contact.slidingTeeth =
      hasRing(pair.kind) ? std::abs(inverse(tail) - inverse(head)) : std::abs(inverse(tail) + inverse(head));
  return contact;
}

}  // namespace

double toothLossFactor(const MeshContact& contact) {
  // Contacts lie at x = phase + k, from -head to tail; their set changes at two phases, and |x| bends at one.
  const auto phaseOf = [](double x) { return x - std::floor(x); };
  std::array<double, 4> phases{0, phaseOf(contact.tailAddendum), phaseOf(-contact.headAddendum), 1};
  std::sort(phases.begin(), phases.end());
  double sumOfAll = 0;
  double inContact = 0;
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const double width = phases[i + 1] - phases[i];
    const double middle = (phases[i] + phases[i + 1]) / 2;  // all is linear between
    double sum = 0;
    int pairs = 0;
    for (double x = middle - std::ceil(contact.headAddendum + middle); x <= contact.tailAddendum; ++x) {
      if (x < -contact.headAddendum) continue;
      sum += std::abs(x);
      ++pairs;
    }
    if (pairs == 0) continue;  // a drive that is interrupted there
    sumOfAll += width * sum / pairs;
    inContact += width;
  }
  const double average = inContact > 0 ? sumOfAll / inContact : 0;
  return 2 * std::numbers::pi * contact.slidingTeeth * average / std::cos(contact.baseHelix);
}

std::vector<std::optional<MeshContact>> meshContacts(const Mechanism& mechanism, const Placement& placement,
                                                     const std::stop_token& stop) {
  ByMesh<std::optional<MeshContact>> contacts(mechanism.gearMeshes.size());
  TrainWheels train = wheelsOf(mechanism, placement, stop);
  if (stop.stop_requested()) return contacts;
  shapeWheels(mechanism, train, stop);
  if (stop.stop_requested()) return contacts;
  for (const TrainPair& pair : train.pairs) {
    if (!touches(pair.kind)) continue;  // no teeth that press or slide on each other
    contacts[pair.mesh] = contactOf(pair, train.wheels[static_cast<std::size_t>(pair.tail)].spec,
                                    train.wheels[static_cast<std::size_t>(pair.head)].spec);
  }
  return contacts;
}

}  // namespace geargraph
