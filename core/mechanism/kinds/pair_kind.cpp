#include "core/mechanism/kinds/pair_kind.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

double sumOf(double tail, double head) {
  return tail + head;
}

double differenceOf(double tail, double head) {
  return std::abs(tail - head);
}

DistanceForm sumForm(int partner, bool /*isLarger*/) {
  return {1, partner};
}

DistanceForm differenceForm(int partner, bool isLarger) {
  return isLarger ? DistanceForm{1, -partner} : DistanceForm{-1, partner};
}

/// The ring round sun and planet.
std::optional<SecondCentral> ringAround(int planet, int sun) {
  return SecondCentral{MeshKind::internal, sun + 2 * planet};
}

std::optional<SecondCentral> noSecond(int /*planet*/, int /*central*/) {
  return std::nullopt;
}

/// Pulleys with room for the strand between them. Their distance is free: this is where they are put.
DistanceForm looseForm(int partner, bool /*isLarger*/) {
  constexpr int kGap = 20;  // half modules
  return {1, partner + kGap};
}

/// The second side gear of a differential.
std::optional<SecondCentral> sideGear(int /*planet*/, int side) {
  return SecondCentral{MeshKind::bevel, side};
}

constexpr PairKind kExternal{.name = "external",
                             .word = toTranslate("external"),
                             .makeIt = toTranslate("Make %1 external"),
                             .distance = sumOf,
                             .distanceForm = sumForm,
                             .secondCentral = ringAround,
                             .other = MeshKind::internal};

constexpr PairKind kInternal{.name = "internal",
                             .word = toTranslate("internal"),
                             .makeIt = toTranslate("Make %1 internal"),
                             .sense = 1,
                             .hasRing = true,
                             .distance = differenceOf,
                             .distanceForm = differenceForm,
                             .secondCentral = noSecond,
                             .other = MeshKind::external};

constexpr PairKind kBevel{.name = "bevel",
                          .word = toTranslate("bevel"),
                          .makeIt = toTranslate("Make %1 bevel"),
                          .axes = LinePosition::intersecting,
                          .sense = 0,
                          .distance = sumOf,
                          .distanceForm = sumForm,
                          .secondCentral = sideGear,
                          .other = std::nullopt};

constexpr PairKind kBelt{.name = "belt",
                         .word = toTranslate("belt"),
                         .makeIt = toTranslate("Make %1 a belt"),
                         .sense = 1,
                         .touches = false,
                         .canCross = true,
                         .distance = sumOf,
                         .distanceForm = looseForm,
                         .secondCentral = noSecond,
                         .other = std::nullopt,
                         .since = 2};

constexpr PairKind kPins{.name = "pins",
                         .word = toTranslate("pins"),
                         .makeIt = toTranslate("Make %1 a pair of pins and holes"),
                         .sense = 1,
                         .touches = false,
                         .hasTeeth = false,
                         .distance = sumOf,
                         .distanceForm = sumForm,
                         .secondCentral = noSecond,
                         .other = std::nullopt,
                         .since = 2};

constexpr PairKind kRack{.name = "rack",
                         .word = toTranslate("rack"),
                         .makeIt = toTranslate("Make %1 a rack and pinion"),
                         .axes = LinePosition::skew,
                         .sense = 0,
                         .touches = false,
                         .slides = true,
                         .distance = sumOf,
                         .distanceForm = sumForm,
                         .secondCentral = noSecond,
                         .other = std::nullopt,
                         .since = 2};

constexpr PairKind kScrew{.name = "screw",
                          .word = toTranslate("screw"),
                          .makeIt = toTranslate("Make %1 a screw and nut"),
                          .sense = 0,
                          .touches = false,
                          .hasTeeth = false,
                          .slides = true,
                          .distance = sumOf,
                          .distanceForm = looseForm,
                          .secondCentral = noSecond,
                          .other = std::nullopt,
                          .since = 2};

constexpr PairKind kCrossedHelical{.name = "crossedHelical",
                                   .word = toTranslate("crossed helical"),
                                   .makeIt = toTranslate("Make %1 crossed helical"),
                                   .axes = LinePosition::skew,
                                   .sense = 0,
                                   .distance = sumOf,
                                   .distanceForm = sumForm,
                                   .secondCentral = noSecond,
                                   .other = MeshKind::worm,
                                   .since = 2};

constexpr PairKind kWorm{.name = "worm",
                         .word = toTranslate("worm"),
                         .makeIt = toTranslate("Make %1 a worm"),
                         .axes = LinePosition::skew,
                         .sense = 0,
                         .isThreaded = true,
                         .distance = sumOf,
                         .distanceForm = sumForm,
                         .secondCentral = noSecond,
                         .other = MeshKind::crossedHelical,
                         .since = 2};

constexpr PairKind kFaceGear{.name = "faceGear",
                             .word = toTranslate("face gear"),
                             .makeIt = toTranslate("Make %1 a face gear"),
                             .axes = LinePosition::intersecting,
                             .sense = 0,
                             .isSquare = true,
                             .statesHelix = false,
                             .hasFace = true,
                             .distance = sumOf,
                             .distanceForm = sumForm,
                             .secondCentral = noSecond,
                             .other = MeshKind::bevel,
                             .since = 2};

constexpr PairKind kHypoid{.name = "hypoid",
                           .word = toTranslate("hypoid"),
                           .makeIt = toTranslate("Make %1 hypoid"),
                           .axes = LinePosition::skew,
                           .sense = 0,
                           .statesHelix = false,
                           .isOffset = true,
                           .distance = sumOf,
                           .distanceForm = sumForm,
                           .secondCentral = noSecond,
                           .other = MeshKind::crossedHelical,
                           .since = 2};

template <class Fits>
MeshKind firstKind(const Fits& fits) {
  const auto all = meshKinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](MeshKind each) { return fits(pairKind(each)); });
  GEARGRAPH_REQUIRE(found != all.end());
  return *found;
}

}  // namespace

KindTable<MeshKind, PairKind>& pairKinds() {
  static constinit KindTable<MeshKind, PairKind> table(&kExternal, &kInternal, &kBevel, &kBelt, &kPins,
                                                       &kRack, &kScrew, &kCrossedHelical, &kWorm, &kFaceGear,
                                                       &kHypoid);
  return table;
}

const PairKind& pairKind(MeshKind kind) {
  return pairKinds()[kind];
}

std::span<const MeshKind> meshKinds() {
  return pairKinds().kinds();
}

std::string_view meshKindName(MeshKind kind) {
  return pairKind(kind).name;
}

std::string kindWord(MeshKind kind) {
  return translated(std::string_view(pairKind(kind).word));
}

std::optional<MeshKind> meshKindFrom(std::string_view name) {
  for (const MeshKind kind : meshKinds()) {
    if (name == meshKindName(kind)) return kind;
  }
  return std::nullopt;
}

MeshKind usualKind(LinePosition axes, int sense) {
  return firstKind([&](const PairKind& kind) {
    return kind.axes == axes && (sense * kind.sense == 0 || kind.sense == sense);
  });
}

MeshKind ringKind() {
  return firstKind([](const PairKind& kind) { return kind.hasRing; });
}

bool hasParallelAxes(MeshKind kind) {
  return pairKind(kind).axes == LinePosition::parallel && touches(kind);
}

bool hasIntersectingAxes(MeshKind kind) {
  return pairKind(kind).axes == LinePosition::intersecting;
}

bool hasSkewAxes(MeshKind kind) {
  return pairKind(kind).axes == LinePosition::skew;
}

bool isBesideEachOther(MeshKind kind) {
  return hasParallelAxes(kind) && !hasRing(kind);
}

bool hasRing(MeshKind kind) {
  return pairKind(kind).hasRing;
}

bool touches(MeshKind kind) {
  return pairKind(kind).touches;
}

bool turnsAlike(MeshKind kind) {
  return pairKind(kind).sense > 0;
}

bool slides(MeshKind kind) {
  return pairKind(kind).slides;
}

int distanceTeeth(MeshKind kind, int tailTeeth, int headTeeth) {
  const DistanceForm form = pairKind(kind).distanceForm(headTeeth, tailTeeth > headTeeth);
  return form.sign * tailTeeth + form.rest;
}

}  // namespace geargraph
