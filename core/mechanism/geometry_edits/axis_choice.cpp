#include "core/mechanism/geometry_edits/axis_choice.h"

#include <algorithm>
#include <optional>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"

namespace geargraph {
namespace {

int positionOf(const Mechanism& mechanism, AxisId axis) {
  const auto found = std::find_if(mechanism.axes.begin(), mechanism.axes.end(),
                                  [axis](const Axis& each) { return each.id == axis; });
  return static_cast<int>(found - mechanism.axes.begin());
}

ExactLine lineOf(const PlacedMechanism& placed, AxisId axis) {
  return exactLine(placed.mechanism(), placed.placement(), positionOf(placed.mechanism(), axis));
}

bool isNull(const ExactVector3& v) {
  return v[0].isZero() && v[1].isZero() && v[2].isZero();
}

bool areParallel(const ExactVector3& a, const ExactVector3& b) {
  return isNull(cross(a, b));
}

/// The part of a direction that is square to another one; where nothing is left, y or z.
ExactVector3 squarePart(const ExactVector3& direction, const ExactVector3& other) {
  const auto without = [&](const ExactVector3& v) { return v - (dot(v, other) / dot(other, other)) * other; };
  for (const ExactVector3& v : {direction, ExactVector3{0, 1, 0}, ExactVector3{0, 0, 1}}) {
    const ExactVector3 part = without(v);
    if (!isNull(part)) return scaledToOne(part);
  }
  return direction;
}

ExactVector3 directionOf(const PlacedMechanism& placed, AxisId axis, const AxisChoice& choice) {
  using Way = AxisChoice::Way;
  switch (choice.way) {
    case Way::alongX:
      return {1, 0, 0};
    case Way::alongY:
      return {0, 1, 0};
    case Way::alongZ:
      return {0, 0, 1};
    case Way::squareTo:
      return squarePart(lineOf(placed, axis).direction, lineOf(placed, choice.other).direction);
    case Way::parallelTo:
      return lineOf(placed, choice.other).direction;
    case Way::throughIntersection:
      break;
  }
  return lineOf(placed, axis).direction;
}

/// The point of `line` that is nearest to `other`, where they meet if they do. None for parallel lines.
std::optional<ExactVector3> pointTowards(const ExactLine& line, const ExactLine& other) {
  const ExactVector3 normal = cross(line.direction, other.direction);
  if (isNull(normal)) return std::nullopt;
  const ExactVector3 apart = other.point - line.point;
  const Rational along = dot(cross(apart, other.direction), normal) / dot(normal, normal);
  return line.point + along * line.direction;
}

/// A mesh, seen from one of its two axes.
struct Neighbour {
  MeshId mesh;
  AxisId axis;  ///< the other one
  MeshKind kind;
};

std::vector<Neighbour> neighboursOf(const PlacedMechanism& placed, AxisId axis) {
  std::vector<Neighbour> found;
  const Mechanism& mechanism = placed.mechanism();
  const Placement& placement = placed.placement();
  if (!placement.classes) return found;
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    const auto& mesh = placement.meshes[m];
    if (!mesh) continue;
    const AxisId tail = axisOfClass(mechanism, placement, mesh->tailClass).id;
    const AxisId head = axisOfClass(mechanism, placement, mesh->headClass).id;
    if (tail == axis) found.push_back({mechanism.gearMeshes[m].id, head, mesh->kind});
    if (head == axis) found.push_back({mechanism.gearMeshes[m].id, tail, mesh->kind});
  }
  return found;
}

/// The kinds of its meshes fit an axis of this direction.
Expected<PlacedMechanism> withKindsFor(PlacedMechanism next, AxisId axis, const ExactVector3& direction) {
  for (const Neighbour& before : neighboursOf(next, axis)) {
    const auto all = neighboursOf(next, axis);
    const auto now =
        std::find_if(all.begin(), all.end(), [&](const Neighbour& each) { return each.mesh == before.mesh; });
    if (now == all.end()) continue;
    const bool parallel = areParallel(direction, lineOf(next, now->axis).direction);
    if (hasSkewAxes(now->kind) && !parallel) continue;
    if (parallel == (pairKind(now->kind).axes == LinePosition::parallel)) continue;
    const MeshKind fitting = usualKind(parallel ? LinePosition::parallel : LinePosition::intersecting);
    auto changed = withKindFitted(next, now->mesh, fitting);
    if (!changed) return changed;
    next = *std::move(changed);
  }
  return next;
}

/// The axis stated where it is to lie. Where no axis is stated, the first one is, too: else all others
/// would be laid out round the one that is.
Expected<PlacedMechanism> withLine(const PlacedMechanism& before, const PlacedMechanism& next, AxisId axis,
                                   const ExactLine& line) {
  Expected<Mechanism> edited = next.mechanism();
  const auto& axes = next.mechanism().axes;
  const bool isFirst =
      std::none_of(axes.begin(), axes.end(), [](const Axis& each) { return each.point && each.direction; });
  if (isFirst && axes.front().id != axis) {
    const ExactLine root = lineOf(next, axes.front().id);
    edited =
        withAxisPlaced(*std::move(edited), axes.front().id, numbersOf(root.point), numbersOf(root.direction));
    if (!edited) return edited.error();
  }
  return unlessBroken(
      before, withAxisPlaced(*std::move(edited), axis, numbersOf(line.point), numbersOf(line.direction)));
}

/// Left open where the kinds of its meshes lay it so already.
Expected<PlacedMechanism> withDirection(const PlacedMechanism& before, AxisId axis,
                                        const ExactVector3& direction) {
  const ExactLine was = lineOf(before, axis);
  const bool turns = !areParallel(was.direction, direction);
  // Left open, its place follows from the kinds; then it is stated there.
  Expected<PlacedMechanism> next = before;
  if (turns && !neighboursOf(before, axis).empty()) {
    next = unplaced(withAxisPlaced(before.mechanism(), axis, std::nullopt, std::nullopt));
    if (next) next = withKindsFor(*std::move(next), axis, direction);
    if (!next) return next;
  }
  const ExactLine line = lineOf(*next, axis);
  const bool isOpen = !next->mechanism().find(axis)->point;
  const bool isHeld = isOpen && !neighboursOf(*next, axis).empty();
  if (isHeld && areParallel(line.direction, direction)) return next;
  return withLine(before, *next, axis, {line.point, direction});
}

Expected<PlacedMechanism> withIntersectionPoint(const PlacedMechanism& before, AxisId axis, AxisId other) {
  const ExactLine line = lineOf(before, other);
  ExactVector3 point = line.point;
  for (const Neighbour& neighbour : neighboursOf(before, other)) {
    if (!hasIntersectingAxes(neighbour.kind) || neighbour.axis == axis) continue;
    if (const auto apex = pointTowards(line, lineOf(before, neighbour.axis))) {
      point = *apex;
      break;
    }
  }
  return withLine(before, before, axis, {point, lineOf(before, axis).direction});
}

}  // namespace

Expected<PlacedMechanism> withAxisChosen(const PlacedMechanism& before, AxisId axis,
                                         const AxisChoice& choice) {
  const Mechanism& mechanism = before.mechanism();
  const bool needsOther = choice.way >= AxisChoice::Way::squareTo;
  for (const AxisId each : {axis, needsOther ? choice.other : axis}) {
    if (mechanism.find(each) == nullptr) {
      return unplaced(withAxisPlaced(mechanism, each, std::nullopt, std::nullopt));  // rejects unknown-id
    }
  }
  if (isPinned(*mechanism.find(axis))) return pinRejection(*mechanism.find(axis));
  if (choice.way == AxisChoice::Way::throughIntersection)
    return withIntersectionPoint(before, axis, choice.other);
  return withDirection(before, axis, directionOf(before, axis, choice));
}

}  // namespace geargraph
