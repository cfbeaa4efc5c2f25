#include "core/mechanism/placement/crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/pair_rule.h"

namespace geargraph {
namespace {

using std::numbers::pi;

/// Teeth nearer to running round their axis than this make no gear.
constexpr double kMaxCrossedHelix = 88.5 * pi / 180;

std::string shortNumber(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value == 0 ? 0.0 : value);
  return buffer;
}

std::string degreesText(double radians) {
  return shortNumber(std::round(radians * 180 / pi * 1e4) / 1e4);
}

/// An angle of lines, into (-90, 90] degrees.
double halfTurn(double angle) {
  const double wrapped = angle - pi * std::round(angle / pi);
  return wrapped <= -pi / 2 ? wrapped + pi : wrapped;
}

bool fits(double a, double b) {
  return std::abs(a - b) <= kGeometryFits * std::max(std::abs(a), std::abs(b));
}

/// The angle between two lines, rad, up to a right one.
double acute(double angle) {
  return std::abs(halfTurn(angle));
}

/// Equal helix angles of both gears.
double equalHelix(const GearMesh& mesh, double angle) {
  const double smaller = halfTurn(-angle) / 2;  // half the acute crossing angle
  const double larger = smaller > 0 ? smaller - pi / 2 : smaller + pi / 2;
  constexpr double kSquare = 1e-9;
  const bool isSquare = std::abs(std::abs(smaller) - pi / 4) < kSquare;
  if (!mesh.hand) return isSquare ? pi / 4 : smaller;
  return smaller * signOf(*mesh.hand) > 0 ? smaller : larger;
}

/// The helix angle of the tail's gear for given radii. tan(beta) of z_j r_i cos(beta) = +-z_i r_j cos(Sigma +
/// beta).
std::optional<double> helixForRadii(const GearMesh& mesh, const CrossedAxes& axes, double tailRadius,
                                    double headRadius) {
  const double a = mesh.headTeeth * tailRadius;
  const double b = mesh.tailTeeth * headRadius;
  std::optional<double> best;
  for (const double side : {1.0, -1.0}) {
    const double angle = std::atan((side * b * std::cos(axes.angle) - a) / (side * b * std::sin(axes.angle)));
    if (mesh.hand && angle * signOf(*mesh.hand) < 0) continue;
    if (!best || std::abs(angle) < std::abs(*best)) best = angle;
  }
  return best;
}

CrossedProblem teethProblem(std::string message) {
  return {Detail::teethAgainstRadii, std::move(message)};
}

CrossedProblem moduleProblem(double stated, double fitting) {
  return teethProblem(translated(
      "its module %1 does not fit the distance of the axes: their pitch cylinders would not touch. What "
      "fits: the module %2.",
      {shortNumber(stated), shortNumber(fitting)}));
}

}  // namespace

std::variant<CrossedWheels, CrossedProblem> crossedHelicalWheels(const GearMesh& mesh,
                                                                 const CrossedAxes& axes) {
  CrossedWheels wheels;
  if (mesh.helixAngle) {
    wheels.tailHelix = helixOf(mesh);
  } else if (axes.tailReach) {
    const auto helix = helixForRadii(mesh, axes, *axes.tailReach, axes.distance - *axes.tailReach);
    if (!helix) {
      return CrossedProblem{
          Detail::helixAgainstTeeth,
          translated(
              "no helix of this hand makes these teeth with pitch radii of %1 and %2. What fits: the other "
              "hand, or no pitch point.",
              {shortNumber(*axes.tailReach), shortNumber(axes.distance - *axes.tailReach)})};
    }
    wheels.tailHelix = *helix;
  } else {
    wheels.tailHelix = equalHelix(mesh, axes.angle);
  }
  wheels.headHelix = halfTurn(-axes.angle - wheels.tailHelix);
  if (std::max(std::abs(wheels.tailHelix), std::abs(wheels.headHelix)) > kMaxCrossedHelix) {
    return CrossedProblem{
        Detail::helixAgainstTeeth,
        translated("a helix angle of %1 degrees leaves %2 for the head's gear, and at 90 teeth run round "
                   "their axis. "
                   "What fits: none, or a smaller one.",
                   {degreesText(std::abs(wheels.tailHelix)), degreesText(std::abs(wheels.headHelix))})};
  }
  const double tailShare = mesh.tailTeeth / (2 * std::cos(wheels.tailHelix));
  const double headShare = mesh.headTeeth / (2 * std::cos(wheels.headHelix));
  const double module = axes.distance / (tailShare + headShare);
  wheels.tailRadius = module * tailShare;
  wheels.headRadius = module * headShare;
  if (axes.tailReach && !fits(wheels.tailRadius, *axes.tailReach)) {
    return teethProblem(
        translated("its pitch point makes pitch radii of %1 and %2, but teeth and helix angles make "
                   "%3 and %4. What fits: no pitch point, or no helix angle.",
                   {shortNumber(*axes.tailReach), shortNumber(axes.distance - *axes.tailReach),
                    shortNumber(wheels.tailRadius), shortNumber(wheels.headRadius)}));
  }
  if (mesh.module && !fits(mesh.module->value(), module)) return moduleProblem(mesh.module->value(), module);
  return wheels;
}

std::variant<CrossedWheels, CrossedProblem> wormWheels(const GearMesh& mesh, const CrossedAxes& axes) {
  const bool isTailWorm = mesh.tailTeeth < mesh.headTeeth;
  const int starts = std::min(mesh.tailTeeth, mesh.headTeeth);
  const int teeth = std::max(mesh.tailTeeth, mesh.headTeeth);
  if (starts == teeth || starts > kMaxStarts) {
    return CrossedProblem{Detail::wormTeeth, translated("a worm has 1 to %1 starts, fewer than its wheel has "
                                                        "teeth; it has %2, and the wheel %3. What fits: "
                                                        "other numbers, or crossed helical.",
                                                        {std::to_string(kMaxStarts), std::to_string(starts),
                                                         std::to_string(teeth)})};
  }
  if (std::abs(std::cos(axes.angle)) > kGeometryFits) {
    return CrossedProblem{
        Detail::kindAgainstAxes,
        translated("it says worm, but its axes cross at %1 degrees. What fits: crossed helical, or "
                   "axes that cross at 90 degrees.",
                   {degreesText(acute(axes.angle))})};
  }
  constexpr double kUsualQuotient = 10;
  double wheelRadius = axes.distance * teeth / (kUsualQuotient + teeth);
  if (axes.tailReach) {
    wheelRadius = isTailWorm ? axes.distance - *axes.tailReach : *axes.tailReach;
    const double module = 2 * wheelRadius / teeth;
    if (mesh.module && !fits(mesh.module->value(), module))
      return moduleProblem(mesh.module->value(), module);
  } else if (mesh.module) {
    wheelRadius = mesh.module->value() * teeth / 2;
  }
  const double module = 2 * wheelRadius / teeth;
  const double wormRadius = axes.distance - wheelRadius;
  constexpr double kLeastQuotient = 3;  // below, the roots of the thread leave no core
  if (2 * wormRadius < kLeastQuotient * module) {
    return teethProblem(translated(
        "its module %1 gives the wheel a pitch radius of %2, and the axes are %3 apart: that leaves no core "
        "for the worm. What fits: a module of at most %4.",
        {shortNumber(module), shortNumber(wheelRadius), shortNumber(axes.distance),
         shortNumber(2 * axes.distance / (kLeastQuotient + teeth))}));
  }
  const double lead = std::atan(starts * module / (2 * wormRadius));
  const double hand = signOf(mesh.hand.value_or(Hand::right));
  const double wormHelix = hand * (pi / 2 - lead);
  const double wheelHelix = hand * lead;
  if (isTailWorm) return CrossedWheels{wormHelix, wheelHelix, wormRadius, wheelRadius};
  return CrossedWheels{wheelHelix, wormHelix, wheelRadius, wormRadius};
}

std::optional<Rational> exactLeadTangent(const GearMesh& mesh, const ExactVector3& tailPoint,
                                         const ExactVector3& tailDirection, const ExactVector3& headPoint,
                                         const ExactVector3& headDirection) {
  if (!pairKind(saidKind(mesh)).isThreaded) return std::nullopt;
  const int starts = std::min(mesh.tailTeeth, mesh.headTeeth);
  const int teeth = std::max(mesh.tailTeeth, mesh.headTeeth);
  if (!mesh.module && !mesh.pitchPoint) return Rational(starts, 10);
  const ExactVector3 normal = cross(tailDirection, headDirection);
  const Rational along = dot(headPoint - tailPoint, normal);
  const auto distance = (along * along / dot(normal, normal)).squareRoot();
  if (!distance) return std::nullopt;
  std::optional<Rational> module;
  if (mesh.module) {
    module = mesh.module->exact();
  } else {
    const bool isTailWorm = mesh.tailTeeth < mesh.headTeeth;
    const ExactVector3 off = cross(isTailWorm ? headDirection : tailDirection,
                                   toFractions(*mesh.pitchPoint) - (isTailWorm ? headPoint : tailPoint));
    const ExactVector3& direction = isTailWorm ? headDirection : tailDirection;
    const auto radius = (dot(off, off) / dot(direction, direction)).squareRoot();
    if (radius) module = *radius * Rational(2, teeth);
  }
  if (!module) return std::nullopt;
  const Rational diameter = Rational(2) * *distance - *module * Rational(teeth);
  if (diameter.sign() <= 0) return std::nullopt;
  return Rational(starts) * *module / diameter;
}

bool placeCrossing(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                   LinePosition position, const SkewChoice& /*choice*/, MeshGeometry& geometry,
                   Diagnostics& diagnostics) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const MeshKind kind = saidKind(element);
  const auto reject = [&](Detail detail, const std::string& message) {
    Diagnostic why;
    why.code = codeOf(detail);
    why.detail = detail;
    why.message = translated("Mesh %1: %2", {std::to_string(mechanism.meshLabel(mesh)), message});
    why.elements = {element.id, element.tail, element.head};
    diagnostics.push_back(std::move(why));
    return false;
  };
  if (position != LinePosition::skew) {
    return reject(Detail::kindAgainstAxes,
                  position == LinePosition::parallel
                      ? translated("it says %1, but its axes are parallel. What fits: external or internal.",
                                   {kindWord(kind)})
                      : translated("it says %1, but its axes meet. What fits: bevel.", {kindWord(kind)}));
  }
  const Vector3& tail = pair.tailDirection;
  const Vector3& head = pair.headDirection;
  const Vector3 across = cross(tail, head);
  Vector3 between = unit(across);
  if (dot(pair.headPoint, between) < 0) between = -1.0 * between;
  CrossedAxes axes;
  axes.distance = dot(pair.headPoint, between);
  axes.angle = std::atan2(dot(across, between), dot(tail, head));
  const Vector3 foot = (dot(cross(pair.headPoint, head), across) / dot(across, across)) * tail;
  geometry.derived = !element.pitchPoint;
  if (!geometry.derived) {
    const Vector3 from = geometry.tailToPitch - foot;
    axes.tailReach = dot(from, between);
    const double off = length(from - *axes.tailReach * between);
    if (off > kGeometryFits * axes.distance) {
      return reject(
          Detail::pitchPointOffPerpendicular,
          translated("its pitch point lies %1 off the common perpendicular of the axes, where their pitch "
                     "cylinders touch. What fits: a point on it, or none (then it follows from the axes).",
                     {shortNumber(off)}));
    }
    if (*axes.tailReach <= kGeometryFits * axes.distance ||
        *axes.tailReach >= (1 - kGeometryFits) * axes.distance) {
      return reject(
          Detail::pitchPointOffPerpendicular,
          translated(
              "its pitch point does not lie between the axes. What fits: a point between them, or none "
              "(then it follows from the axes)."));
    }
  }
  const auto found = pairRule(kind).crossed(element, axes);
  if (const CrossedProblem* problem = std::get_if<CrossedProblem>(&found))
    return reject(problem->detail, problem->message);
  const CrossedWheels& wheels = std::get<CrossedWheels>(found);
  if (geometry.derived) geometry.tailToPitch = foot + wheels.tailRadius * between;
  const Vector3 normal =
      std::cos(wheels.tailHelix) * cross(tail, between) - std::sin(wheels.tailHelix) * tail;
  geometry.kind = kind;
  geometry.normal = orientedNormal(normal);
  geometry.tailHelix = wheels.tailHelix;
  geometry.headHelix = wheels.headHelix;
  geometry.tailRadius = wheels.tailRadius * dot(geometry.normal, cross(tail, between));
  geometry.headRadius = -wheels.headRadius * dot(geometry.normal, cross(head, between));
  geometry.sign = geometry.tailRadius * geometry.headRadius < 0 ? -1 : 1;
  return true;
}

}  // namespace geargraph
