#include "core/presentation/schematic/sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "core/mechanism/placement/tolerance.h"
#include "core/presentation/schematic/wheel_symbol.h"

namespace geargraph {
namespace {

bool isParallel(const Vector3& a, const Vector3& b) {
  return length(cross(a, b)) < kSameLine;
}

/// Classes, and axes of the document that no joint turns about.
void collectAxes(const DrawnPart& part, const Placement& placement, SheetLayout& layout) {
  std::vector<bool> used(part.mechanism.axes.size());
  for (const int axis : placement.tree->axisOf) used[static_cast<std::size_t>(axis)] = true;
  const auto add = [&](int axis, int rootLink) {
    const AxisLine& line = placement.axes[axis];
    SheetAxis on;
    on.axis = axis;
    on.rootLink = rootLink;
    on.base = line.point;
    on.direction = line.direction;
    layout.axes.push_back(on);
  };
  for (const AxisGroups::Class& c : placement.classes->classes) add(c.axis, c.rootLink);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) add(static_cast<int>(i), -1);
  }
}

}  // namespace

bool isInFrame(const SheetWheel& wheel) {
  return wheel.link == 0 && wheelSymbol(wheel.kind).frame != FrameSymbol::hub;
}

double SheetLayout::stretched(double coordinate) const {
  if (planes.empty()) return coordinate * scale;
  const auto above = std::upper_bound(planes.begin(), planes.end(), coordinate);
  const auto index = static_cast<double>(above - planes.begin());
  if (above == planes.begin()) return (coordinate - planes.front()) * scale;
  if (above == planes.end()) return (index - 1) * kPlaneDistance + (coordinate - planes.back()) * scale;
  const double low = *(above - 1);
  return (index - 1 + (coordinate - low) / (*above - low)) * kPlaneDistance;
}

SheetLayout sheetLayout(const DrawnPart& part, const Placement& placement, const TrainWheels& train,
                        const std::stop_token& stop) {
  SheetLayout layout;
  collectAxes(part, placement, layout);
  for (const SheetAxis& axis : layout.axes) {
    layout.parallel = layout.parallel && isParallel(axis.direction, layout.axes.front().direction);
  }
  for (const TrainWheel& wheel : train.wheels) {
    SheetWheel drawn;
    drawn.link = wheel.link;
    drawn.axis = wheel.axisGroup;
    drawn.kind = wheel.spec.kind;
    drawn.meshes = wheel.meshes;
    drawn.hand = wheel.spec.helixAngle == 0 ? 0 : signOf(handOf(wheel.spec.helixAngle));
    drawn.herringbone = wheel.spec.herringbone;
    layout.wheels.push_back(std::move(drawn));
  }
  for (const TrainPair& pair : train.pairs) layout.pairs.push_back({pair.mesh, pair.tail, pair.head, false});
  if (layout.parallel) {
    layParallel(layout, train, placement, stop);
  } else {
    layUnfolded(layout, train, placement);
  }
  return layout;
}

CanvasFrame sheetFrame(const DrawnPart& part, const SheetLayout& layout) {
  CanvasFrame frame;
  const SheetAxis& root = layout.axes[layout.root];
  frame.right = layout.right;
  frame.up = layout.up;
  frame.base = root.base;
  frame.origin = root.origin;
  frame.scale = layout.scale;
  for (const SheetAxis& axis : layout.axes) {
    frame.axes.push_back({part.mechanism.axes[axis.axis].id, axis.origin, axis.along});
  }
  if (!layout.parallel) return frame;
  for (const SheetWheel& wheel : layout.wheels) frame.stops.emplace_back(wheel.at, wheel.space);
  std::sort(frame.stops.begin(), frame.stops.end());
  const auto same = [](const auto& a, const auto& b) {
    return b.first - a.first < 1 || b.second <= a.second;
  };
  frame.stops.erase(std::unique(frame.stops.begin(), frame.stops.end(), same), frame.stops.end());
  return frame;
}

}  // namespace geargraph
