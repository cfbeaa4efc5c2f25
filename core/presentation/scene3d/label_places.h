#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/presentation/scene3d/label_anchors.h"

namespace geargraph {

/// A label in the picture, in logical pixels: right from the left edge, down from the upper one.
struct LabelPlate {
  std::size_t label = 0;         ///< position in Stage::labels
  Eigen::Vector2d middle{0, 0};  ///< of the plate
  Eigen::Vector2d anchor{0, 0};  ///< of the leader line, which is left out where the plate covers it
  [[nodiscard]] bool hasLine() const { return (middle - anchor).norm() > kLabelRadius + 1; }
  /// Where the leader line meets the plate.
  [[nodiscard]] Eigen::Vector2d rim() const { return middle + kLabelRadius * (anchor - middle).normalized(); }
};

/// Places the labels of the kinds that are shown: a link's on its visible part (LabelAnchors), a joint's and
/// an axis' at its place; labels that would touch are pushed apart. A link that is not visible has no label.
/// Before the first VisibilityBuffer, links' labels are at the middles of their parts.
class LabelPlaces {
 public:
  void setShown(LabelKind kind, bool shown) { m_shown[static_cast<std::size_t>(kind)] = shown; }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_shown[static_cast<std::size_t>(kind)]; }
  void reset() { m_anchors.reset(); }
  /// Is there no map yet, or none since reset()?
  [[nodiscard]] bool areNew() const { return m_anchors.areNew(); }
  /// The overlays at the picture's upper and lower edge, which labels avoid; logical pixels.
  void setBorders(double above, double below) {
    m_above = above;
    m_below = below;
  }

  /// Labels of hidden instances are left out; with more than 60 all are. Cost: O(labels²), for pushing them
  /// apart.
  [[nodiscard]] std::vector<LabelPlate> find(const LabelGround& ground);

 private:
  [[nodiscard]] std::optional<LabelPlate> placed(const LabelGround& ground, std::size_t label) const;

  std::array<bool, 3> m_shown{true, false, false};  ///< by kind
  double m_above = 0;
  double m_below = 0;
  LabelAnchors m_anchors;
};

/// The largest round length (1, 2 or 5 times a power of ten) of at most `most` pixels in the picture, mm.
/// @pre both positive
[[nodiscard]] double niceLength(double millimetresPerPixel, double most);

}  // namespace geargraph
