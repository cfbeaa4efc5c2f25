#pragma once

#include <cstdint>
#include <stop_token>
#include <string>

#include "core/presentation/scene/image.h"
#include "core/presentation/scene3d/scene_view.h"

namespace geargraph {

/// The kind of an animation: the camera once around the train, or the train through its period.
enum class AnimationKind : std::uint8_t { turntable, motion };

constexpr int kMaxAnimationFrames = 10'000;

/// An animation of a view. It loops seamlessly: the first picture follows the last one, if the motion has a
/// period.
struct Animation {
  AnimationKind kind = AnimationKind::turntable;
  int frames = 72;
  double framesPerSecond = 24;
  double seconds = 0;  ///< of motion that the whole animation shows; 0: one period, back and forth between
                       ///< the limits of joints, or a minute where there is none
};

/// The time span of the motion in the animation, s.
[[nodiscard]] double animationSpan(const MechanismScene& stage, const Animation& animation);

/// The view of one picture of the animation; a view with a trajectory follows it and starts again at its end.
/// Identity: picture 0 is the view itself. @pre 0 <= picture < frames
[[nodiscard]] SceneView animationView(const MechanismScene& stage, const SceneView& view,
                                      const Animation& animation, int picture);

/// Writes an animated PNG (PNG third edition, APNG) piece by piece; programs without support for animation
/// show its first picture. After the first, only the changed rectangle is stored.
class AnimatedPng {
 public:
  /// @pre exactly `pictures` images will be added, all of one size; they repeat forever
  AnimatedPng(int pictures, double framesPerSecond);
  /// The next bytes of the file; empty if libpng fails (out of memory) or `stop` was requested.
  [[nodiscard]] std::string add(const Image& image, const std::stop_token& stop = {});
  /// The last bytes. @pre all pictures were added
  [[nodiscard]] std::string end() const;

 private:
  struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
  };
  [[nodiscard]] Rectangle changed(const Image& image) const;
  [[nodiscard]] std::string control(const Rectangle& where);

  int m_pictures;
  std::uint16_t m_delay;  ///< ms per picture
  std::uint32_t m_sequence = 0;
  int m_added = 0;
  Image m_last;
};

}  // namespace geargraph
