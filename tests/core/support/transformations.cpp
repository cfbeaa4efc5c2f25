#include "tests/core/support/transformations.h"

#include <algorithm>
#include <random>
#include <utility>

#include "core/mechanism/placement/placement.h"

namespace geargraph::test {
namespace {

void scale(Number& number, const Rational& factor) {
  if (!number.isZero()) number = Number(factor * number.exact());
}
void scale(std::optional<Number>& number, const Rational& factor) {
  if (number) scale(*number, factor);
}
void scale(std::optional<NumberTriple>& triple, const Rational& factor) {
  if (triple) triple = numbers(scaled(exactOf(*triple), factor));
}

Transformation movedBy(const Mechanism& mechanism, const std::string& name, const Rational& distance) {
  return {"moved by " + name, moved(mechanism, rotation(1, 0, 0, 0),
                                    {distance, Rational(-2) * distance, Rational(3) * distance})};
}

Transformation turned(const Mechanism& mechanism, const std::string& name, const ExactRotation& by) {
  return {"turned by " + name, moved(mechanism, by, {0, 0, 0})};
}

Transformation scaledBy(const Mechanism& mechanism, const std::string& name, const Rational& factor) {
  return {"scaled by " + name, withLengthsScaled(mechanism, factor), true, true, factor};
}

Transformation renamed(Mechanism mechanism) {
  Transformation result;
  result.name = "other ids";
  int next = 0;
  const auto fresh = [&](InternedString id) {
    return InternedString("<" + std::to_string(next++) + "> " + id.text());
  };
  for (const Link& link : mechanism.links) result.linkIds.push_back(fresh(link.id.atom()));
  for (const Axis& axis : mechanism.axes) result.axisIds.push_back(fresh(axis.id.atom()));
  for (const TurningJoint& joint : mechanism.turningJoints) result.jointIds.push_back(fresh(joint.id.atom()));
  for (const GearMesh& mesh : mechanism.gearMeshes) result.meshIds.push_back(fresh(mesh.id.atom()));
  const auto rename = [](auto& id, const auto& list, const std::vector<InternedString>& ids) {
    const auto at = std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.id == id; });
    id = std::decay_t<decltype(id)>(ids[static_cast<std::size_t>(at - list.begin())]);
  };
  const Mechanism before = mechanism;
  const auto link = [&](LinkId& id) { rename(id, before.links, result.linkIds); };
  for (TurningJoint& joint : mechanism.turningJoints) {
    link(joint.tail);
    link(joint.head);
    rename(joint.axis, before.axes, result.axisIds);
    rename(joint.id, before.turningJoints, result.jointIds);
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    link(mesh.tail);
    link(mesh.head);
    rename(mesh.id, before.gearMeshes, result.meshIds);
  }
  for (Wheel& wheel : mechanism.wheels) link(wheel.link);
  for (ShiftElement& coupling : mechanism.couplings)
    for (LinkId& id : coupling.links) link(id);
  for (ShiftState& state : mechanism.states) {
    if (state.drive) link(*state.drive);
    if (state.driven) link(*state.driven);
  }
  if (mechanism.inputs)
    for (Input& input : *mechanism.inputs) rename(input.joint, before.turningJoints, result.jointIds);
  for (Axis& axis : mechanism.axes) rename(axis.id, before.axes, result.axisIds);
  for (Link& element : mechanism.links) rename(element.id, before.links, result.linkIds);
  mechanism.view = {};
  result.mechanism = std::move(mechanism);
  return result;
}

/// Every second joint from its head to its tail, and every second mesh.
Transformation reversed(Mechanism mechanism) {
  Transformation result{"joints and meshes against their arrows", {}};
  result.jointSigns.assign(mechanism.turningJoints.size(), 1);
  for (std::size_t j = 0; j < mechanism.turningJoints.size(); j += 2) {
    TurningJoint& joint = mechanism.turningJoints[j];
    std::swap(joint.tail, joint.head);
    result.jointSigns[j] = -1;
    if (!mechanism.inputs) continue;
    for (Input& input : *mechanism.inputs)
      if (input.joint == joint.id) input.speed = Number(-input.speed.exact());
  }
  for (std::size_t m = 0; m < mechanism.gearMeshes.size(); m += 2) {
    GearMesh& mesh = mechanism.gearMeshes[m];
    std::swap(mesh.tail, mesh.head);
    std::swap(mesh.tailTeeth, mesh.headTeeth);
    std::swap(mesh.tailWheel, mesh.headWheel);
  }
  result.mechanism = std::move(mechanism);
  return result;
}

/// Every second axis points the other way, with the joints on it turned over.
Transformation flipped(Mechanism mechanism) {
  for (std::size_t a = 0; a < mechanism.axes.size(); a += 2) {
    if (!mechanism.axes[a].direction) continue;
    for (TurningJoint& joint : mechanism.turningJoints) {
      if (joint.axis == mechanism.axes[a].id) scale(joint.offset, -1);
    }
    mechanism = withAxisFlipped(std::move(mechanism), static_cast<int>(a));
  }
  return {"axes pointing the other way", std::move(mechanism), true, false};
}

}  // namespace

Mechanism withLengthsScaled(Mechanism mechanism, const Rational& factor) {
  for (Axis& axis : mechanism.axes) scale(axis.point, factor);
  for (TurningJoint& joint : mechanism.turningJoints) scale(joint.offset, factor);
  for (GearMesh& mesh : mechanism.gearMeshes) {
    scale(mesh.pitchPoint, factor);
    scale(mesh.faceWidth, factor);
    scale(mesh.module, factor);
    scale(mesh.pitch, factor);
    scale(mesh.tailDiameter, factor);
    scale(mesh.headDiameter, factor);
  }
  for (Wheel& wheel : mechanism.wheels) scale(wheel.bore, factor);
  if (mechanism.gearDefaults) scale(mechanism.gearDefaults->faceWidth, factor);
  return mechanism;
}

Mechanism reordered(Mechanism mechanism, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(mechanism.links.begin() + 1, mechanism.links.end(), random);
  std::shuffle(mechanism.axes.begin(), mechanism.axes.end(), random);
  std::shuffle(mechanism.turningJoints.begin(), mechanism.turningJoints.end(), random);
  std::shuffle(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(), random);
  return mechanism;
}

Mechanism withPitchPointsWritten(Mechanism mechanism) {
  const Placement placement = placementOf(mechanism);
  const Mechanism open = mechanism;
  for (int m = 0; m < open.c(); ++m) {
    const auto at = static_cast<std::size_t>(m);
    if (open.gearMeshes[at].pitchPoint || !placement.meshes[at]) continue;
    if (const auto point = exactPitchPoint(open, placement, m))
      mechanism.gearMeshes[at].pitchPoint = numbers(*point);
  }
  return mechanism;
}

std::vector<Transformation> transformationsOf(const Mechanism& mechanism, std::uint64_t seed) {
  const Rational billion(1'000'000'000);
  std::vector<Transformation> all{
      movedBy(mechanism, "1e9", billion),
      movedBy(mechanism, "1e-9", billion.inverse()),
      movedBy(mechanism, "1/3", Rational(1, 3)),
      turned(mechanism, "90 degrees about x", rotation(1, 1, 0, 0)),
      turned(mechanism, "90 degrees about y", rotation(1, 0, 1, 0)),
      turned(mechanism, "180 degrees about z", rotation(0, 0, 0, 1)),
      turned(mechanism, "the angle of 3-4-5 about z", rotation(2, 0, 0, 1)),
      turned(mechanism, "an oblique rational angle", rotation(3, 1, -2, 1)),
      scaledBy(mechanism, "1e-9", billion.inverse()),
      scaledBy(mechanism, "1e-4", Rational(1, 10'000)),
      scaledBy(mechanism, "22/7", Rational(22, 7)),
      scaledBy(mechanism, "1e9", billion),
      renamed(mechanism),
      reversed(mechanism),
      flipped(mechanism),
      {"another order", reordered(mechanism, seed), false},
  };
  Transformation both{"small, far away and turned", moved(withLengthsScaled(mechanism, Rational(1, 1000)),
                                                          rotation(2, 1, 0, 0), {billion, billion, 7})};
  both.length = Rational(1, 1000);
  all.push_back(std::move(both));
  return all;
}

}  // namespace geargraph::test
