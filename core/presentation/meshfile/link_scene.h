#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/machine/train/train_parts.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// A mechanism with its solids; valid during the call only.
struct LinkSceneSource {
  const Mechanism& mechanism;
  const SpanningTree& tree;
  const ForwardKinematics& kinematics;
  std::span<const LinkPart> parts;
  std::function<Float3(int number)> colourOfLink;  ///< sRGB, by Mechanism::colorNumber()
};

/// Uniform rates of all joints, rad/s, by joint, and how long one period of them takes to play.
struct UniformMotion {
  std::vector<Rational> rates;
  std::optional<double> seconds;  ///< none: in real time
  /// Instead of one period, this many seconds of the motion in real time.
  std::optional<double> stretch = {};
  /// Instead of one period: there and back between these times of the motion, s, below and above 0, with
  /// which the limits of joints leave it. Exactly one may be 0.
  std::optional<std::pair<double, double>> range = {};
};

/// The most rotation keys of an animation. Tooth counts without common factors have long periods.
constexpr std::size_t kMaxKeys = 1'000'000;

/// The tree of links as nodes, each with its parts below it, in the reference pose. A link's frame has its
/// origin on the line of its joint and is parallel to the base frame, so that motion is rotation only. With a
/// motion, each joint that turns gets keys for one period of all of them (core/theory/pose/period.h), after
/// which every link is where it was.
///
/// Nodes and materials have the names of the links, "link 3" for a link without a name; parts have their own.
/// Identity: worldPosesAt() of a part is the pose of its link by ForwardKinematics times the part's own.
/// Fails with `limit` where a period, the stretch or the range takes more than kMaxKeys keys; the message
/// says how many turns a period has. Cost: O(links + parts + keys).
[[nodiscard]] std::variant<MeshScene, MeshFileError> linkScene(const LinkSceneSource& source,
                                                               const std::optional<UniformMotion>& motion);

}  // namespace geargraph
