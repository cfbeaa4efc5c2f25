#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/machine/solids/deferred_solid.h"
#include "core/machine/solids/solid.h"

namespace geargraph {

/// Red, green, blue in 0..1, sRGB.
struct Rgb {
  float red = 0;
  float green = 0;
  float blue = 0;
  [[nodiscard]] static constexpr Rgb fromHex(unsigned rgb) {
    return {static_cast<float>((rgb >> 16) & 255) / 255, static_cast<float>((rgb >> 8) & 255) / 255,
            static_cast<float>(rgb & 255) / 255};
  }
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// The pose of a solid: from its own frame to the world, mm.
using Pose = Eigen::Isometry3d;

/// An instance of a solid; a click on it selects `element`.
struct Instance {
  std::size_t solid = 0;  ///< position in Scene::solids
  Pose pose = Pose::Identity();
  Rgb colour;
  ElementId element;
  std::vector<ElementId> also;  ///< highlighted with these too: a gear with its mesh, a shaft with its joint
  bool castsShadow = true;
  bool isOpen =
      false;  ///< its solid may not be closed: faces are visible from both sides, and it has no cut face
};

/// The levels of detail of a solid: finer versions, for when it is large on the screen.
struct DetailLevels {
  struct LodLevel {
    double error = 0;
    std::shared_ptr<const DeferredSolid> solid;  ///< made on demand, when zoomed in
    friend bool operator==(const LodLevel&, const LodLevel&) = default;
  };

  double unit = 0;              ///< mm: a gear's module
  double error = 0;             ///< chordal error of the scene's own solid, in `unit`
  std::vector<LodLevel> finer;  ///< coarsest first

  /// The coarsest level with a chordal error of at most `most` units, else the finest. Cost: that of making
  /// it, once.
  [[nodiscard]] const std::shared_ptr<const Solid>& within(double most,
                                                           const std::shared_ptr<const Solid>& own) const;
  /// The level to paint if a unit has this many pixels: with a chordal error of at most a third of a pixel.
  [[nodiscard]] const std::shared_ptr<const Solid>& chosen(const std::shared_ptr<const Solid>& own,
                                                           double pixels) const;
  friend bool operator==(const DetailLevels&, const DetailLevels&) = default;
};

/// By solid: its extreme vertices in many directions, in its own frame.
using SolidOutlines = std::vector<std::vector<Eigen::Vector3d>>;

/// A scene. Solids are immutable and shared: equal gears are stored once, and a renderer uploads each solid
/// once.
struct Scene {
  std::vector<std::shared_ptr<const Solid>> solids;
  std::vector<Instance> instances;
  std::vector<DetailLevels> levels = {};  ///< by solid, as far as there are any
  /// Feature edges that were precomputed, on another thread; the renderer computes the others.
  std::unordered_map<const Solid*, std::shared_ptr<const std::vector<std::uint32_t>>> edges = {};
  /// Precomputed bounding boxes of the solids in their own frames: by solid, as far as there are any.
  std::vector<Eigen::AlignedBox3d> boxes = {};
  /// The precomputed solidOutlines(); null: not yet.
  std::shared_ptr<const SolidOutlines> outlines = {};

  /// The coarsest level of a solid with a chordal error of at most `most` units of its levels.
  [[nodiscard]] const std::shared_ptr<const Solid>& solidWithin(double most, std::size_t solid) const {
    const auto& own = solids[solid];
    return solid < levels.size() ? levels[solid].within(most, own) : own;
  }
  [[nodiscard]] Eigen::AlignedBox3d boxOf(std::size_t solid) const {
    return solid < boxes.size() ? boxes[solid] : geargraph::boundsOf(*solids[solid]);
  }
};

struct Bounds {
  Eigen::AlignedBox3d box;  ///< empty if the scene is
  [[nodiscard]] Eigen::Vector3d centre() const {
    return box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.center());
  }
  [[nodiscard]] double radius() const { return box.isEmpty() ? 1 : 0.5 * box.diagonal().norm(); }
};

/// The bounding box of all instances in their poses, from the corners of their solids' boxes.
[[nodiscard]] Bounds boundsOf(const Scene& scene);

/// The eight corners of every instance's box, for Camera::fitted.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersOf(const Scene& scene);

/// The number of vertices per solid among which outlines are chosen: 2^18 in total, 64 to 4096 per solid.
[[nodiscard]] std::size_t outlineSamples(const Scene& scene);
/// The outline of one solid, chosen among about `samples` of its vertices.
[[nodiscard]] std::vector<Eigen::Vector3d> outlineOf(const Solid& solid, std::size_t samples);

/// The outlines of all solids of the scene, precomputed or computed now. Incomplete if `stop` was requested.
/// Cost: O(outlineSamples() * solids) if they have to be computed.
[[nodiscard]] std::shared_ptr<const SolidOutlines> solidOutlines(const Scene& scene,
                                                                 const std::stop_token& stop = {});

/// The outlines of all instances in the scene's own poses, to fit a picture: much tighter than the corners of
/// the boxes of round wheels. Cost: that of solidOutlines(), and O(instances).
[[nodiscard]] std::vector<Eigen::Vector3d> outlineOf(const Scene& scene);

}  // namespace geargraph
