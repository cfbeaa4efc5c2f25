#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/render/camera.h"
#include "core/render/renderer.h"
#include "core/render/stage.h"

namespace geargraph {

/// Half of a label's plate, in logical pixels.
constexpr double kLabelRadius = 11.5;

/// A label's plate in the picture, in logical pixels: right from the left edge, down from the upper one.
struct LabelPlace {
  std::size_t label = 0;  ///< position in Stage::labels
  double x = 0;
  double y = 0;
};

/// What a picture shows, and how.
struct LabelGround {
  const Stage& stage;
  std::span<const Pose> poses;
  std::span<const Showing> showing;  ///< empty: everything
  const Camera& camera;
  const Viewport& viewport;
  double pixelRatio = 1;
};

/// Places for the labels of the kinds that are shown: a link's beside its part, on the side away from the
/// train's middle, a joint's and an axis' at its place; pushed apart where two would touch. A link's changes
/// sides only when its part has clearly crossed the middle, so that turning parts do not make it flicker.
class LabelPlaces {
 public:
  void setShown(LabelKind kind, bool shown) { m_shown[static_cast<std::size_t>(kind)] = shown; }
  [[nodiscard]] bool isShown(LabelKind kind) const { return m_shown[static_cast<std::size_t>(kind)]; }
  void reset() { m_sides.clear(); }
  /// What lies over the picture's upper and lower edge, which labels keep clear of; logical pixels.
  void setBorders(double above, double below) {
    m_above = above;
    m_below = below;
  }

  /// Labels of hidden instances are left out; so are all of more than 60. Cost: O(labels²), for the pushing.
  [[nodiscard]] std::vector<LabelPlace> find(const LabelGround& ground);

 private:
  std::array<bool, 3> m_shown{true, false, false};  ///< by kind
  double m_above = 0;
  double m_below = 0;
  std::vector<int> m_sides;  ///< by label: -1 left, +1 right, 0 not placed yet
};

/// A length that reads well (1, 2 or 5 times a power of ten) and takes at most `most` pixels of the picture.
/// @pre both positive
[[nodiscard]] double niceLength(double millimetresPerPixel, double most);

}  // namespace geargraph
