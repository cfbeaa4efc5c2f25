#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/presentation/stage/label_anchors.h"

namespace geargraph::inline stage {

/// A label in the picture, in logical pixels: right from the left edge, down from the upper one.
struct LabelPlate {
  std::size_t label = 0;         ///< position in Stage::labels
  Eigen::Vector2d middle{0, 0};  ///< of the plate
  Eigen::Vector2d anchor{0, 0};  ///< what it speaks of; a line leads there where the plate does not cover it
  [[nodiscard]] bool hasLine() const { return (middle - anchor).norm() > kLabelRadius + 1; }
  /// Where that line meets the plate.
  [[nodiscard]] Eigen::Vector2d rim() const { return middle + kLabelRadius * (anchor - middle).normalized(); }
};

/// Places for the labels of the kinds that are shown: a link's on what is seen of it (LabelAnchors), a
/// joint's and an axis' at its place; pushed apart where two would touch. A link that is not seen has no
/// label. Before the first map of what is seen, links' labels stand at the middles of their parts.
class LabelPlaces {
 public:
  void setShown(LabelKind kind, bool shown) { m_shown[static_cast<std::size_t>(kind)] = shown; }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_shown[static_cast<std::size_t>(kind)]; }
  void reset() { m_anchors.reset(); }
  /// No map was seen yet, or none since reset().
  [[nodiscard]] bool areNew() const { return m_anchors.areNew(); }
  /// What lies over the picture's upper and lower edge, which labels keep clear of; logical pixels.
  void setBorders(double above, double below) {
    m_above = above;
    m_below = below;
  }

  /// Labels of hidden instances are left out; so are all of more than 60. Cost: O(labels²), for the pushing.
  [[nodiscard]] std::vector<LabelPlate> find(const LabelGround& ground);

 private:
  [[nodiscard]] std::optional<LabelPlate> placed(const LabelGround& ground, std::size_t label) const;

  std::array<bool, 3> m_shown{true, false, false};  ///< by kind
  double m_above = 0;
  double m_below = 0;
  LabelAnchors m_anchors;
};

/// A length that reads well (1, 2 or 5 times a power of ten) and takes at most `most` pixels of the picture.
/// @pre both positive
[[nodiscard]] double niceLength(double millimetresPerPixel, double most);

}  // namespace geargraph::inline stage
