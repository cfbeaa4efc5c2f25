#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/presentation/scene/scene.h"

namespace geargraph {

enum class LabelKind : std::uint8_t { link, joint, axis };

/// A disc with a text that faces the viewer, at its element.
struct SceneLabel {
  LabelKind kind = LabelKind::link;
  std::string text;
  Rgb colour;                      ///< of the disc's ring
  ElementId element;               ///< what a click on it selects
  std::size_t instance;            ///< that it follows
  Eigen::Vector3d place{0, 0, 0};  ///< middle of its element, in the instance's frame
  double radius = 0;               ///< mm from that middle that the disc must not cover
  int colourNumber = 0;            ///< of a link: which of the links' colours it has
};

/// How a part can be dragged: it turns about a line, or slides along it, with a gain for each input.
struct SceneHandle {
  Eigen::Vector3d point{0, 0, 0};      ///< of the line, at the scene's own poses
  Eigen::Vector3d direction{0, 0, 1};  ///< length 1
  std::vector<double>
      gains;  ///< rad about +direction, relative to its carrier, per rad of each input; empty: fixed
  bool slides = false;  ///< the gains are lengths along +direction
};

enum class MarkKind : std::uint8_t { pitchCircle, axis };

/// A line of the geometry that no solid shows: a pitch circle, a turning axis.
struct SceneMark {
  MarkKind kind = MarkKind::pitchCircle;
  std::size_t instance = 0;             ///< that it moves with
  std::vector<Eigen::Vector3d> points;  ///< mm, in the instance's frame
  bool dashed = false;
};

/// Where two wheels roll on each other.
struct SceneContact {
  Eigen::Vector3d point{0, 0, 0};      ///< pitch point at the scene's own poses
  std::optional<std::size_t> carrier;  ///< an instance of the link that it moves with; none: the ground's
  std::size_t tail = 0;                ///< the two wheels
  std::size_t head = 0;
};

/// The instantaneous motion of an instance: its angular velocity, and the velocity of its point at the
/// origin.
struct Twist3 {
  Eigen::Vector3d angular{0, 0, 0};  ///< rad/s
  Eigen::Vector3d linear{0, 0, 0};   ///< mm/s
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const {
    return linear + angular.cross(point);
  }
};

/// A note on something that is not shown or is simplified, as a sentence.
struct SceneNote {
  ElementId element;
  std::string text;
  bool isMissingFile = false;  ///< a 3D file that the document names could not be read
};

/// A joint: its rate (head relative to tail) is the same linear combination of the inputs' speeds in
/// every pose.
struct SceneJoint {
  ElementId element;
  std::string text;           ///< its label
  Rgb colour;                 ///< of the link that it moves
  std::vector<double> gains;  ///< one per input
  bool slides = false;        ///< its rate is in lengths a second
};

/// One end of the time range of a motion.
struct SceneLimit {
  double time = 0;   ///< s; infinite: there is none
  std::string text;  ///< the joint that reaches its limit there: "joint 8 at 170°", "joint 6 at 200 mm"
};

/// The time range of a motion within the limits of joints.
struct SceneRange {
  SceneLimit from{-std::numeric_limits<double>::infinity(), {}};
  SceneLimit to{std::numeric_limits<double>::infinity(), {}};

  [[nodiscard]] bool isLimited() const { return std::isfinite(from.time) || std::isfinite(to.time); }
};

/// A scene that moves: the pose of every instance is a function of the inputs' angles, never a sum of steps,
/// so nothing drifts however long the train runs.
struct MechanismScene {
  Scene scene;
  std::vector<SceneLabel> labels;
  std::vector<SceneHandle> handles;  ///< by instance; empty where nothing moves
  std::vector<SceneJoint> joints;    ///< empty if nothing moves
  std::vector<double> inputSpeeds;   ///< rad/s, one per input
  std::string unit = "mm";           ///< of all lengths
  std::vector<SceneMark> marks;
  std::vector<SceneContact> contacts;
  std::vector<SceneNote> notes;
  double period = 0;  ///< s; 0: not known, or the motion is not periodic
  /// Computes one pose per instance from one angle per input (rad; 0 is the reference pose). Empty: nothing
  /// moves.
  std::function<void(std::span<const double> angles, std::span<Pose> poses)> place;
  /// The time range within which the inputs may run at their speeds from angles offset by `added` (rad);
  /// empty: no limits.
  std::function<SceneRange(std::span<const double> added)> range;
  /// A joint beyond its limits at these angles of the inputs, as in SceneLimit::text; an empty text: none is.
  std::function<std::string(std::span<const double> angles)> beyondLimits;
  /// Computes the twist of every instance at these angles and speeds of the inputs. Empty: nothing moves.
  std::function<void(std::span<const double> angles, std::span<const double> speeds,
                     std::span<Twist3> twists)>
      twists;
};

using MechanismScenePtr = std::shared_ptr<const MechanismScene>;

}  // namespace geargraph
