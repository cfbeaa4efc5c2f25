#include "core/presentation/schematic/sheet_rims.h"

#include <algorithm>
#include <cmath>

#include "core/presentation/schematic/drawn_part.h"
#include "core/presentation/schematic/sheet_layout.h"

namespace geargraph {
namespace {

double distanceTo(const SheetRim& rim, CanvasPoint place) {
  const CanvasPoint way = rim.to - rim.from;
  const double square = dot(way, way);
  const double share = square > 0 ? std::clamp(dot(place - rim.from, way) / square, 0.0, 1.0) : 0;
  return distance(place, rim.from + share * way);
}

}  // namespace

std::vector<SheetRim> sheetRims(const DrawnPart& part, const SheetLayout& layout) {
  std::vector<SheetRim> rims;
  for (const SheetWheel& wheel : layout.wheels) {
    if (wheel.radius <= 0 || wheel.meshes.empty()) continue;
    const SheetAxis& axis = layout.axes[wheel.axis];
    SheetRim rim;
    rim.link = part.mechanism.links[wheel.link].id;
    for (const int mesh : wheel.meshes) rim.meshes.push_back(part.mechanism.gearMeshes[mesh].id);
    rim.height = wheel.radius;
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && axis.half) continue;
      rim.from = axis.at(wheel.barFrom.x, side * wheel.barFrom.y);
      rim.to = axis.at(wheel.barTo.x, side * wheel.barTo.y);
      rim.out = side * axis.up;
      rims.push_back(rim);
    }
  }
  return rims;
}

const SheetRim* rimNear(const std::vector<SheetRim>& rims, const std::vector<LinkId>& links,
                        CanvasPoint place, double reach) {
  const SheetRim* nearest = nullptr;
  for (const SheetRim& rim : rims) {
    if (std::find(links.begin(), links.end(), rim.link) == links.end()) continue;
    const double away = distanceTo(rim, place);
    if (away > reach) continue;
    reach = away;
    nearest = &rim;
  }
  return nearest;
}

std::optional<DraggedTeeth> teethDragged(const Mechanism& mechanism, const SheetRim& rim, CanvasPoint from,
                                         CanvasPoint to) {
  const GearMesh* const mesh = mechanism.find(rim.meshes.front());
  if (mesh == nullptr || (mesh->tail != rim.link && mesh->head != rim.link)) return std::nullopt;
  const bool ofTail = mesh->tail == rim.link;
  const int before = ofTail ? mesh->tailTeeth : mesh->headTeeth;
  const double wanted = before * (1 + dot(to - from, rim.out) / rim.height);
  const int teeth = static_cast<int>(
      std::lround(std::clamp(wanted, static_cast<double>(kMinTeeth), static_cast<double>(kMaxTeeth))));
  return DraggedTeeth{mesh->id, ofTail ? teeth : mesh->tailTeeth, ofTail ? mesh->headTeeth : teeth, teeth};
}

}  // namespace geargraph
