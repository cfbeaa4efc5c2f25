#pragma once

#include <array>
#include <cmath>

#include "core/presentation/gl_renderer/primitives.h"

// What the tests of pictures share: small scenes, faces on no ground, and what is seen in a picture.
namespace geargraph {

constexpr Viewport kView{320, 240};
constexpr unsigned kBlue = 0x0072B2;
constexpr unsigned kOrange = 0xD55E00;
constexpr unsigned kGreen = 0x009E73;

inline std::size_t add(Scene& scene, Solid solid, const Eigen::Vector3d& place, unsigned colour,
                       const char* link) {
  scene.solids.push_back(std::make_shared<const Solid>(std::move(solid)));
  Instance instance;
  instance.solid = scene.solids.size() - 1;
  instance.pose.translation() = place;
  instance.colour = Rgb::fromHex(colour);
  instance.element = LinkId(link);
  scene.instances.push_back(instance);
  return scene.instances.size() - 1;
}

/// Faces and nothing else, on no ground.
inline RenderStyle bare() {
  RenderStyle style = RenderStyle::light();
  style.transparent = true;
  style.edges = style.contactShadow = style.triad = false;
  style.discStrength = 0;
  style.samples = 1;
  return style;
}

inline Frame frameOf(const Scene& scene, const RenderStyle& style, StandardView view) {
  Frame frame;
  frame.viewport = kView;
  frame.style = style;
  frame.camera = Camera::looking(view).fitted(cornersOf(scene), kView);
  return frame;
}

/// How much of the picture is not ground, 0 to 1.
inline double coverage(const Image& image) {
  double covered = 0;
  for (std::size_t pixel = 3; pixel < image.rgba.size(); pixel += 4) covered += image.rgba[pixel];
  return covered / (255.0 * image.width * image.height);
}

inline std::array<std::uint8_t, 4> seenAt(const Image& image, const Frame& frame,
                                          const Eigen::Vector3d& point) {
  const ScreenPoint place = frame.camera.project(point, frame.viewport);
  return image.at(static_cast<int>(place.x), static_cast<int>(place.y));
}

}  // namespace geargraph
