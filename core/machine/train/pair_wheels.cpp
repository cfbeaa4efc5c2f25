#include "core/machine/train/pair_wheels.h"

#include "core/machine/teeth/worm.h"

namespace geargraph {
namespace {

constexpr PairWheels kTwoDiscs{GearKind::external, GearKind::external};
constexpr PairWheels kDiscInRing{GearKind::external, GearKind::internal};
constexpr PairWheels kTwoCones{GearKind::bevel, GearKind::bevel};
constexpr PairWheels kTwoPulleys{GearKind::pulley, GearKind::pulley};
constexpr PairWheels kWormAndWheel{GearKind::worm, GearKind::wormWheel};
static_assert(kMaxStarts == kMaxWormStarts);
/// Pins have none, and no solids are made of racks and screws.
constexpr PairWheels kNoWheels{.smaller = GearKind::pulley, .larger = GearKind::pulley, .none = true};

constexpr PairWheels kPinionAndFace{GearKind::external, GearKind::faceGear};
constexpr PairWheels kTwoOffsetCones{GearKind::hypoid, GearKind::hypoid};

}  // namespace

KindTable<MeshKind, PairWheels>& pairWheels() {
  static constinit KindTable<MeshKind, PairWheels> table(&kTwoDiscs, &kDiscInRing, &kTwoCones, &kTwoPulleys,
                                                         &kNoWheels, &kNoWheels, &kNoWheels, &kTwoDiscs,
                                                         &kWormAndWheel, &kPinionAndFace, &kTwoOffsetCones);
  return table;
}

GearKind wheelOf(MeshKind kind, int teeth, int partnerTeeth) {
  const PairWheels& wheels = pairWheels()[kind];
  return teeth > partnerTeeth ? wheels.larger : wheels.smaller;
}

}  // namespace geargraph
