#pragma once

#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/machine/train/train_parts.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph::inline meshfile {

/// A mechanism with its solids. All of it must live as long as the call that takes it.
struct LinkSceneSource {
  const Mechanism& mechanism;
  const SpanningTree& tree;
  const ForwardKinematics& kinematics;
  std::span<const LinkPart> parts;
  std::function<Float3(int label)> colourOfLink;  ///< sRGB
};

/// Uniform rates of all joints, rad/s, by joint, and how long one period of them takes to play.
struct UniformMotion {
  std::vector<Rational> rates;
  std::optional<double> seconds;  ///< as long as it really takes where nothing is said
  /// Only these seconds of the motion as it really is, instead of one period: it ends where it is then.
  std::optional<double> stretch = {};
};

/// Most keys of rotation that an animation may have. One period of a train with awkward tooth counts is long.
constexpr std::size_t kMostKeys = 1'000'000;

/// The tree of links as nodes, each with its parts below it, in the reference pose. A link's frame lies on
/// the line of its joint and is parallel to the base frame, so that motion is rotation only. With a motion,
/// each joint that turns gets keys for one period of all of them (core/theory/pose/period.h), after which
/// every link is where it was.
///
/// Nodes and materials bear the names of the links, "link 3" where a link has none; parts bear theirs.
/// Identity: worldPosesAt() of a part is the pose of its link by ForwardKinematics times the part's own.
/// Fails with `limit` where a period, or the stretch, takes more than kMostKeys keys; the message says how
/// many turns a period has. Cost: O(links + parts + keys).
[[nodiscard]] std::variant<MeshScene, MeshFileError> linkScene(const LinkSceneSource& source,
                                                               const std::optional<UniformMotion>& motion);

}  // namespace geargraph::inline meshfile
