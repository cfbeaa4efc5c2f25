#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mechanism/placement/placed_mechanism.h"
#include "tests/soak/random_edits.h"

namespace geargraph::soak {

inline Expected<Mechanism> mechanismOf(Expected<Mechanism> edited) {
  return edited;
}
inline Expected<Mechanism> mechanismOf(const Expected<PlacedMechanism>& edited) {
  if (!edited) return edited.error();
  return edited->mechanism();
}

/// A kind of edit whose arguments, after the mechanism, are what `draw` draws.
template <auto function, class Draw>
EditKind kind(std::string name, Draw draw, int weight = 4) {
  return {std::move(name),
          [draw](RandomArguments& random) -> Reduce {
            return [arguments = draw(random)](const Mechanism& before) {
              return mechanismOf(
                  std::apply([&](const auto&... each) { return function(before, each...); }, arguments));
            };
          },
          weight};
}

/// Loads, balances, losses, masses and gravity.
[[nodiscard]] std::vector<EditKind> forceEdits();

}  // namespace geargraph::soak
