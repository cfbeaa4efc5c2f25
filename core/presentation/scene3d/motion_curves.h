#pragma once

#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "core/presentation/scene3d/scene_view.h"

namespace geargraph {

/// One quantity over time.
struct MotionCurve {
  std::string name;  ///< "joint 10", "link 3, x"
  Rgb colour;
  bool isComponent = false;               ///< a component of the last curve before it that is none
  std::vector<double> values;             ///< one per time
  std::optional<ElementId> element = {};  ///< the joint or link; none for a point
  std::string nameInFiles = {};           ///< in English, if `name` is translated
};

/// Quantities of one unit over the same times.
struct CurveSheet {
  std::string title;          ///< "Angular speed"
  std::string unit;           ///< "rad/s"
  std::vector<double> times;  ///< s
  std::vector<MotionCurve> curves;
};

/// The options of plots.
struct CurveChoice {
  std::set<ElementId>
      elements;  ///< turning joints, links, meshes (for their two wheels); none of them: all joints
  bool components = false;  ///< also the components x, y, z of vectors
  double span = 1;          ///< s, from time 0. @pre > 0
};

/// Angular speeds, along the view's trajectory if it has one: of joints the rate of the head relative to the
/// tail, constant for constant inputs; of links relative to the ground, signed if the link always turns about
/// one direction, else the magnitude. What slides has its speed in lengths a second, a link where it does not
/// turn. For every traced point its speed in the frame of its path. Sheets
/// without curves are left out. Velocities are computed from twists, not from differences of positions.
/// Cost: O(instances) for each of up to 2,881 times, fewer for large trains: some 200 ms for 1,000 links.
/// Empty if `stop` was requested meanwhile.
[[nodiscard]] std::vector<CurveSheet> motionCurves(const MechanismScene& stage, const SceneView& view,
                                                   const CurveChoice& choice,
                                                   const std::stop_token& stop = {});

/// A sheet as CSV with a header line: time in s, then each curve with its unit.
[[nodiscard]] std::string curvesCsv(const CurveSheet& sheet);

}  // namespace geargraph
