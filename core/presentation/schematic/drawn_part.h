#pragma once

#include <vector>

#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline schematic {

/// What a section drawing can show of a mechanism: the links that turning joints tie to the ground, and of
/// several equal planets the first. Its lists are shorter than the document's, so it brings along the
/// paper's labels that its elements have there.
struct DrawnPart {
  Mechanism mechanism;
  std::vector<int> linkLabels;   ///< by position
  std::vector<int> jointLabels;  //
  std::vector<int> meshLabels;   //
  std::vector<int> loose;        ///< labels of links that no turning joint ties to the ground
  std::vector<int> closing;      ///< labels of turning joints that close a loop

  /// Elements that are not drawn because they are like one that is.
  struct Alike {
    ElementId drawn;
    ElementId like;
  };
  std::vector<Alike> alike;
  /// How many of a kind one drawn set of planets stands for, with the labels of the links.
  struct Planets {
    std::vector<int> drawn;   ///< link labels
    std::vector<int> others;  ///< those of all sets that are like it
    int count = 1;            ///< sets, the drawn one included
  };
  std::vector<Planets> planets;

  /// Is everything of the document drawn?
  [[nodiscard]] bool isWhole() const { return loose.empty() && closing.empty() && planets.empty(); }
};

/// Cost: O(n + t + c), and the meshes of equal planets sorted.
/// @pre the mechanism is well formed
[[nodiscard]] DrawnPart drawnPart(const PlacedMechanism& document);

}  // namespace geargraph::inline schematic
