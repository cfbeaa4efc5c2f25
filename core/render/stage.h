#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/render/scene.h"

namespace geargraph {

/// A disc with a text that faces the viewer, beside what it names.
struct StageLabel {
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

/// A scene that moves: where every instance is for given angles of the inputs. Poses are a function of the
/// angles, never a sum of steps, so nothing drifts however long the train runs.
struct Stage {
  Scene scene;
  std::vector<StageLabel> labels;
  std::vector<StageHandle> handles;  ///< by instance; empty where nothing moves
  std::vector<double> inputSpeeds;   ///< rad/s, one an input
  double period = 0;  ///< seconds after which everything is where it was; 0: not known, or it never is
  /// Fills one pose an instance from one angle an input (rad; at 0 the reference pose). Empty: nothing moves.
  std::function<void(std::span<const double> angles, std::span<Pose> poses)> place;
};

using StagePtr = std::shared_ptr<const Stage>;

}  // namespace geargraph
