#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/fields.h"
#include "core/theory/statics/held_parts.h"

namespace geargraph {

/// The torques of StaticsSolution, fast enough for dragging: in doubles, with residues modulo a prime that
/// decide what is held, what is determined and what is 0.
struct LiveStatics {
  bool isBalanced = true;
  int rank = 0;
  int indeterminate = 0;         ///< self-stresses
  std::vector<double> values;    ///< by unknown: the meshes' mu, then the held parts; empty where unbalanced
  std::vector<char> determined;  ///< by unknown
};

/// std::nullopt if `stop` was requested. Cost: one live elimination, near linear in n + c.
[[nodiscard]] std::optional<LiveStatics> solveStaticsLive(const KinematicModel& model,
                                                          const ModularDoubleField& field,
                                                          std::span<const HeldPart> held,
                                                          const RadicalColumns& loads,
                                                          const std::stop_token& stop = {});

}  // namespace geargraph
