#pragma once

#include <set>
#include <stop_token>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/obstacle_grid.h"
#include "core/presentation/schematic/arm_grid.h"
#include "core/presentation/schematic/shaft_plan.h"

namespace geargraph {

/// A section drawing before its labels: marks without highlights, outlines for hit tests, and anchors for
/// labels.
struct Section {
  std::vector<Mark> marks;
  /// Marks that are shown only while their element is highlighted: where two gears mesh.
  std::vector<Mark> highlights;
  std::vector<Outline> outlines;
  std::vector<LinkLine> lines;  ///< of all links; -1: arrows, axes

  /// The possible places of a label, in order of preference.
  struct Anchors {
    ElementId element;
    std::vector<CanvasPoint> places;
  };
  ByLink<Anchors> links;    ///< of the part
  ByJoint<Anchors> joints;  //
  ByMesh<Anchors> meshes;   ///< those that are drawn
  ByCoupling<Anchors> couplings;
  std::vector<Anchors> axes;  ///< both ends of the dash-dotted lines
};

constexpr double kShaftWidth = 3.4;
constexpr double kLinkWidth = 2.2;
constexpr double kAxisWidth = 1;

/// Makes the section of a part. The result is meaningless if `stop` was requested meanwhile.
[[nodiscard]] Section sectionOf(const DrawnPart& part, const Placement& placement, const SheetLayout& layout,
                                const ShaftPlan& plan, const std::stop_token& stop = {});

[[nodiscard]] Extent extentOf(const Section& section);
/// Everything drawn as obstacles, for marks that are placed up to `beyond` px outside of the drawing.
[[nodiscard]] ObstacleGrid obstaclesOf(const Section& section, double beyond);

}  // namespace geargraph
