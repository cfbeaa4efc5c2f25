#pragma once

#include <stop_token>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph::inline matroid {

/// What the coefficient matrix P says without any choice of inputs [AU, Eq. (21)].
///
/// Identity  dof = t - rank; the meshes that depend on others are c - rank.
struct Structure {
  int rank = 0;            ///< of P (the paper says: of the cycle-basis matrix, whose rank is always c)
  int dof = 0;             ///< E: the number of inputs
  int kutzbachDof = 0;     ///< n - c, which is E only where no mesh is redundant
  std::vector<char> dead;  ///< by joint: it can never turn
  std::vector<char> idle;  ///< by joint: no mesh's cycle contains it, so it has to be an input

  /// The elimination behind it, modulo the first prime: free unknowns are free phi.
  Elimination<Fused> system;
};

/// Rank, freedom, dead and idle joints, modulo a 61-bit prime and confirmed with a second one where rank
/// falls short of the number of meshes. Nothing where `stop` was requested. Cost: near linear in n + c.
[[nodiscard]] std::optional<Structure> structureOf(const KinematicModel& model, const FusedField& field,
                                                   const std::stop_token& stop = {});

/// By joint: on no mesh's cycle. Cost: O(n + c).
[[nodiscard]] std::vector<char> idleJoints(const KinematicModel& model);

/// Links that turn as one in every motion: components of at least two links held together by dead joints, the
/// links ascending.
[[nodiscard]] std::vector<std::vector<int>> rigidBlocks(const KinematicModel& model,
                                                        const std::vector<char>& dead);

/// The mesh rows over the phi, in a field's numbers.
template <class Field>
[[nodiscard]] SparseRows<typename Field::Value> meshRows(const KinematicModel& model, const Field& field) {
  SparseRows<typename Field::Value> rows;
  rows.reserve(static_cast<std::size_t>(model.c()), 3 * static_cast<std::size_t>(model.c()));
  for (int mesh = 0; mesh < model.c(); ++mesh) {
    model.addMeshRow(rows, mesh, field);
    rows.endRow();
  }
  return rows;
}

}  // namespace geargraph::inline matroid
