#include "core/design/synthesis/planets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

Diagnostic noPlanet(const Mechanism& mechanism, LinkId link, const char* sentence) {
  return {Code::schema,
          filled(translated(sentence), {labelOf(mechanism, link).value_or(link.text())}),
          {link},
          {},
          0,
          0};
}

/// About a line through a point, by an angle.
struct Turn {
  Vector3 point{};
  Vector3 axis{0, 0, 1};
  double angle = 0;

  [[nodiscard]] Vector3 direction(const Vector3& v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
  }
  [[nodiscard]] Vector3 place(const Vector3& p) const { return point + direction(p - point); }
};

std::optional<NumberTriple> written(const std::optional<NumberTriple>& was, const Turn& turn, bool isPlace) {
  if (!was) return std::nullopt;
  const Vector3 v{(*was)[0].value(), (*was)[1].value(), (*was)[2].value()};
  const Vector3 now = isPlace ? turn.place(v) : turn.direction(v);
  NumberTriple triple;
  for (std::size_t i = 0; i < 3; ++i) {
    const double rounded = std::round(now[i] * 1e10) / 1e10;  // what is 0 is written as 0
    triple[i] = Number::fromDouble(rounded == 0 ? 0 : rounded);
  }
  return triple;
}

/// The planet as it stands in the document.
struct Planet {
  TurningJoint joint;
  Axis axis;
  Link link;
  std::vector<GearMesh> meshes;
  CanvasPoint node;
  Turn turn;  ///< about the axis of what it meshes with; the angle is still open
};

Expected<Planet> planetOf(const PlacedMechanism& placed, LinkId link) {
  const Mechanism& mechanism = placed.mechanism();
  const Link* element = mechanism.find(link);
  if (element == nullptr)
    return Diagnostic{Code::unknownId, translated("There is no such link."), {link}, {}, 0, 0};
  Planet planet;
  planet.link = *element;
  int joints = 0;
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.tail != link && joint.head != link) continue;
    planet.joint = joint;
    ++joints;
  }
  if (joints != 1)
    return noPlanet(mechanism, link,
                    toTranslate("Link %1 is no planet: a planet turns on its carrier and carries nothing."));
  planet.axis = *mechanism.find(planet.joint.axis);
  const Placement& placement = placed.placement();
  int around = -1;
  for (std::size_t m = 0; m < mechanism.gearMeshes.size(); ++m) {
    const GearMesh& mesh = mechanism.gearMeshes[m];
    if (mesh.tail != link && mesh.head != link) continue;
    if (!placement.meshes[m])
      return noPlanet(mechanism, link,
                      toTranslate("Link %1 is no planet: one of its meshes does not fit its axes."));
    const int other = mesh.tail == link ? placement.meshes[m]->headClass : placement.meshes[m]->tailClass;
    if (around >= 0 && around != other)
      return noPlanet(mechanism, link,
                      toTranslate("Link %1 is no planet: its meshes are with wheels on several axes."));
    around = other;
    const LinkId carrier = planet.joint.tail == link ? planet.joint.head : planet.joint.tail;
    if (mechanism.links[placement.meshes[m]->carrier].id != carrier)
      return noPlanet(
          mechanism, link,
          toTranslate(
              "Link %1 is no planet: what it turns on does not carry the axis of what it meshes with."));
    planet.meshes.push_back(mesh);
  }
  if (around < 0)
    return noPlanet(mechanism, link, toTranslate("Link %1 is no planet: it meshes with nothing."));
  planet.turn.point = placement.lineOfClass(around).point;
  planet.turn.axis = placement.lineOfClass(around).direction;
  const auto node = mechanism.view.nodes.find(link);
  if (node != mechanism.view.nodes.end()) planet.node = node->second;
  return planet;
}

/// One more planet, number k of the copies.
Expected<Mechanism> withCopy(Mechanism mechanism, const Planet& planet, int k, double angle) {
  Turn turn = planet.turn;
  turn.angle = angle;
  auto edited =
      withLink(std::move(mechanism), {planet.node.x + 70.0 * k, planet.node.y + 70.0 * k}, planet.link.name);
  if (!edited) return edited;
  const LinkId fresh = edited->links.back().id;
  const bool outward = planet.joint.head == planet.link.id;
  edited = outward ? withTurningJoint(std::move(edited).value(), planet.joint.tail, fresh)
                   : withTurningJoint(std::move(edited).value(), fresh, planet.joint.head);
  if (!edited) return edited;
  Mechanism next = std::move(edited).value();
  next.axes.back().point = written(planet.axis.point, turn, true);
  next.axes.back().direction = written(planet.axis.direction, turn, false);
  next.turningJoints.back().offset = planet.joint.offset;
  for (const GearMesh& mesh : planet.meshes) {
    const bool isTail = mesh.tail == planet.link.id;
    auto meshed = withGearMesh(std::move(next), isTail ? fresh : mesh.tail, isTail ? mesh.head : fresh,
                               mesh.tailTeeth, mesh.headTeeth);
    if (!meshed) return meshed;
    next = std::move(meshed).value();
    GearMesh& copy = next.gearMeshes.back();
    copy.kind = mesh.kind;
    copy.faceWidth = mesh.faceWidth;
    copy.pitchPoint = written(mesh.pitchPoint, turn, true);
    if (isTail) copy.headWheel = mesh.headWheel;
    if (!isTail) copy.tailWheel = mesh.tailWheel;
  }
  return next;
}

}  // namespace

Expected<PlacedMechanism> withPlanets(const PlacedMechanism& before, LinkId planet, int total) {
  const auto found = planetOf(before, planet);
  if (!found) return found.error();
  Mechanism edited = before;
  for (int k = 1; k < total; ++k) {
    auto next = withCopy(std::move(edited), *found, k, 2 * std::numbers::pi * k / total);
    if (!next) return next.error();
    edited = std::move(next).value();
  }
  const PlacedMechanism after = std::move(edited);
  Diagnostics misfits = trainDiagnostics(after, after.placement());
  std::erase_if(misfits, [](const Diagnostic& diagnostic) { return diagnostic.code != Code::assembly; });
  if (!misfits.empty()) {
    misfits.front().message = translated("%1 planets cannot be put in evenly.", {std::to_string(total)}) +
                              ' ' + misfits.front().message;
    return misfits;
  }
  return after;
}

}  // namespace geargraph
