#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/derivation/method_comparison.h"

namespace geargraph {

/// Families of trains of any size, on which the operations of both methods are counted.
enum class TrainFamily {
  chain,  ///< spur gears on the ground, each in mesh with the next
  stack,  ///< planetary sets in line: the carrier of one is the sun's link of the next, the rings on the
          ///< ground
  wrist,  ///< nested arms about axes that intersect at right angles, each driven by bevel gears from the
          ///< ground
};
[[nodiscard]] std::string familyName(TrainFamily family);
/// The family with its size: "8 gears in a row"; translated.
[[nodiscard]] std::string familyText(TrainFamily family, int size);

/// A train with this number of gears, sets or arms, at least 2, 1 and 1. Its inputs are chosen by the
/// program.
[[nodiscard]] Mechanism familyTrain(TrainFamily family, int size);

/// The operation counts of both methods on one train of a family.
struct FamilyCount {
  TrainFamily family = TrainFamily::chain;
  int size = 0;
  int links = 0;
  int meshes = 0;
  Operations matroidSetUp;
  Operations matroid;
  Operations ttGraph;
};
/// All families, each by size, up to some thirty links. Computed once per program run. Cost: some tens of
/// milliseconds.
[[nodiscard]] const std::vector<FamilyCount>& familyCounts();

}  // namespace geargraph
