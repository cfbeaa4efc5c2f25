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

namespace geargraph::inline painting {

/// Red, green, blue in 0..1 as a screen takes them (sRGB).
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

/// Where a solid is: its own frame to the world, mm.
using Pose = Eigen::Isometry3d;

/// One solid put somewhere: what it stands for is what a click on it selects.
struct Instance {
  std::size_t solid = 0;  ///< position in Scene::solids
  Pose pose = Pose::Identity();
  Rgb colour;
  ElementId element;
  std::vector<ElementId> also;  ///< lights up with these too: a gear with its mesh, a shaft with its joint
  bool castsShadow = true;
  bool isOpen =
      false;  ///< its solid may not be closed: its faces are seen from both sides, and it has no cut face
};

/// The finer ones of a solid whose own form is for when it is small on the screen.
struct DetailLevels {
  struct Finer {
    double error = 0;
    std::shared_ptr<const DeferredSolid> solid;  ///< made when somebody looks so close
    friend bool operator==(const Finer&, const Finer&) = default;
  };

  double unit = 0;   ///< mm: a gear's module
  double error = 0;  ///< of the scene's own solid: how far its chords are from the exact form, in units
  std::vector<Finer> finer;  ///< coarsest first

  /// The coarsest whose chords stay within `most` units, else the finest. Cost: that of making it, once.
  [[nodiscard]] const std::shared_ptr<const Solid>& within(double most,
                                                           const std::shared_ptr<const Solid>& own) const;
  /// Which to paint where a unit has this many pixels: its chords stay within a third of one.
  [[nodiscard]] const std::shared_ptr<const Solid>& chosen(const std::shared_ptr<const Solid>& own,
                                                           double pixels) const;
  friend bool operator==(const DetailLevels&, const DetailLevels&) = default;
};

/// By solid: those of its vertices that reach farthest in many directions, in its own frame.
using SolidOutlines = std::vector<std::vector<Eigen::Vector3d>>;

/// What is to be seen. Solids are immutable and shared: equal gears are stored once, and a renderer that has
/// seen a solid does not take it up again.
struct Scene {
  std::vector<std::shared_ptr<const Solid>> solids;
  std::vector<Instance> instances;
  std::vector<DetailLevels> levels = {};  ///< by solid, as far as there are any
  /// Feature edges that were found ahead, on another thread; the renderer finds the others.
  std::unordered_map<const Solid*, std::shared_ptr<const std::vector<std::uint32_t>>> edges = {};
  /// Boxes about the solids in their own frames, found ahead too: by solid, as far as there are any.
  std::vector<Eigen::AlignedBox3d> boxes = {};
  /// Their solidOutlines(), found ahead as well; null: not yet.
  std::shared_ptr<const SolidOutlines> outlines = {};

  /// The solid in the coarsest detail whose chords stay within `most` units of its levels.
  [[nodiscard]] const std::shared_ptr<const Solid>& solidWithin(double most, std::size_t solid) const {
    const auto& own = solids[solid];
    return solid < levels.size() ? levels[solid].within(most, own) : own;
  }
  [[nodiscard]] Eigen::AlignedBox3d boxOf(std::size_t solid) const {
    return solid < boxes.size() ? boxes[solid] : geargraph::boundsOf(*solids[solid]);
  }
};

struct Bounds {
  Eigen::AlignedBox3d box;  ///< empty where the scene is
  [[nodiscard]] Eigen::Vector3d centre() const {
    return box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.center());
  }
  [[nodiscard]] double radius() const { return box.isEmpty() ? 1 : 0.5 * box.diagonal().norm(); }
};

/// The box about all instances in their poses, from the corners of their solids' boxes.
[[nodiscard]] Bounds boundsOf(const Scene& scene);

/// The eight corners of every instance's box, for Camera::fitted.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersOf(const Scene& scene);

/// How many vertices of each solid of such a scene its outline is chosen among: 2^18 of all, 64 to 4096 each.
[[nodiscard]] std::size_t outlineSamples(const Scene& scene);
/// The outline of one solid, chosen among about `samples` of its vertices.
[[nodiscard]] std::vector<Eigen::Vector3d> outlineOf(const Solid& solid, std::size_t samples);

/// The outlines of all solids of the scene: those found ahead, else they are found now. Incomplete when
/// `stop` was requested. Cost: O(outlineSamples() * solids) where they have to be found.
[[nodiscard]] std::shared_ptr<const SolidOutlines> solidOutlines(const Scene& scene,
                                                                 const std::stop_token& stop = {});

/// The outlines of all instances in the scene's own poses: what a picture has to hold, much tighter than the
/// corners of boxes about round wheels. Cost: that of solidOutlines(), and O(instances).
[[nodiscard]] std::vector<Eigen::Vector3d> outlineOf(const Scene& scene);

}  // namespace geargraph::inline painting
