#pragma once

#include <optional>

#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {

/// What the T-T graph knows of a kind of gear pair: the sign of its terminal equation (mesh_sign.h) as far as
/// it needs no pitch point. It takes no step of the other method, which has the sign from the pitch radii.
struct TerminalRule {
  /// For parallel axes; `sense`: +1 where they point the same way, else -1. std::nullopt: the pitch point
  /// decides.
  std::optional<int> (*alongParallels)(int sense) = nullptr;
  /// For skew axes: from the sum beta_i + beta_j + Sigma of the helix angles and the crossing angle, a whole
  /// number of half turns, because the teeth of both run the same way where they touch.
  std::optional<int> (*acrossSkew)(double sum) = nullptr;
};

[[nodiscard]] KindTable<MeshKind, TerminalRule>& terminalRules();

}  // namespace geargraph
