#include "core/machine/measure/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <tuple>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

Rational squareFrom(const ExactVector3& a, const ExactVector3& b) {
  return dot(b - a, b - a);
}

bool isZero(const ExactVector3& v) {
  return v[0].isZero() && v[1].isZero() && v[2].isZero();
}

/// The root of a square that is known in fractions: its double is the nearest whatever cancels.
MeasuredValue lengthOf(MeasuredKind measure, const Rational& square) {
  return {.measure = measure, .value = std::sqrt(square.toDouble()), .square = square};
}

MeasuredValue lengthOf(MeasuredKind measure, double value, const std::optional<Rational>& square = {}) {
  return square ? lengthOf(measure, *square) : MeasuredValue{.measure = measure, .value = value};
}

MeasuredValue angleBetween(const ExactVector3& a, const ExactVector3& b) {
  const Rational along = dot(a, b);
  const Rational cosine = along * along / (dot(a, a) * dot(b, b));  // squared
  const Vector3 u = unitDirection(a), v = unitDirection(b);
  constexpr double kDegrees = 180 / std::numbers::pi;
  MeasuredValue angle{.measure = MeasuredKind::angle,
                      .value = kDegrees * std::atan2(length(cross(u, v)), std::abs(dot(u, v)))};
  constexpr std::array<int, 5> kExact{90, 60, 45, 30, 0};
  for (std::size_t quarters = 0; quarters < kExact.size(); ++quarters) {
    if (cosine * Rational(4) != Rational(static_cast<int>(quarters))) continue;
    angle.degrees = kExact[quarters];
    angle.value = *angle.degrees;
  }
  return angle;
}

/// The foot of the perpendicular from a point to a line whose direction has length 1.
Vector3 footOn(const Vector3& point, const Vector3& direction, const Vector3& from) {
  return point + dot(from - point, direction) * direction;
}

/// Where two lines that are not parallel are nearest to each other.
std::pair<Vector3, Vector3> nearestPoints(const Spot& a, const Spot& b) {
  const Vector3 between = exactDifference(b.line->point, a.line->point);
  const double turned = dot(a.direction, b.direction);
  const double onA = dot(between, a.direction), onB = dot(between, b.direction);
  const double sine = 1 - turned * turned;
  const double s = (onA - turned * onB) / sine, t = (turned * onA - onB) / sine;
  return {a.point + s * a.direction, b.point + t * b.direction};
}

Measurement betweenAxes(const Spot& a, const Spot& b) {
  const ExactVector3 between = b.line->point - a.line->point;
  const ExactVector3 normal = cross(a.line->direction, b.line->direction);
  Measurement result{.from = a.point, .to = a.point};
  if (areParallel(a.direction, b.direction)) {
    result.to = footOn(b.point, b.direction, a.point);
    const double distance = length(cross(toDoubles(between), a.direction));
    result.values = {
        lengthOf(MeasuredKind::centreDistance, distance,
                 isZero(normal) ? std::optional(squareFromLine(b.line->point, *a.line)) : std::nullopt)};
    return result;
  }
  std::tie(result.from, result.to) = nearestPoints(a, b);
  const Rational triple = dot(between, normal);
  const MeasuredValue distance = lengthOf(MeasuredKind::distance, triple * triple / dot(normal, normal));
  const MeasuredValue angle = angleBetween(a.line->direction, b.line->direction);
  const bool meet = distance.value <= kSameLine * length(toDoubles(between));
  result.values = meet ? std::vector{angle} : std::vector{distance, angle};
  return result;
}

Measurement betweenPointAndAxis(const Spot& point, const Spot& axis) {
  Measurement result{.from = point.point, .to = footOn(axis.point, axis.direction, point.point)};
  for (std::size_t i = 0; i < point.meshWheels.size(); ++i) {
    const MeasuredWheel& wheel = point.meshWheels[i];
    const ExactLine& own = point.meshLines[i];
    if (own.point != axis.line->point || own.direction != axis.line->direction) continue;
    const auto quarter = wheel.pitchSquare ? std::optional(*wheel.pitchSquare / Rational(4)) : std::nullopt;
    result.values = {lengthOf(MeasuredKind::pitchRadius, *wheel.pitchDiameter / 2, quarter),
                     lengthOf(MeasuredKind::pitchDiameter, *wheel.pitchDiameter, wheel.pitchSquare)};
    return result;
  }
  // A wheel's point is on its axis: from there the distance is that of the axes, wherever it lies along it.
  if (point.line && areParallel(point.direction, axis.direction)) {
    result.values = betweenAxes(point, axis).values;
    return result;
  }
  const auto square =
      point.exactPoint ? std::optional(squareFromLine(*point.exactPoint, *axis.line)) : std::nullopt;
  result.values = {lengthOf(MeasuredKind::distance, length(result.to - result.from), square)};
  return result;
}

Measurement betweenPoints(const Spot& a, const Spot& b) {
  Measurement result{.from = a.point, .to = b.point};
  const Vector3 way = b.point - a.point;
  const auto square =
      a.exactPoint && b.exactPoint ? std::optional(squareFrom(*a.exactPoint, *b.exactPoint)) : std::nullopt;
  result.values = {lengthOf(MeasuredKind::distance, length(way), square)};
  if (!a.line || !b.line || !areParallel(a.direction, b.direction)) return result;
  // Between wheels in different planes it is the centre distance that people ask for.
  const bool areWheels = a.kind == Spot::Kind::wheelCentre && b.kind == Spot::Kind::wheelCentre;
  const MeasuredValue centres = betweenAxes(a, b).values.front();
  if (centres.value > 0)
    result.values.insert(areWheels ? result.values.begin() : result.values.end(), centres);
  result.values.push_back({.measure = MeasuredKind::along, .value = std::abs(dot(way, a.direction))});
  return result;
}

std::string sixDigits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// "√2", "√(1/3)"
std::string rootText(const Rational& square) {
  return square.isInteger() ? "√" + square.toString() : "√(" + square.toString() + ")";
}

}  // namespace

Measurement measured(const Spot& spot) {
  Measurement result{.from = spot.point, .to = spot.point};
  if (spot.meshWheels.size() == 2) {
    for (const std::size_t i : {0U, 1U}) {
      const MeasuredWheel& wheel = spot.meshWheels[i];
      result.values.push_back(lengthOf(MeasuredKind::pitchDiameter, *wheel.pitchDiameter, wheel.pitchSquare));
      result.values.back().link = wheel.link;
    }
  }
  if (!spot.wheel) return result;
  if (spot.wheel->pitchDiameter)
    result.values.push_back(
        lengthOf(MeasuredKind::pitchDiameter, *spot.wheel->pitchDiameter, spot.wheel->pitchSquare));
  result.values.push_back(lengthOf(MeasuredKind::tipDiameter, spot.wheel->tipDiameter));
  result.values.push_back(lengthOf(MeasuredKind::rootDiameter, spot.wheel->rootDiameter));
  result.values.push_back(lengthOf(MeasuredKind::faceWidth, spot.wheel->faceWidth));
  return result;
}

Measurement measured(const Spot& from, const Spot& to) {
  if (!from.isPoint() && !to.isPoint()) return betweenAxes(from, to);
  if (from.isPoint() && to.isPoint()) return betweenPoints(from, to);
  if (from.isPoint()) return betweenPointAndAxis(from, to);
  Measurement turned = betweenPointAndAxis(to, from);
  std::swap(turned.from, turned.to);
  return turned;
}

std::string nameOf(const MeasuredValue& value) {
  if (value.link) return translated("pitch diameter of gear %1", {std::to_string(int{*value.link})});
  switch (value.measure) {
    case MeasuredKind::distance:
      return translated("distance");
    case MeasuredKind::centreDistance:
      return translated("centre distance");
    case MeasuredKind::pitchRadius:
      return translated("pitch radius");
    case MeasuredKind::angle:
      return translated("angle");
    case MeasuredKind::along:
      return translated("along the axes");
    case MeasuredKind::pitchDiameter:
      return translated("pitch diameter");
    case MeasuredKind::tipDiameter:
      return translated("tip diameter");
    case MeasuredKind::rootDiameter:
      return translated("root diameter");
    case MeasuredKind::faceWidth:
      return translated("face width");
  }
  return {};
}

std::string textOf(const MeasuredValue& value, const std::string& unit) {
  constexpr std::size_t kLongest = 16;  // longer fractions say nothing to people
  const std::string digits = sixDigits(value.value);
  if (value.measure == MeasuredKind::angle)
    return (value.degrees ? std::to_string(*value.degrees) : localizedNumber(digits)) + "°";
  const std::string number = localizedNumber(digits) + ' ' + unit;
  if (!value.square) return number;
  const std::optional<Rational> length = value.fraction();
  const std::string exact = length ? length->toString() : rootText(*value.square);
  if (exact.size() > kLongest) return number;
  if (length && length->isInteger()) return exact + ' ' + unit;
  const bool isDecimal = length && Rational::fromText(digits) == length;
  return exact + ' ' + unit + (isDecimal ? " = " : " ≈ ") + number;
}

}  // namespace geargraph
