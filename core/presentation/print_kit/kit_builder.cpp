#include "core/presentation/print_kit/kit_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Arrangement scaledPlan(Arrangement plan, double factor) {
  for (AxisLayout& axis : plan.axes) {
    axis.point *= factor;
    axis.module *= factor;
    for (Bearing& bearing : axis.bearings) bearing.at *= factor;
  }
  for (ShaftSegment& shaft : plan.shafts) {
    for (double* const length : {&shaft.low, &shaft.high, &shaft.inner, &shaft.outer}) *length *= factor;
  }
  for (ArmPlan& arm : plan.arms) {
    arm.level *= factor;
    arm.at *= factor;
  }
  for (RingCarrierPlan& carrier : plan.ringCarriers) carrier.plate *= factor;
  return plan;
}

void scale(Boss& boss, double factor) {
  boss.centre *= factor;
  boss.radius *= factor;
  boss.hole *= factor;
}

/// In mm, with teeth thinner by the play. A pair's two teeth leave it free on either flank.
void scaleGear(TrainGear& gear, double factor, double play) {
  GearSpec& spec = gear.spec;
  for (double* const length : {&spec.module, &spec.faceWidth, &spec.bore, &spec.rim, &spec.hub})
    *length *= factor;
  spec.backlashAllowance = play / spec.module;
  spec.body = GearBody::plain;
  gear.pose.translation() *= factor;
}

/// Lengths of screws in shops.
constexpr std::array kScrewLengths = {6,  8,  10, 12, 14, 16, 18, 20, 22, 25, 28, 30,
                                      35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 90, 100};

}  // namespace

KitBuilder::KitBuilder(const Mechanism& aMechanism, const Placement& aPlacement, const GearTrain& aTrain,
                       const Arrangement& anArrangement, double factor, const KitOptions& someOptions)
    : mechanism(aMechanism), options(someOptions), train(aTrain), plan(scaledPlan(anArrangement, factor)) {
  std::vector<FlangePlan> found = carrierFlanges(anArrangement, aTrain, aPlacement);
  Arrangement reaching = anArrangement;
  reachFlanges(reaching, found);
  for (std::size_t s = 0; s < plan.shafts.size(); ++s) {
    plan.shafts[s].low = reaching.shafts[s].low * factor;
    plan.shafts[s].high = reaching.shafts[s].high * factor;
  }
  for (FlangePlan& flange : found) {
    flange.arms *= factor;
    flange.level *= factor;
    scale(flange.hub, factor);
    for (Boss& end : flange.ends) scale(end, factor);
    for (Boss& pillar : flange.pillars) scale(pillar, factor);
  }
  flanges = std::move(found);
  train.bodies.clear();
  for (TrainGear& gear : train.gears) scaleGear(gear, factor, options.play);
  for (TrainMesh& mesh : train.meshes) mesh.pitchPoint *= factor;
  // Tubes: the play of bores in place of the arrangement's.
  for (ShaftSegment& shaft : plan.shafts) {
    if (shaft.inner > 0)
      shaft.inner = shaft.inner - 0.12 * plan.axes[shaft.axisGroup].module + options.bore / 2;
  }
  shafts = plan.shafts;
}

ShaftSection KitBuilder::sectionOf(const ShaftSegment& shaft) const {
  const AxisLayout& axis = plan.axes[shaft.axisGroup];
  ShaftSection section;
  section.outer = shaft.outer;
  section.inner = shaft.inner;
  const double wall = shaft.outer - shaft.inner;
  section.flat = shaft.inner > 0 ? shaft.outer - 0.3 * wall : 0.78 * shaft.outer;
  section.towards = frameAlong(axis.point, axis.direction).linear().col(0);
  return section;
}

const ShaftSegment* KitBuilder::ownShaft(AxisGroupOrdinal axisGroup, LinkOrdinal link, double at) const {
  const ShaftSegment* const own = plan.shaftOf(axisGroup, link, at);
  return own != nullptr && own->low <= at && at <= own->high ? own : nullptr;
}

const ShaftSegment* KitBuilder::passing(AxisGroupOrdinal axisGroup, LinkOrdinal link, double at) const {
  const ShaftSegment* widest = nullptr;
  for (const std::size_t s : plan.shaftsOn[axisGroup]) {
    const ShaftSegment& shaft = plan.shafts[s];
    if (shaft.link == link || shaft.low > at || at > shaft.high) continue;
    if (widest == nullptr || shaft.outer > widest->outer) widest = &shaft;
  }
  return widest;
}

KitOutline KitBuilder::bore(LinkOrdinal link, AxisGroupOrdinal axisGroup, double at, double half,
                            const Isometry3d& pose) {
  const AxisLayout& axis = plan.axes[axisGroup];
  const Vector2d centre = (pose.inverse() * axis.at(at)).head<2>();
  if (const ShaftSegment* const own = ownShaft(axisGroup, link, at)) {
    const ShaftSection section = sectionOf(*own);
    const Vector3d towards = pose.linear().transpose() * section.towards;
    items.push_back({axisGroup, link, at - half, at + half, false});
    return shifted(flattedOutline(section.outer + kPressFit / 2, section.flat + kPressFit / 2,
                                  std::atan2(towards.y(), towards.x())),
                   centre);
  }
  const ShaftSegment* const other = passing(axisGroup, link, at);
  if (other == nullptr) return {};
  items.push_back({axisGroup, other->link, at - half, at + half, true});
  return circleOutline(centre, other->outer + options.bore / 2);
}

double KitBuilder::bossRadiusAt(LinkOrdinal link, AxisGroupOrdinal axisGroup, double at) const {
  const ShaftSegment* shaft = ownShaft(axisGroup, link, at);
  if (shaft == nullptr) shaft = passing(axisGroup, link, at);
  const double radius = shaft != nullptr ? shaft->outer + options.bore / 2 : 0;
  return radius + std::max(kLeastWall, plan.axes[axisGroup].module);
}

void KitBuilder::addScrew(double grip) {
  const double wanted = grip + kThread;
  double length = kScrewLengths.back();
  for (const int each : kScrewLengths) {
    if (each < wanted - 1) continue;
    length = each;
    break;
  }
  for (KitScrew& screw : screws) {
    if (screw.length == length) {
      ++screw.count;
      return;
    }
  }
  screws.push_back({3, length, 1});
}

KitPart& KitBuilder::add(KitPartKind kind, LinkOrdinal link, const std::string& what, Solid solid,
                         const Isometry3d& pose) {
  KitPart part;
  part.kind = kind;
  part.link = link;
  part.name = label(link) + '-' + what;
  part.solid = std::make_shared<const Solid>(std::move(solid));
  part.pose = pose;
  parts.push_back(std::move(part));
  return parts.back();
}

std::string KitBuilder::engrave(PlateShape& shape, LinkOrdinal link) const {
  std::vector<KitOutline> face{shape.outer.back().outline};
  for (const auto* const holes : {&shape.holes, &shape.wells}) {
    for (const std::vector<Rim>& hole : *holes) face.push_back(hole.back().outline);
  }
  const std::string number = label(link);
  for (const double height : {8.0, 6.5, 5.0, 4.0, 3.2}) {
    Vector2d centre;
    if (!roomFor(face, {digitsWidth(number, height), height}, 0.8, centre)) continue;
    for (KitOutline& digit : digitOutlines(number, height))
      shape.topPockets.push_back(shifted(std::move(digit), centre));
    return number;
  }
  return {};
}

std::vector<Rim> screwHole(const Vector2d& centre, double low, double high, bool isHeadAbove) {
  constexpr int kPoints = 32;
  const auto round = [&](double radius) { return reversed(circleOutline(centre, radius, kPoints)); };
  if (isHeadAbove)
    return {{low, round(kPassHole)}, {high - kHeadDepth, round(kPassHole)}, {high, round(kHeadHole)}};
  return {{low, round(kHeadHole)}, {low + kHeadDepth, round(kPassHole)}, {high, round(kPassHole)}};
}

std::vector<Rim> tapHole(const Vector2d& centre, double low, double high) {
  const KitOutline round = reversed(circleOutline(centre, kTapHole, 24));
  return {{low, round}, {high, round}};
}

Solid postSolid(double radius, double length, double chamfer) {
  PlateShape shape;
  shape.outer = chamferedWall(circleOutline({0, 0}, radius), 0, length, chamfer);
  shape.holes = {tapHole({0, 0}, 0, length)};
  return plateSolid(shape);
}

KitFailure layoutFailure(std::string message) {
  return {KitFailure::Kind::layout, std::move(message), {}};
}

}  // namespace geargraph
