// Arms, pedestals and pillars of links.

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/solids/part_solids.h"
#include "core/presentation/print_kit/kit_builder.h"
#include "core/presentation/print_kit/kit_check.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The pedestal from an arm to a bearing across it: a plate with a tenon.
struct PedestalShape {
  double tenon = 0;  ///< width
  double thickness = 0;
};

PedestalShape pedestalOf(const KitBuilder& kit, const ArmPlan& arm) {
  return {std::clamp(3 * kit.plan.axes[arm.to].module, 5.0, 12.0), kit.plan.axes[arm.to].width()};
}

/// Half of the gap around a tenon.
constexpr double kTenonFit = kPressFit / 2;

std::optional<KitFailure> addPedestal(KitBuilder& kit, const ArmPlan& arm, const Vector3d& way) {
  const AxisLayout &from = kit.plan.axes[arm.from], &to = kit.plan.axes[arm.to];
  const PedestalShape measures = pedestalOf(kit, arm);
  const Vector3d centre = to.at(arm.at), n = to.direction;
  const double rise = (centre - from.at(arm.level)).dot(way);
  const double reach = rise - from.width() / 2 - kFlush;  // from the boss's centre down to the arm
  Isometry3d pose = Isometry3d::Identity();
  pose.linear().col(1) = way;
  pose.linear().col(2) = n;
  pose.linear().col(0) = way.cross(n);
  pose.translation() = centre - measures.thickness / 2 * n;
  const double boss = kit.bossRadiusAt(arm.link, arm.to, arm.at);
  const double shoulder = measures.tenon / 2 + 2;
  if (reach < boss)
    return layoutFailure(translated("A bearing of link %1 is too near to its arm for a printed pedestal.",
                                    {kit.label(arm.link)}));
  std::vector<Vector2d> points = circleOutline({0, 0}, boss);
  points.emplace_back(-shoulder, -reach);
  points.emplace_back(shoulder, -reach);
  KitOutline outline = hullOfPoints(std::move(points));
  const auto corner = std::find_if(outline.begin(), outline.end(), [&](const Vector2d& p) {
    return p.x() < 0 && std::abs(p.y() + reach) < 1e-9;
  });
  const double half = measures.tenon / 2, end = -reach - from.width() + 0.3;
  outline.insert(corner + 1, {Vector2d(-half, -reach), Vector2d(-half, end), Vector2d(half, end),
                              Vector2d(half, -reach)});
  PlateShape shape;
  shape.outer = chamferedWall(outline, 0, measures.thickness, kit.options.chamfer);
  const KitOutline hole = kit.bore(arm.link, arm.to, arm.at, measures.thickness / 2, pose);
  if (!hole.empty())
    shape.holes.push_back(chamferedWall(reversed(hole), 0, measures.thickness, kit.options.chamfer));
  const std::string number = kit.engrave(shape, arm.link);
  kit.add(KitPartKind::pedestal, arm.link, "pedestal", plateSolid(shape), pose).number = number;
  return std::nullopt;
}

/// A flat plate of a link around its own axis: an arm, or the second flange of a carrier.
struct ArmPlate {
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;
  double level = 0;
  std::vector<const ArmPlan*> arms;    ///< to bearings
  const FlangePlan* flange = nullptr;  ///< that it is part of
  bool isSecond = false;               ///< it is the second flange
};

std::optional<KitFailure> addPlate(KitBuilder& kit, const ArmPlate& plate) {
  const AxisLayout& axis = kit.plan.axes[plate.axisGroup];
  const double thickness = axis.width();
  const Isometry3d middle = frameAlong(axis.at(plate.level), axis.direction, Vector3d::UnitX());
  Isometry3d pose = middle;
  pose.translate(Vector3d(0, 0, -thickness / 2));
  std::vector<KitDisc> discs{{{0, 0}, kit.bossRadiusAt(plate.link, plate.axisGroup, plate.level)}};
  PlateShape shape;
  const auto pierce = [&](const KitOutline& hole) {
    if (!hole.empty())
      shape.holes.push_back(chamferedWall(reversed(hole), 0, thickness, kit.options.chamfer));
  };
  pierce(kit.bore(plate.link, plate.axisGroup, plate.level, thickness / 2, pose));
  for (const ArmPlan* const arm : plate.arms) {
    const AxisLayout& to = kit.plan.axes[arm->to];
    const Vector2d at = (middle.inverse() * to.at(arm->at)).head<2>();
    if (areParallel(to.direction, axis.direction)) {
      const double there =
          to.coordinate(axis.at(plate.level) + to.at(arm->at) - axis.at(axis.coordinate(to.at(arm->at))));
      discs.push_back({at, kit.bossRadiusAt(plate.link, arm->to, there)});
      pierce(kit.bore(plate.link, arm->to, there, thickness / 2, pose));
      continue;
    }
    if (std::abs(to.direction.dot(axis.direction)) > kParallelDirections)
      return layoutFailure(
          translated("An arm of link %1 is neither parallel nor at right angles to its bearing.",
                     {kit.label(plate.link)}));
    const double rise = (to.at(arm->at) - axis.at(plate.level)).dot(axis.direction);
    const Vector3d way = rise < 0 ? Vector3d(-axis.direction) : axis.direction;
    const PedestalShape measures = pedestalOf(kit, *arm);
    const Vector3d across = middle.linear().transpose() * way.cross(to.direction);
    discs.push_back({at, std::hypot(measures.tenon / 2, measures.thickness / 2) + kLeastWall});
    pierce(
        boxOutline(at, across.head<2>(), measures.tenon + 2 * kTenonFit, measures.thickness + 2 * kTenonFit));
    if (auto failure = addPedestal(kit, *arm, way)) return failure;
  }
  if (plate.isSecond) {
    const std::vector<Boss>& ends = plate.flange->ends;
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const LinkOrdinal child = plate.flange->children[e];
      for (const ArmPlan& arm : kit.plan.arms) {
        if (arm.link != plate.link || arm.child != child) continue;
        const AxisLayout& to = kit.plan.axes[arm.to];
        const double there = to.coordinate(middle * Vector3d(ends[e].centre.x(), ends[e].centre.y(), 0));
        discs.push_back({ends[e].centre, kit.bossRadiusAt(plate.link, arm.to, there)});
        pierce(kit.bore(plate.link, arm.to, there, thickness / 2, pose));
        break;
      }
    }
  }
  if (plate.flange != nullptr) {
    // Heads of screws are on the side away from the other half.
    const double other = plate.isSecond ? plate.flange->arms : plate.flange->level;
    for (const Boss& pillar : plate.flange->pillars) {
      discs.push_back({pillar.centre, kHeadHole + 1.2});
      shape.holes.push_back(screwHole(pillar.centre, 0, thickness, other < plate.level));
      kit.addScrew(thickness);
    }
  }
  shape.outer = chamferedWall(hullOutline(discs), 0, thickness, kit.options.chamfer);
  const std::string number = kit.engrave(shape, plate.link);
  kit.add(KitPartKind::arm, plate.link, plate.isSecond ? "flange" : "arm", plateSolid(shape), pose).number =
      number;
  return std::nullopt;
}

void addPillars(KitBuilder& kit, const FlangePlan& flange) {
  const AxisLayout& axis = kit.plan.axes[flange.axisGroup];
  const double length = std::abs(flange.level - flange.arms) - axis.width() - 2 * kFlush;
  const double low = std::min(flange.level, flange.arms) + axis.width() / 2 + kFlush;
  for (const Boss& pillar : flange.pillars) {
    const double radius = std::max(pillar.radius, 3.2);
    Isometry3d pose = frameAlong(axis.at(low), axis.direction, Vector3d::UnitX());
    pose.translate(Vector3d(pillar.centre.x(), pillar.centre.y(), 0));
    KitPart& part = kit.add(KitPartKind::post, flange.link, "pillar",
                            postSolid(radius, length, kit.options.chamfer), pose);
    part.diameter = 2 * radius;
    part.length = length;
  }
}

}  // namespace

std::optional<KitFailure> addArms(KitBuilder& kit) {
  std::map<std::tuple<int, int, long long>, ArmPlate> plates;
  for (const ArmPlan& arm : kit.plan.arms) {
    if (arm.link == 0) continue;  // the ground has its base
    const double step = 1e-6 * kit.plan.axes[arm.from].module;
    ArmPlate& plate = plates[{arm.link, arm.from, std::llround(arm.level / step)}];
    plate.link = arm.link;
    plate.axisGroup = arm.from;
    plate.level = arm.level;
    plate.arms.push_back(&arm);
  }
  for (const FlangePlan& flange : kit.flanges) {
    for (auto& [place, plate] : plates) {
      const bool isHere = plate.link == flange.link && plate.axisGroup == flange.axisGroup &&
                          std::abs(plate.level - flange.arms) < 1e-6 * kit.plan.axes[plate.axisGroup].module;
      if (isHere) plate.flange = &flange;
    }
  }
  for (const auto& [place, plate] : plates) {
    if (kit.stop.stop_requested()) return std::nullopt;
    if (auto failure = addPlate(kit, plate)) return failure;
  }
  for (const FlangePlan& flange : kit.flanges) {
    if (auto failure = addPlate(kit, {flange.link, flange.axisGroup, flange.level, {}, &flange, true}))
      return failure;
    addPillars(kit, flange);
  }
  return std::nullopt;
}

}  // namespace geargraph
