#pragma once

#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {

/// What is taught about a kind of gear pair. Sentences are marked by toTranslate().
struct PairTeaching {
  const char* signMistake = "";  ///< the name of the mistake of its sign, for graders
  /// Where its sign comes from; %1: the mesh. In a row of coefficients, and in a table of the student.
  const char* signInRow = "";
  const char* signInTable = "";
  /// Why the factor of its terminal equation has this sign; %1: the mesh, %2: the factor. Where the gears
  /// turn the same way seen from the carrier, each along its own axis, and where against each other.
  const char* sameWay = "";
  const char* againstEachOther = "";
};

[[nodiscard]] KindTable<MeshKind, PairTeaching>& pairTeachings();
[[nodiscard]] const PairTeaching& pairTeaching(MeshKind kind);

}  // namespace geargraph
