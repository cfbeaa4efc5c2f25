#include "core/machine/teeth/wheel_kind.h"

#include <cmath>

#include "core/machine/teeth/face_gear.h"
#include "core/machine/teeth/tooth_pair.h"
#include "core/machine/teeth/worm.h"
#include "core/machine/teeth/worm_cut.h"

namespace geargraph {
namespace {

double discTip(const GearSpec& spec) {
  if (spec.tipRadius > 0) return spec.tipRadius * spec.module;
  return pitchRadius(spec) + (spec.addendum + spec.profileShift) * spec.module;
}

double discRoot(const GearSpec& spec) {
  return pitchRadius(spec) - (spec.dedendum - spec.profileShift) * spec.module;
}

double ringTip(const GearSpec& spec) {
  if (spec.tipRadius > 0) return spec.tipRadius * spec.module;
  return pitchRadius(spec) - (spec.addendum - spec.profileShift) * spec.module;
}

double ringRoot(const GearSpec& spec) {
  return pitchRadius(spec) + (spec.dedendum + spec.profileShift) * spec.module;
}

double coneTip(const GearSpec& spec) {
  return pitchRadius(spec) + (spec.addendum + spec.profileShift) * spec.module * std::cos(spec.coneAngle);
}

double coneRoot(const GearSpec& spec) {
  return pitchRadius(spec) - (spec.dedendum - spec.profileShift) * spec.module * std::cos(spec.coneAngle);
}

double sameAsVirtual(const GearSpec& /*spec*/) {
  return 1;
}

double backConeShare(const GearSpec& spec) {
  return std::cos(spec.coneAngle);
}

double ringContactRatio(const GearSpec& ring, const HalfTooth& ringTooth, const GearSpec& pinion,
                        const HalfTooth& pinionTooth, double distance) {
  return planeContactRatio(pinion, pinionTooth, ring, ringTooth, distance);
}

constexpr WheelKind kExternalWheel{.name = "external",
                                   .tipRadius = discTip,
                                   .rootRadius = discRoot,
                                   .shareOfVirtual = sameAsVirtual,
                                   .tooth = externalTooth,
                                   .contactRatio = planeContactRatio};

constexpr WheelKind kRingWheel{.name = "internal",
                               .isRing = true,
                               .cornerRadius = 0.25,
                               .fewestTeeth = kMinRingTeeth,
                               .tipRadius = ringTip,
                               .rootRadius = ringRoot,
                               .shareOfVirtual = sameAsVirtual,
                               .tooth = ringTooth,
                               .contactRatio = ringContactRatio};

constexpr WheelKind kBevelWheel{.name = "bevel",
                                .isConical = true,
                                .cornerRadius = 0.30,
                                .tipRadius = coneTip,
                                .rootRadius = coneRoot,
                                .shareOfVirtual = backConeShare,
                                .tooth = bevelTooth,
                                .withHelix = spiral,
                                .contactRatio = bevelContactRatio};

/// The surface of a pulley lies under its belt, half of whose thickness the running radius includes.
double pulleySurface(const GearSpec& spec) {
  return pitchRadius(spec) - kHalfBelt * spec.module;
}

constexpr WheelKind kPulleyWheel{.name = "pulley",
                                 .fewestTeeth = 1,
                                 .tipRadius = pulleySurface,
                                 .rootRadius = pulleySurface,
                                 .shareOfVirtual = sameAsVirtual};

constexpr WheelKind kWormWheel{.name = "worm",
                               .fewestTeeth = 1,
                               .tipRadius = discTip,
                               .rootRadius = discRoot,
                               .shareOfVirtual = sameAsVirtual,
                               .tooth = wormTooth,
                               .withHelix = wormWithHelix,
                               .toothSize = axialModule,
                               .usualFace = usualWormFace,
                               .contactRatio = wormContactRatio};

/// In its mid plane, where the worm is a rack, it is an ordinary gear.
constexpr WheelKind kThroatedWheel{.name = "wormWheel",
                                   .tipRadius = wormWheelReach,
                                   .rootRadius = discRoot,
                                   .shareOfVirtual = sameAsVirtual,
                                   .tooth = externalTooth,
                                   .withHelix = wormWheelWithHelix,
                                   .usualFace = usualWheelFace,
                                   .contactRatio = wormWheelContactRatio};

double faceTips(const GearSpec& spec) {
  return faceInner(spec) + spec.faceWidth;
}

/// Its teeth are on a plane, so that it has no root circle: where they end inwards.
constexpr WheelKind kFaceWheel{.name = "faceGear",
                               .isFace = true,
                               .tipRadius = faceTips,
                               .rootRadius = faceInner,
                               .shareOfVirtual = sameAsVirtual,
                               .tooth = faceTooth,
                               .usualFace = usualFaceGearFace,
                               .contactRatio = faceContactRatio};

/// A stand-in: its pitch cone.
constexpr WheelKind kHypoidWheel{.name = "hypoid",
                                 .isConical = true,
                                 .isStandIn = true,
                                 .cornerRadius = 0.30,
                                 .tipRadius = pitchRadius,
                                 .rootRadius = pitchRadius,
                                 .shareOfVirtual = backConeShare,
                                 .withHelix = spiral};

}  // namespace

KindTable<GearKind, WheelKind>& wheelKinds() {
  static constinit KindTable<GearKind, WheelKind> table(&kExternalWheel, &kRingWheel, &kBevelWheel,
                                                        &kPulleyWheel, &kWormWheel, &kThroatedWheel,
                                                        &kFaceWheel, &kHypoidWheel);
  return table;
}

const WheelKind& wheelKind(GearKind kind) {
  return wheelKinds()[kind];
}

std::span<const GearKind> gearKinds() {
  return wheelKinds().kinds();
}

std::string_view gearKindName(GearKind kind) {
  return wheelKind(kind).name;
}

HalfTooth toothOf(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(isToothed(spec));
  return wheelKind(spec.kind).tooth(spec, tolerance);
}

bool isRing(const GearSpec& spec) {
  return wheelKind(spec.kind).isRing;
}

bool isConical(const GearSpec& spec) {
  return wheelKind(spec.kind).isConical;
}

bool isToothed(const GearSpec& spec) {
  return wheelKind(spec.kind).tooth != nullptr;
}

bool isFaceGear(const GearSpec& spec) {
  return wheelKind(spec.kind).isFace;
}

bool isDisc(const GearSpec& spec) {
  return !isRing(spec) && !isConical(spec) && !isFaceGear(spec);
}

}  // namespace geargraph
