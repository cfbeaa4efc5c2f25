#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/render_style.h"
#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene/scene.h"

namespace geargraph {

/// Finds the parts that look the same from one picture to the next, so that they need not be painted again:
/// most parts of a train whose teeth are being dragged. They are cached in a layer: the background and the
/// unchanged parts with their depths, over which the others are painted.
class StaticParts {
 public:
  /// Everything that a picture depends on except its parts.
  struct View {
    int width = 1;
    int height = 1;
    double pixelRatio = 1;
    Camera camera;
    RenderStyle style;
    bool litByVertex = false;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
    friend bool operator==(const View&, const View&) = default;
  };
  struct Part {
    std::shared_ptr<const Solid> solid;
    DetailLevels levels;  ///< with the camera they determine the level of detail
    Pose pose = Pose::Identity();
    Rgb colour;
    Highlight emphasis = Highlight::none;
    Visibility visibility = Visibility::solid;
    [[nodiscard]] bool looksLike(const Part& other) const;
  };
  enum class Layer { none, cached, anew };

  /// Decides how to paint the next picture. `none`: the camera has moved, everything is painted and nothing
  /// kept. `anew`: the layer is begun with the background. `cached`: the layer exists already. Cost:
  /// O(parts).
  Layer next(const View& view, std::vector<Part> parts);
  /// The parts to be painted into the layer now, by instance, the others hidden. May be none.
  [[nodiscard]] const std::vector<Visibility>& added() const { return m_added; }
  [[nodiscard]] bool hasAdded() const { return m_addedTriangles > 0; }
  /// The parts to be painted over the layer, the others hidden.
  [[nodiscard]] const std::vector<Visibility>& rest() const { return m_rest; }

 private:
  void sort(const std::vector<bool>& still);

  bool m_isCached = false;
  View m_view;
  std::vector<Part> m_parts;   ///< of the last picture
  std::vector<bool> m_cached;  ///< those in the layer
  std::vector<Visibility> m_added, m_rest;
  std::size_t m_addedTriangles = 0;
};

}  // namespace geargraph
