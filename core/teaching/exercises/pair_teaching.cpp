#include "core/teaching/exercises/pair_teaching.h"

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr const char* kExternalFactor = toTranslate(
    "Mesh %1 is external: seen from the carrier, its gears turn against each other, so that f is %2.");

constexpr const char* kInternalFactor =
    toTranslate("Mesh %1 is internal: seen from the carrier, its gears turn the same way, so that f is %2.");

constexpr PairTeaching kExternalTeaching{
    .signMistake = "external-as-internal",
    .signInRow =
        toTranslate("Mesh %1 is external: its gears turn against each other, seen from their carrier."),
    .signInTable = toTranslate("Mesh %1 is external: its gears turn opposite ways, seen from the carrier."),
    .sameWay = kExternalFactor,
    .againstEachOther = kExternalFactor};

constexpr PairTeaching kInternalTeaching{
    .signMistake = "internal-as-external",
    .signInRow = toTranslate("Mesh %1 is internal: both gears turn the same way, seen from their carrier."),
    .signInTable = toTranslate("Mesh %1 is internal: its gears turn the same way, seen from the carrier."),
    .sameWay = kInternalFactor,
    .againstEachOther = kInternalFactor};

constexpr PairTeaching kBevelTeaching{
    .signMistake = "bevel-sign",
    .signInRow =
        toTranslate("The sign of bevel mesh %1 follows from where its pitch point is, seen from both axes."),
    .signInTable =
        toTranslate("The sign of bevel mesh %1 follows from its pitch point, seen from both axes."),
    .sameWay =
        toTranslate("Mesh %1 is a bevel mesh: seen from the carrier, its gears turn the same way, so that f "
                    "is %2."),
    .againstEachOther =
        toTranslate("Mesh %1 is a bevel mesh: seen from the carrier, its gears turn against each other, so "
                    "that f is %2.")};

constexpr PairTeaching kBeltTeaching{
    .signMistake = "belt-sign",
    .signInRow = toTranslate("Mesh %1 is a belt: its pulleys turn the same way, seen from their carrier, and "
                             "against each other where it is crossed."),
    .signInTable = toTranslate("Mesh %1 is a belt: its pulleys turn the same way, seen from the carrier, and "
                               "opposite ways where it is crossed."),
    .sameWay =
        toTranslate("Mesh %1 is an open belt: seen from the carrier, its pulleys turn the same way, so "
                    "that f is %2."),
    .againstEachOther = toTranslate("Mesh %1 is a crossed belt: seen from the carrier, its pulleys turn "
                                    "against each other, so that f is %2.")};

constexpr const char* kPinsFactor =
    toTranslate("Mesh %1 is pins in holes: seen from the carrier, both links turn alike, so that f is %2.");

constexpr PairTeaching kPinsTeaching{
    .signMistake = "pins-sign",
    .signInRow = toTranslate("Mesh %1 is pins in holes: both links turn alike, seen from their carrier."),
    .signInTable = toTranslate("Mesh %1 is pins in holes: both links turn alike, seen from the carrier."),
    .sameWay = kPinsFactor,
    .againstEachOther = kPinsFactor};

constexpr const char* kRackFactor = toTranslate(
    "Mesh %1 is a rack: its sign follows from the side of the pinion on which it is, and f is %2.");

constexpr PairTeaching kRackTeaching{
    .signMistake = "rack-sign",
    .signInRow =
        toTranslate("The sign of rack %1 follows from the side of the pinion's axis on which its teeth are."),
    .signInTable =
        toTranslate("The sign of rack %1 follows from the side of the pinion's axis on which its teeth are."),
    .sameWay = kRackFactor,
    .againstEachOther = kRackFactor};

constexpr const char* kScrewFactor =
    toTranslate("Mesh %1 is a screw: its sign follows from the hand of the thread, and f is %2.");

constexpr PairTeaching kScrewTeaching{
    .signMistake = "screw-sign",
    .signInRow = toTranslate("The sign of screw %1 follows from the hand of its thread."),
    .signInTable = toTranslate("The sign of screw %1 follows from the hand of its thread."),
    .sameWay = kScrewFactor,
    .againstEachOther = kScrewFactor};

constexpr PairTeaching kCrossedTeaching{
    .signMistake = "crossed-sign",
    .signInRow =
        toTranslate("The sign of mesh %1 follows from the hands of its teeth and the way its axes cross."),
    .signInTable =
        toTranslate("The sign of mesh %1 follows from the hands of its teeth and the way its axes cross."),
    .sameWay = toTranslate(
        "Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its own axis, "
        "let both turn the same way, so that f is %2."),
    .againstEachOther =
        toTranslate("Mesh %1 is between axes that cross: the hands of its teeth, each gear seen along its "
                    "own axis, let them turn against each other, so that f is %2.")};

constexpr PairTeaching kFaceTeaching{
    .signMistake = "face-gear-sign",
    .signInRow = toTranslate(
        "The sign of face gear mesh %1 follows from where its pitch point is, seen from both axes."),
    .signInTable =
        toTranslate("The sign of face gear mesh %1 follows from its pitch point, seen from both axes."),
    .sameWay = toTranslate("Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own "
                           "axis, they turn the same way, so that f is %2."),
    .againstEachOther =
        toTranslate("Mesh %1 is a face gear and its pinion: seen from the carrier, each along its own axis, "
                    "they turn against each other, so that f is %2.")};

constexpr PairTeaching kHypoidTeaching{
    .signMistake = "hypoid-sign",
    .signInRow = toTranslate("The sign of hypoid mesh %1 follows from the half axes beside which its pitch "
                             "point is, as if the axes met."),
    .signInTable =
        toTranslate("The sign of hypoid mesh %1 follows from the half axes beside its pitch point."),
    .sameWay = toTranslate("Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its "
                           "gears turn the same way, so that f is %2."),
    .againstEachOther = toTranslate(
        "Mesh %1 is a hypoid mesh: seen from the carrier, each along its own axis, its gears turn "
        "against each other, so that f is %2.")};

}  // namespace

KindTable<MeshKind, PairTeaching>& pairTeachings() {
  static constinit KindTable<MeshKind, PairTeaching> table(
      &kExternalTeaching, &kInternalTeaching, &kBevelTeaching, &kBeltTeaching, &kPinsTeaching, &kRackTeaching,
      &kScrewTeaching, &kCrossedTeaching, &kCrossedTeaching, &kFaceTeaching, &kHypoidTeaching);
  return table;
}

const PairTeaching& pairTeaching(MeshKind kind) {
  return pairTeachings()[kind];
}

}  // namespace geargraph
