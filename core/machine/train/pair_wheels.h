#pragma once

#include "core/foundations/base/kind_table.h"
#include "core/machine/teeth/gear_spec.h"
#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {

/// What trains know of a kind of gear pair: which wheels make it.
struct PairWheels {
  GearKind smaller;  ///< of the wheel with fewer teeth, and of both where they have as many
  GearKind larger;
  bool none = false;  ///< it has no wheels of its own
};

[[nodiscard]] KindTable<MeshKind, PairWheels>& pairWheels();
/// The kind of a pair's wheel with so many teeth.
[[nodiscard]] GearKind wheelOf(MeshKind kind, int teeth, int partnerTeeth);

}  // namespace geargraph
