#pragma once

#include <set>
#include <stop_token>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/obstacle_grid.h"
#include "core/presentation/schematic/arm_grid.h"
#include "core/presentation/schematic/shaft_plan.h"

namespace geargraph::inline schematic {

/// The lines of a section drawing, before its labels: marks in their plain look, what can be hit, and where
/// labels belong.
struct Section {
  std::vector<Mark> marks;
  /// Marks that show only while their element stands out: where two gears mesh.
  std::vector<Mark> highlights;
  std::vector<Outline> outlines;
  std::vector<LinkLine> lines;  ///< of all links; -1: arrows, axes

  /// Where a label may stand: near one of these, the first if there is room.
  struct Anchors {
    ElementId element;
    std::vector<SheetPoint> places;
  };
  std::vector<Anchors> links;   ///< by link of the part
  std::vector<Anchors> joints;  //
  std::vector<Anchors> meshes;  ///< those that are drawn
  std::vector<Anchors> couplings;
  std::vector<Anchors> axes;  ///< both ends of the dash-dotted lines
};

constexpr double kShaftWidth = 3.4;
constexpr double kLinkWidth = 2.2;
constexpr double kAxisWidth = 1;

/// Of no use when `stop` was requested meanwhile.
[[nodiscard]] Section sectionOf(const DrawnPart& part, const Placement& placement, const SheetLayout& layout,
                                const ShaftPlan& plan, const std::stop_token& stop = {});

[[nodiscard]] Extent extentOf(const Section& section);
/// Everything that is drawn as obstacles, for what comes to stand up to `beyond` outside of it.
[[nodiscard]] ObstacleGrid obstaclesOf(const Section& section, double beyond);

}  // namespace geargraph::inline schematic
