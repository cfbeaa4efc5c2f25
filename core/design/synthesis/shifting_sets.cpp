#include "core/design/synthesis/shifting_sets.h"

#include <cmath>
#include <numbers>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

PlanePoint turned(const PlanePoint& p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
}

double distance(const PlanePoint& a, const PlanePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

Diagnostic rejection(Code code, std::string message) {
  return {code, std::move(message), {}, {}, 0, 0};
}

/// Where a pair is whose wheels have their centres at these distances from the axis and from each other.
std::optional<PairPlaces> placesOf(double toShort, double toLong, double between) {
  const double cosine = (toShort * toShort + toLong * toLong - between * between) / (2 * toShort * toLong);
  if (std::abs(cosine) >= 1) return std::nullopt;
  return PairPlaces{{toShort * cosine, toShort * std::sqrt(1 - cosine * cosine)}, {toLong, 0}};
}

constexpr int kSmallSunLevel = 20;  // where along the axes the small sun and the short planets lie
constexpr int kRingLevel = 0;       // the large sun and the ring

}  // namespace

std::optional<PairPlaces> pairPlaces(const RavigneauxTeeth& teeth) {
  return placesOf(teeth.smallSun + teeth.shortPlanet, teeth.largeSun + teeth.longPlanet,
                  teeth.shortPlanet + teeth.longPlanet);
}

std::optional<PairPlaces> doublePlanetPlaces(int sun, int inner, int outer, int ring) {
  return placesOf(sun + inner, ring - outer, inner + outer);
}

bool pairsClear(const PairPlaces& places, int shortPlanet, int longPlanet, int pairs) {
  for (int k = 1; k < pairs; ++k) {
    const double angle = 2 * std::numbers::pi * k / pairs;
    const PlanePoint nextShort = turned(places.shortPlanet, angle);
    const PlanePoint nextLong = turned(places.longPlanet, angle);
    if (distance(places.longPlanet, nextLong) <= 2 * longPlanet + 4) return false;
    if (distance(places.shortPlanet, nextShort) <= 2 * shortPlanet + 4) return false;
    if (distance(places.shortPlanet, nextLong) <= shortPlanet + longPlanet + 4) return false;
  }
  return true;
}

Number planeCoordinate(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  return Number::fromDouble(rounded == 0 ? 0 : rounded);
}

NumberTriple touchingPoint(const PlanePoint& a, int teethOfA, const PlanePoint& b, int teethOfB, int level) {
  const double part = static_cast<double>(teethOfA) / (teethOfA + teethOfB);
  return {planeCoordinate(a.x + part * (b.x - a.x)), planeCoordinate(a.y + part * (b.y - a.y)),
          Number(level)};
}

std::optional<Diagnostic> ravigneauxFault(const RavigneauxTeeth& teeth, int pairs) {
  const auto places = pairPlaces(teeth);
  if (!places) {
    return rejection(
        Code::teethGeometry,
        translated(
            "Short and long planet cannot touch each other: small sun + short planet and large sun + long "
            "planet differ by more than short + long planet. What fits: sums that are nearer."));
  }
  if (teeth.largeSun - teeth.smallSun < 4) {
    return rejection(
        Code::teethGeometry,
        translated("The long planets, which extend through both planes, interfere with the small sun. "
                   "What fits: a large sun with at least 4 teeth more than the small one."));
  }
  // Small sun and short planets lie in a plane of their own.
  if (!pairsClear(*places, teeth.shortPlanet, teeth.longPlanet, pairs))
    return rejection(
        Code::teethGeometry,
        translated("The planets collide. What fits: fewer pairs, smaller planets, or a larger ring."));
  if ((teeth.ring() + teeth.largeSun) % pairs != 0 || (teeth.ring() - teeth.smallSun) % pairs != 0) {
    return rejection(
        Code::assembly,
        translated(
            "The pairs do not go in evenly: ring + large sun = %1 and ring - small sun = %2 have to be "
            "multiples of %3.",
            {std::to_string(teeth.ring() + teeth.largeSun), std::to_string(teeth.ring() - teeth.smallSun),
             std::to_string(pairs)}));
  }
  return std::nullopt;
}

Expected<Mechanism> ravigneauxSet(const RavigneauxTeeth& teeth, int pairs) {
  if (auto fault = ravigneauxFault(teeth, pairs)) return *std::move(fault);
  const auto places = pairPlaces(teeth);
  SetSketch set(translated("Ravigneaux set"));
  const NumberTriple z{Number(0), Number(0), Number(1)};
  set.axis("a", {Number(0), Number(0), Number(0)}, z);
  const int small = set.link(0, "a", translated("small sun"));
  const int large = set.link(0, "a", translated("large sun"));
  const int ring = set.link(0, "a", translated("ring"));
  const LinkOrdinal carrier = set.link(0, "a", translated("carrier"));
  for (int k = 0; k < pairs; ++k) {
    const double angle = 2 * std::numbers::pi * k / pairs;
    const std::string number = std::to_string(k + 1);
    const PlanePoint shortAt = turned(places->shortPlanet, angle);  // half modules of 1: module 2
    const PlanePoint longAt = turned(places->longPlanet, angle);
    set.axis("b" + number, {planeCoordinate(shortAt.x), planeCoordinate(shortAt.y), Number(0)}, z);
    set.axis("c" + number, {planeCoordinate(longAt.x), planeCoordinate(longAt.y), Number(0)}, z);
    const int shorter = set.link(carrier, "b" + number, translated("short planet %1", {number}));
    const int longer = set.link(carrier, "c" + number, translated("long planet %1", {number}));
    const auto mesh = [&](int tail, int head, int tailTeeth, int headTeeth,
                          const NumberTriple& point) -> GearMesh& {
      const MeshKind kind = head == ring ? MeshKind::internal : MeshKind::external;
      GearMesh& made = set.mesh(tail, head, tailTeeth, headTeeth, kind);
      made.faceWidth = Number(12);
      made.pitchPoint = point;
      return made;
    };
    const WheelId wheel = set.wheel("long-" + number, longer);  // one, through both planes
    mesh(small, shorter, teeth.smallSun, teeth.shortPlanet,
         touchingPoint({}, teeth.smallSun, shortAt, teeth.shortPlanet, kSmallSunLevel));
    mesh(shorter, longer, teeth.shortPlanet, teeth.longPlanet,
         touchingPoint(shortAt, teeth.shortPlanet, longAt, teeth.longPlanet, kSmallSunLevel))
        .headWheel = wheel;
    mesh(large, longer, teeth.largeSun, teeth.longPlanet,
         touchingPoint({}, teeth.largeSun, longAt, teeth.longPlanet, kRingLevel))
        .headWheel = wheel;
    mesh(longer, ring, teeth.longPlanet, teeth.ring(),
         touchingPoint(longAt, teeth.longPlanet, {}, -teeth.ring(), kRingLevel))
        .tailWheel = wheel;
  }
  set.input(small, Number(1));
  set.input(carrier, Number(0));
  set.brake("B1", large);
  set.brake("B2", carrier);
  set.clutch("C", small, large);
  set.state("1", {"B2"}, small, ring);
  set.state("2", {"B1"}, small, ring);
  set.state("3", {"C"}, small, ring);
  set.state("R", {"B2"}, large, ring);
  return std::move(set).build();
}

Expected<Mechanism> simpsonSet(const PlanetaryTeeth& teeth, int planets) {
  if (!assembles(teeth, planets)) {
    return rejection(
        Code::assembly,
        translated("The planets do not go in evenly: sun + ring = %1 has to be a multiple of %2.",
                   {std::to_string(teeth.sun + teeth.ring()), std::to_string(planets)}));
  }
  if (!neighboursClear(teeth, planets))
    return rejection(
        Code::teethGeometry,
        translated("The planets collide. What fits: fewer or smaller planets, or a larger sun."));
  SetSketch set(translated("Simpson set"));
  const int suns = set.link(0, "a", translated("suns"));
  const int ring = set.link(0, "a", translated("first ring"));
  const int output = set.link(0, "a", translated("output"));
  const LinkOrdinal carrier = set.link(0, "a", translated("second carrier"));
  const auto stage = [&](int on, int around, const std::string& axis, const std::string& id,
                         const char* planetName) {
    const WheelId sun = set.wheel(id + "-sun", suns);
    for (int i = 0; i < planets; ++i) {
      const std::string number = std::to_string(i + 1);
      const int planet =
          set.link(on, axis + number, filled(translated(std::string_view(planetName)), {number}));
      set.mesh(suns, planet, teeth.sun, teeth.planet, MeshKind::external).tailWheel = sun;
      set.mesh(planet, around, teeth.planet, teeth.ring(), MeshKind::internal);
    }
  };
  stage(output, ring, "b", "first", toTranslate("first planet %1"));
  stage(carrier, output, "c", "second", toTranslate("second planet %1"));
  set.input(ring, Number(1));
  set.input(carrier, Number(0));
  set.brake("B1", suns);
  set.brake("B2", carrier);
  set.clutch("C", suns, ring);
  set.state("1", {"B2"}, ring, output);
  set.state("2", {"B1"}, ring, output);
  set.state("3", {"C"}, ring, output);
  set.state("R", {"B2"}, suns, output);
  return std::move(set).build();
}

}  // namespace geargraph
