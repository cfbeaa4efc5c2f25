#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/presentation/painting/camera.h"
#include "core/presentation/painting/look.h"
#include "core/presentation/painting/renderer.h"
#include "core/presentation/painting/scene.h"

namespace geargraph::inline painting {

/// Which parts look the same from one picture to the next, so that they need not be painted again: of a train
/// whose teeth are dragged most stay as they are. What is kept of them is a layer: the background and the
/// still parts with their depths, over which the others are painted.
class StillParts {
 public:
  /// All that a picture depends on beside its parts.
  struct View {
    int width = 1;
    int height = 1;
    double pixelRatio = 1;
    Camera camera;
    Look look;
    bool litByVertex = false;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
    friend bool operator==(const View&, const View&) = default;
  };
  struct Part {
    std::shared_ptr<const Solid> solid;
    DetailLevels levels;  ///< with the camera they tell which detail is painted
    Pose pose = Pose::Identity();
    Rgb colour;
    Highlight emphasis = Highlight::none;
    Showing showing = Showing::solid;
    [[nodiscard]] bool looksLike(const Part& other) const;
  };
  enum class Layer { none, kept, anew };

  /// What to do for the next picture. `none`: the camera has moved, all of it is painted and nothing kept.
  /// `anew`: the layer is begun with the background. Else it is there already. Cost: O(parts).
  Layer next(const View& view, std::vector<Part> parts);
  /// To be painted into the layer now: these, the others hidden. May be none.
  [[nodiscard]] const std::vector<Showing>& added() const { return m_added; }
  [[nodiscard]] bool hasAdded() const { return m_addedTriangles > 0; }
  /// To be painted over the layer.
  [[nodiscard]] const std::vector<Showing>& rest() const { return m_rest; }

 private:
  void sort(const std::vector<bool>& still);

  bool m_isKept = false;
  View m_view;
  std::vector<Part> m_parts;  ///< of the last picture
  std::vector<bool> m_kept;   ///< those in the layer
  std::vector<Showing> m_added, m_rest;
  std::size_t m_addedTriangles = 0;
};

}  // namespace geargraph::inline painting
