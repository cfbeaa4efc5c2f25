#pragma once

#include <unordered_map>

#include "core/foundations/base/id.h"

namespace geargraph {

/// How an element is highlighted.
struct Emphasis {
  bool hovered = false;   ///< a halo only
  bool selected = false;  ///< accent colour with a halo
  /// On a highlighted cycle: +1 if its walk runs along the arrow, -1 against it, 0 not on it.
  int walk = 0;
  bool second = false;  ///< the walk is the second of two highlighted ones, which has its own colour

  [[nodiscard]] bool any() const { return hovered || selected || walk != 0; }
  friend bool operator==(const Emphasis&, const Emphasis&) = default;
};
/// Elements that are not in it are not highlighted.
using Emphases = std::unordered_map<ElementId, Emphasis>;

[[nodiscard]] inline Emphasis emphasisOf(const Emphases& emphases, const ElementId& element) {
  const auto found = emphases.find(element);
  return found == emphases.end() ? Emphasis{} : found->second;
}

// Depths of the marks of a drawing.
constexpr int kHaloDepth = 0;
constexpr int kLineDepth = 10;
constexpr int kLabelDepth = 20;
constexpr int kNoteDepth = 25;
constexpr int kNodeDepth = 30;
constexpr int kBadgeDepth = 40;
constexpr int kPreviewDepth = 50;

}  // namespace geargraph
