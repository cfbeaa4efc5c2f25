#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/design/atlas/chain.h"
#include "core/design/atlas/residue_rows.h"

namespace geargraph {

constexpr int kMaxCountedMeshes = 20;

/// The first definition of a degenerate chain: some m of its meshes have, carriers included, fewer than m + 2
/// links between them. Returns the fewest such meshes, of those the first in order; std::nullopt if there are
/// none.
///
/// Cost: O(2^meshes). @pre at most kMaxCountedMeshes meshes
[[nodiscard]] std::optional<std::vector<int>> degenerateMeshes(const Chain& chain);

/// The teeth of a mesh with their sign: N_tail w_tail = s N_head w_head, the speeds relative to the carrier.
struct SignedTeeth {
  std::int64_t tail = 1;
  std::int64_t head = 1;  ///< s N_head
};

/// What the speed equations N_i (w_i - w_k) = s N_j (w_j - w_k) of the meshes leave free.
struct ChainMotion {
  int rank = 0;              ///< of the equations
  int dof = 0;               ///< links - 1 - rank: the freedom with one link held
  bool isDependent = false;  ///< rank below the number of meshes
  /// Two links that turn as one in every motion, the first in order.
  std::optional<std::pair<int, int>> locked;

  /// The second definition of a degenerate chain, at generic ratios: dependent equations, or two links that
  /// turn as one. Both definitions are the same, which tests hold against each other.
  [[nodiscard]] bool isDegenerate() const { return isDependent || locked.has_value(); }
};

/// The equation of a mesh as a row over all links.
[[nodiscard]] ResidueRow speedRow(const PrimeField& field, const ChainMesh& mesh, const SignedTeeth& teeth,
                                  std::size_t links);

/// The motion of a chain with these teeth, one entry a mesh. Modulo a 61-bit prime: a rank below the true one
/// has a probability near 2^-55. Of no use if `stop` was requested. Cost: O(links meshes^2 + links^2 log
/// links).
[[nodiscard]] ChainMotion chainMotion(const Chain& chain, std::span<const SignedTeeth> teeth,
                                      const std::stop_token& stop = {});

/// The motion at generic ratios: random ones, drawn from `seed`.
[[nodiscard]] ChainMotion genericMotion(const Chain& chain, std::uint64_t seed = 1,
                                        const std::stop_token& stop = {});

}  // namespace geargraph
