#pragma once

#include <vector>

#include "core/mechanism/placement/placed_mechanism.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// The part of a mechanism that a section drawing shows: the links that turning joints connect to the ground,
/// and the first of several equal planets. Its lists are shorter than the document's, so it has the paper's
/// labels of its elements in the document.
struct DrawnPart {
  Mechanism mechanism;
  ByLink<int> linkLabels;        ///< by position
  std::vector<int> jointLabels;  //
  std::vector<int> meshLabels;   //
  std::vector<int> loose;        ///< labels of links that no turning joints connect to the ground
  std::vector<int> closing;      ///< labels of turning joints that close a loop

  /// An element that is not drawn (`omitted`) because an equal one is (`drawn`).
  struct Represented {
    ElementId drawn;
    ElementId omitted;
  };
  std::vector<Represented> represented;
  /// A drawn set of planets that represents several equal ones, with the labels of the links.
  struct Planets {
    std::vector<int> drawn;   ///< link labels
    std::vector<int> others;  ///< those of all equal sets
    int count = 1;            ///< number of sets, including the drawn one
  };
  std::vector<Planets> planets;

  /// The colour of the link at this position.
  [[nodiscard]] Tint tintOf(LinkOrdinal link) const {
    const int label = linkLabels[link];
    return Tint::ofLink(label, mechanism.view.colorNumber(mechanism.links[link].id, label));
  }

  /// Is everything of the document drawn?
  [[nodiscard]] bool isWhole() const { return loose.empty() && closing.empty() && planets.empty(); }
};

/// Cost: O(n + t + c), and the meshes of equal planets sorted.
/// @pre the mechanism is well formed
[[nodiscard]] DrawnPart drawnPart(const PlacedMechanism& document);

}  // namespace geargraph
