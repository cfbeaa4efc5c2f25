#include "core/machine/train/pair_wheels.h"

namespace geargraph::inline train {
namespace {

constexpr PairWheels kTwoDiscs{GearKind::external, GearKind::external};
constexpr PairWheels kDiscInRing{GearKind::external, GearKind::internal};
constexpr PairWheels kTwoCones{GearKind::bevel, GearKind::bevel};

}  // namespace

KindTable<MeshKind, PairWheels>& pairWheels() {
  static constinit KindTable<MeshKind, PairWheels> table(&kTwoDiscs, &kDiscInRing, &kTwoCones);
  return table;
}

GearKind wheelOf(MeshKind kind, int teeth, int partnerTeeth) {
  const PairWheels& wheels = pairWheels()[kind];
  return teeth > partnerTeeth ? wheels.larger : wheels.smaller;
}

}  // namespace geargraph::inline train
