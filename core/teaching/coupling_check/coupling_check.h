#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/coupling_check/written_coupling.h"
#include "core/theory/matroid/joint_coupling.h"

namespace geargraph {

/// Something that a controller's file says, and what is wrong with it.
struct CouplingFinding {
  /// "right", "transposed", "other-matrix", "torque-matrix", "order", "sign", "factor", "entry",
  /// "not-inverse", "offsets"; of "order", "sign" and "factor" nothing else is wrong with the matrix.
  std::string_view name;
  std::string sentence;  ///< in the current language
  bool isError = true;
};

/// Holds the written matrices against those of the train, and against each other. A matrix that is wrong as a
/// whole is named by the first of these that explains all of its entries: transposed; the inverse; the matrix
/// of torques; joints or motors in another order (up to 4); joints or motors that turn the other way; rows or
/// columns with a factor of their own. Else the entries are named that differ, at most 12.
/// Both together have to be inverse of each other, and offsets: motorOffsets = -A^-1 jointOffsets.
/// Cost: O(E^3), and up to 576 permutations. @pre as many rows as the coupling has
[[nodiscard]] std::vector<CouplingFinding> checkWrittenCoupling(const Mechanism& mechanism,
                                                                const JointCoupling& coupling,
                                                                const WrittenCoupling& written);

/// `check --json` of a coupling.
[[nodiscard]] std::string couplingCheckJson(const Mechanism& mechanism, const JointCoupling& coupling,
                                            const std::vector<CouplingFinding>& findings);

}  // namespace geargraph
