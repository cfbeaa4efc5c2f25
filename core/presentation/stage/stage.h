#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/presentation/painting/scene.h"

namespace geargraph::inline stage {

enum class LabelKind : std::uint8_t { link, joint, axis };

/// A disc with a text that faces the viewer, beside what it names.
struct StageLabel {
  LabelKind kind = LabelKind::link;
  std::string text;
  Rgb colour;                      ///< of the disc's ring
  ElementId element;               ///< what a click on it selects
  std::size_t instance;            ///< it follows this one
  Eigen::Vector3d place{0, 0, 0};  ///< middle of what is named, in the instance's frame
  double radius = 0;               ///< mm from that middle that the disc must not cover
};

/// How a part can be taken by hand: it turns about a line, and so much for each input.
struct StageHandle {
  Eigen::Vector3d point{0, 0, 0};      ///< of the line, at the scene's own poses
  Eigen::Vector3d direction{0, 0, 1};  ///< length 1
  std::vector<double>
      gains;  ///< rad about +direction, against what carries it, a rad of each input; empty: fixed
};

enum class MarkKind : std::uint8_t { pitchCircle, axis };

/// A line of the geometry that no solid shows: a pitch circle, a turning axis.
struct StageMark {
  MarkKind kind = MarkKind::pitchCircle;
  std::size_t instance = 0;             ///< it moves with this one
  std::vector<Eigen::Vector3d> points;  ///< mm, in the instance's frame
  bool dashed = false;
};

/// Where two wheels roll on each other.
struct StageContact {
  Eigen::Vector3d point{0, 0, 0};      ///< pitch point at the scene's own poses
  std::optional<std::size_t> carrier;  ///< an instance of the link that it moves with; none: the ground's
  std::size_t tail = 0;                ///< the two wheels
  std::size_t head = 0;
};

/// How an instance moves at a moment: angular velocity, and the velocity of its point that is at the origin.
struct Twist3 {
  Eigen::Vector3d angular{0, 0, 0};  ///< rad/s
  Eigen::Vector3d linear{0, 0, 0};   ///< mm/s
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const {
    return linear + angular.cross(point);
  }
};

/// Something that is not shown, or simplified, and why, in a sentence.
struct StageNote {
  ElementId element;
  std::string text;
};

/// A turning joint: how fast its head turns against its tail is the same combination of the inputs' speeds in
/// every pose.
struct StageJoint {
  ElementId element;
  std::string text;           ///< its label
  Rgb colour;                 ///< of the link that it moves
  std::vector<double> gains;  ///< one an input
};

/// One end of the times that a motion may take.
struct StageLimit {
  double time = 0;   ///< s; infinite: there is none
  std::string text;  ///< the joint that is at its limit there: "joint 8 at 170°"
};

/// The times that joints with limits leave to a motion.
struct StageRange {
  StageLimit from{-std::numeric_limits<double>::infinity(), {}};
  StageLimit to{std::numeric_limits<double>::infinity(), {}};

  [[nodiscard]] bool isLimited() const { return std::isfinite(from.time) || std::isfinite(to.time); }
};

/// A scene that moves: where every instance is for given angles of the inputs. Poses are a function of the
/// angles, never a sum of steps, so nothing drifts however long the train runs.
struct Stage {
  Scene scene;
  std::vector<StageLabel> labels;
  std::vector<StageHandle> handles;  ///< by instance; empty where nothing moves
  std::vector<StageJoint> joints;    ///< empty where nothing moves
  std::vector<double> inputSpeeds;   ///< rad/s, one an input
  std::string unit = "mm";           ///< of all lengths
  std::vector<StageMark> marks;
  std::vector<StageContact> contacts;
  std::vector<StageNote> notes;
  double period = 0;  ///< seconds after which everything is where it was; 0: not known, or it never is
  /// Fills one pose an instance from one angle an input (rad; at 0 the reference pose). Empty: nothing moves.
  std::function<void(std::span<const double> angles, std::span<Pose> poses)> place;
  /// How long the inputs may run at their speeds when so much (rad) was added to their angles; empty: as long
  /// as they like.
  std::function<StageRange(std::span<const double> added)> range;
  /// A joint that is beyond its limits at these angles of the inputs, as in StageLimit; empty: none is.
  std::function<std::string(std::span<const double> angles)> beyondLimits;
  /// Fills the twist of every instance, at these angles and speeds of the inputs. Empty: nothing moves.
  std::function<void(std::span<const double> angles, std::span<const double> speeds,
                     std::span<Twist3> twists)>
      twists;
};

using StagePtr = std::shared_ptr<const Stage>;

}  // namespace geargraph::inline stage
