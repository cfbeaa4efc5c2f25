#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// An element that is the same in two mechanisms and has another label in the second.
struct Renumbered {
  ElementId element;
  int before = 0;
  int after = 0;
};

/// The links, turning joints and meshes, in the order of their new labels, whose label is another one because
/// elements were removed from `before`; nothing where none was removed: the labels that move while something
/// is drawn are those of what comes after it, as everybody expects. Cost: O(n + t + c).
[[nodiscard]] std::vector<Renumbered> renumberedByRemoval(const Mechanism& before, const Mechanism& after);

}  // namespace geargraph
