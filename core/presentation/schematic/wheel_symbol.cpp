#include "core/presentation/schematic/wheel_symbol.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

Vector3 asTriple(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

double originOf(const TrainWheel& from, const SheetAxis& axis, double scale) {
  return axis.spaceCoordinate(asTriple(from.origin)) * scale;
}

void setLevelBar(SheetWheel& wheel, const TrainWheel& from, const SheetAxis& axis, double scale) {
  const int side = wheelSymbol(wheel.kind).side;
  wheel.at = originOf(from, axis, scale);
  wheel.radius = from.workingRadius * scale + side * kBarGap;
  wheel.barFrom = {wheel.at - kBarHalf, wheel.radius};
  wheel.barTo = {wheel.at + kBarHalf, wheel.radius};
  wheel.outward = {0, static_cast<double>(-side)};
}

void setSlopingBar(SheetWheel& wheel, const TrainWheel& from, const SheetAxis& axis, double scale) {
  const double way = dot(asTriple(from.axis), axis.direction) < 0 ? -1 : 1;
  const double angle = from.spec.coneAngle;
  const CanvasPoint line{way * std::cos(angle), std::sin(angle)};
  wheel.outward = {-way * std::sin(angle), std::cos(angle)};
  const double outer = from.workingRadius * scale / std::sin(angle);
  const double face = std::min(std::max(from.spec.faceWidth * scale, 9.0), 0.5 * outer);
  const CanvasPoint apex{originOf(from, axis, scale), 0};
  wheel.barFrom = apex + outer * line - kBarGap * wheel.outward;
  wheel.barTo = apex + (outer - face) * line - kBarGap * wheel.outward;
  const CanvasPoint middle = between(wheel.barFrom, wheel.barTo, 0.5);
  wheel.at = middle.x;
  wheel.radius = middle.y;
}

/// A line across the axis, where the teeth of a face gear are.
void setUprightBar(SheetWheel& wheel, const TrainWheel& from, const SheetAxis& axis, double scale) {
  const double way = dot(asTriple(from.axis), axis.direction) < 0 ? -1 : 1;
  wheel.outward = {-way, 0};
  const double outer = nominalTipRadius(from.spec) * scale;
  const double face = std::min(std::max(from.spec.faceWidth * scale, 9.0), 0.5 * outer);
  const double level = originOf(from, axis, scale) + way * kBarGap;
  wheel.barFrom = {level, outer};
  wheel.barTo = {level, outer - face};
  wheel.at = level;
  wheel.radius = outer - face / 2;
}

double atOrigin(const TrainWheel& /*from*/) {
  return 0;
}

double fromApex(const TrainWheel& from) {
  return from.workingRadius / std::tan(from.spec.coneAngle);
}

}  // namespace

constexpr WheelSymbol kDiscSymbol{.setBar = setLevelBar, .away = atOrigin};
constexpr WheelSymbol kRingSymbol{
    .frame = FrameSymbol::rim, .side = 1, .setBar = setLevelBar, .away = atOrigin};
constexpr WheelSymbol kFaceSymbol{.frame = FrameSymbol::behind, .setBar = setUprightBar, .away = atOrigin};
constexpr WheelSymbol kConeSymbol{.frame = FrameSymbol::behind, .setBar = setSlopingBar, .away = fromApex};

KindTable<GearKind, WheelSymbol>& wheelSymbols() {
  static constinit KindTable<GearKind, WheelSymbol> table(&kDiscSymbol, &kRingSymbol, &kConeSymbol,
                                                          &kDiscSymbol, &kDiscSymbol, &kDiscSymbol,
                                                          &kFaceSymbol, &kConeSymbol);
  return table;
}

const WheelSymbol& wheelSymbol(GearKind kind) {
  return wheelSymbols()[kind];
}

}  // namespace geargraph
