#include "core/presentation/schematic/sheet_edits.h"

#include <algorithm>
#include <cmath>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/mesh_snap.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

constexpr int kFewTeeth = 8;           ///< a wheel that is fitted in has no fewer
constexpr int kDefaultTeeth = 20;      ///< where no distance says more
constexpr double kPlanetShare = 0.43;  ///< of the distance that a new planet's radius takes in a ring

NumberTriple wholeTriple(const Vector3& v) {
  const auto whole = [](double x) { return Number(static_cast<int>(std::lround(x))); };
  return {whole(v[0]), whole(v[1]), whole(v[2])};
}

/// Directions of the sheet are those of the base frame as a rule; others keep six digits.
NumberTriple directionTriple(const Vector3& v) {
  const auto digits = [](double x) {
    const auto millionths = static_cast<long long>(std::llround(x * 1e6));
    return Number(Rational(millionths, 1'000'000));
  };
  return {digits(v[0]), digits(v[1]), digits(v[2])};
}

const TurningJoint* firstJointOn(const Mechanism& mechanism, AxisId axis) {
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.axis == axis) return &joint;
  }
  return nullptr;
}

bool isHeldBy(const Mechanism& mechanism, AxisId axis, LinkId link) {
  return std::any_of(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                     [&](const TurningJoint& joint) {
                       return joint.axis == axis && (joint.tail == link || joint.head == link);
                     });
}

struct Line {
  Vector3 point;
  Vector3 direction;
};

/// The line that a new axis is drawn along; its point is the one nearest to the sheet's base.
Line drawnLine(const CanvasFrame& frame, const DrawnShaft& shaft) {
  const bool level = std::abs(shaft.to.x - shaft.from.x) >= std::abs(shaft.to.y - shaft.from.y);
  const Vector3 direction = level ? frame.right : frame.up;
  const Vector3 at = frame.spaceOf(shaft.from) - frame.base;
  return {frame.base + (at - dot(at, direction) * direction), direction};
}

/// The link at the end of the list, tied to the carrier on an axis.
Expected<Mechanism> withCarriedLink(Mechanism mechanism, LinkId carrier, AxisId axis) {
  Expected<Mechanism> linked = withLink(std::move(mechanism), {});
  if (!linked) return linked;
  Mechanism next = std::move(linked).value();
  const LinkId link = next.links.back().id;
  next.view.nodes.erase(link);  // the digraph finds a place for it
  return withTurningJoint(std::move(next), carrier, link, axis);
}

std::optional<int> teethOf(const Mechanism& mechanism, const Placement& placement, int link, int axisGroup) {
  for (std::size_t m = 0; m + 1 < mechanism.gearMeshes.size(); ++m) {  // the last one is new
    const auto& geometry = placement.meshes[m];
    if (!geometry || !hasParallelAxes(geometry->kind)) continue;
    if (geometry->tail == link && geometry->tailClass == axisGroup) return mechanism.gearMeshes[m].tailTeeth;
    if (geometry->head == link && geometry->headClass == axisGroup) return mechanism.gearMeshes[m].headTeeth;
  }
  return std::nullopt;
}

struct Teeth {
  int tail = kDefaultTeeth;
  int head = kDefaultTeeth;
};

/// Teeth whose sum is what the distance asks for.
Teeth externalTeeth(std::optional<int> tail, std::optional<int> head, int sum) {
  if (tail && head) return {*tail, *head};
  if (tail && sum - *tail >= kFewTeeth) return {*tail, sum - *tail};
  if (head && sum - *head >= kFewTeeth) return {sum - *head, *head};
  const int half = std::max(sum / 2, kFewTeeth);
  return {half, std::max(sum - half, kFewTeeth)};
}

/// Teeth whose difference is; the ring first.
Teeth internalTeeth(std::optional<int> ring, std::optional<int> pinion, int difference) {
  if (ring && pinion) return {*ring, *pinion};
  if (pinion) return {*pinion + difference, *pinion};
  if (ring && *ring - difference >= kFewTeeth) return {*ring, *ring - difference};
  const int planet = std::max(kFewTeeth, static_cast<int>(std::lround(kPlanetShare * difference)));
  return {planet + difference, planet};
}

/// How far a place lies from a line, towards another one.
double heightTowards(const CanvasFrame::Line& line, const CanvasFrame::Line& other, CanvasPoint p) {
  const CanvasPoint out = turned(line.along);
  const double way = dot(other.at - line.at, out) < 0 ? -1 : 1;
  return way * dot(p - line.at, out);
}

enum class RingOf { neither, tail, head };

/// Whose ring the drag means: that of the axis that the other end lies beyond.
RingOf ringMeant(const CanvasFrame& frame, const Mechanism& mechanism, const Placement& placement,
                 const MeshGeometry& geometry, const DrawnMesh& mesh) {
  const auto lineOf = [&](int axisGroup) {
    const int axis = placement.classes->classes[axisGroup].axis;
    return frame.line(mechanism.axes[axis].id);
  };
  const CanvasFrame::Line* tail = lineOf(geometry.tailClass);
  const CanvasFrame::Line* head = lineOf(geometry.headClass);
  if (tail == nullptr || head == nullptr) return RingOf::neither;
  const double distance = heightTowards(*tail, *head, head->at);
  constexpr double kBeyond = 6;  // px
  if (std::max(heightTowards(*tail, *head, mesh.from), heightTowards(*tail, *head, mesh.to)) >
      distance + kBeyond) {
    return RingOf::tail;
  }
  if (std::max(heightTowards(*head, *tail, mesh.from), heightTowards(*head, *tail, mesh.to)) >
      distance + kBeyond) {
    return RingOf::head;
  }
  return RingOf::neither;
}

}  // namespace

Expected<Mechanism> withShaftOnSheet(Mechanism mechanism, const CanvasFrame& frame, const DrawnShaft& shaft) {
  const CanvasFrame::Line* near = frame.axisNear(shaft.from, shaft.reach);
  AxisId axis = near == nullptr ? AxisId() : near->axis;
  const TurningJoint* held = axis.empty() ? nullptr : firstJointOn(mechanism, axis);
  LinkId carrier = shaft.carrier;
  if (carrier.empty()) carrier = held == nullptr ? mechanism.links.front().id : held->tail;
  Line line = drawnLine(frame, shaft);
  const bool own = held != nullptr && !isHeldBy(mechanism, axis, carrier);
  const bool isFirst = mechanism.axes.empty();
  if (own || isFirst || axis.empty()) {
    const Axis* there = own ? mechanism.find(axis) : nullptr;
    const bool placed = there != nullptr && there->point && there->direction;
    const NumberTriple point = placed ? *there->point : wholeTriple(isFirst ? Vector3{} : line.point);
    const NumberTriple direction = placed ? *there->direction : directionTriple(line.direction);
    Expected<Mechanism> next = withCarriedLink(std::move(mechanism), carrier, {});
    if (!next) return next;
    axis = next->turningJoints.back().axis;
    next = withAxisPlaced(std::move(next).value(), axis, point, direction);
    if (!next) return next;
    mechanism = std::move(next).value();
  } else {
    Expected<Mechanism> next = withCarriedLink(std::move(mechanism), carrier, axis);
    if (!next) return next;
    mechanism = std::move(next).value();
  }
  const Axis* on = mechanism.find(axis);
  if (!on->point || !on->direction || isFirst) return mechanism;
  const Vector3 point{(*on->point)[0].value(), (*on->point)[1].value(), (*on->point)[2].value()};
  const Vector3 direction =
      unit(Vector3{(*on->direction)[0].value(), (*on->direction)[1].value(), (*on->direction)[2].value()});
  const double along = dot(frame.spaceOf(between(shaft.from, shaft.to, 0.5)) - point, direction);
  const JointId joint = mechanism.turningJoints.back().id;
  return withOffset(std::move(mechanism), joint, Number(static_cast<int>(std::lround(along))));
}

Expected<PlacedMechanism> withMeshOnSheet(Mechanism mechanism, const CanvasFrame& frame,
                                          const DrawnMesh& mesh) {
  const Expected<PlacedMechanism> drawn = unplaced(withGearMesh(std::move(mechanism), mesh.tail, mesh.head));
  if (!drawn) return drawn;
  const Placement& placement = drawn->placement();
  const auto& geometry = placement.meshes.back();
  if (!geometry || !hasParallelAxes(geometry->kind)) return drawn;
  const AxisLine& a = placement.lineOfClass(geometry->tailClass);
  const AxisLine& b = placement.lineOfClass(geometry->headClass);
  const double distance = length(cross(a.direction, b.point - a.point));
  const bool isFree = a.automatic || b.automatic;
  const int sum =
      isFree ? 2 * kDefaultTeeth
             : std::max(1, static_cast<int>(std::lround(2 * distance / placement.module.toDouble())));
  const std::optional<int> tail = teethOf(*drawn, placement, geometry->tail, geometry->tailClass);
  const std::optional<int> head = teethOf(*drawn, placement, geometry->head, geometry->headClass);
  const RingOf ring = ringMeant(frame, *drawn, placement, *geometry, mesh);
  Teeth teeth;
  if (ring == RingOf::neither) {
    teeth = externalTeeth(tail, head, sum);
  } else {
    const bool isTail = ring == RingOf::tail;
    const Teeth pair = internalTeeth(isTail ? tail : head, isTail ? head : tail, sum);
    teeth = isTail ? pair : Teeth{pair.head, pair.tail};
  }
  const MeshId id = drawn->mechanism().gearMeshes.back().id;
  Expected<Mechanism> next = withTeeth(*drawn, id, teeth.tail, teeth.head);
  if (next && ring != RingOf::neither) next = withMeshKind(std::move(next).value(), id, ringKind());
  Expected<PlacedMechanism> fits = unplaced(std::move(next));
  return fits && tail && head ? withMeshSnapped(*fits, id) : fits;
}

Expected<PlacedMechanism> withAxisOnSheet(const PlacedMechanism& before, const CanvasFrame& frame,
                                          const DraggedAxis& drag) {
  const CanvasFrame::Line* line = frame.line(drag.axis);
  const Axis* axis = before.mechanism().find(drag.axis);
  if (line == nullptr || axis == nullptr) return unplaced(withAxisPlaced(before, drag.axis, {}, {}));
  const std::optional<AxisReach> reach = axisReach(before, drag.axis);
  const CanvasFrame::Line* other = reach ? frame.line(reach->from) : nullptr;
  const double height = other == nullptr ? 0 : heightTowards(*other, *line, line->at);
  if (height > 1e-6) {
    const double moved = heightTowards(*other, *line, drag.to) - heightTowards(*other, *line, drag.from);
    return withAxisDragged(before, drag.axis, (moved / height * reach->distance) * reach->outward,
                           drag.snapped);
  }
  const Vector3 along = frame.spaceOf(line->at + line->along) - frame.spaceOf(line->at);
  const Vector3 way = frame.spaceOf(drag.to) - frame.spaceOf(drag.from);
  return withAxisDragged(before, drag.axis, way - (dot(way, along) / dot(along, along)) * along,
                         drag.snapped);
}

}  // namespace geargraph
