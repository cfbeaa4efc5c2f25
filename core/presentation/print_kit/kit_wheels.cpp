// Wheels and shafts of links.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/solids/toothless_gear.h"
#include "core/machine/teeth/phase.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/print_kit/kit_builder.h"
#include "core/presentation/print_kit/kit_check.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kSmallestCone = 15 * pi / 180;  // flatter teeth would hang in the air
constexpr double kLargestCone = 100 * pi / 180;

/// Angle of the pitch point about the gear in its own frame, at mid face, in teeth.
double pitchPlace(const TrainGear& gear, const Vector3d& pitchPoint) {
  const Vector3d local = gear.pose.inverse() * pitchPoint;
  double angle = std::atan2(local.y(), local.x());
  if (!isConical(gear.spec)) angle -= twistOf(gear.spec, local.z());
  return angle / (2 * pi) * gear.spec.teeth;
}

int wrapped(long long tooth, int teeth) {
  return static_cast<int>((tooth % teeth + teeth) % teeth);
}

const RingCarrierPlan* carrierOf(const KitBuilder& kit, GearOrdinal gear) {
  for (const RingCarrierPlan& carrier : kit.plan.ringCarriers) {
    if (carrier.gear == gear) return &carrier;
  }
  return nullptr;
}

}  // namespace

std::optional<KitFailure> checkTrain(const KitBuilder& kit) {
  const auto failure = [](std::string message) { return std::optional(layoutFailure(std::move(message))); };
  if (kit.train.gears.empty()) return failure(translated("There are no wheels to print."));
  if (!kit.train.strands.empty()) return failure(translated("Belts are not printed."));
  if (kit.plan.isSimple) return failure(translated("The train is too large for a kit."));
  if (!kit.plan.blocked.empty())
    return failure(translated("Links overlap in 3D, so their printed parts would too."));
  if (!kit.plan.revolvedBodies.empty() || !kit.plan.cages.empty()) {
    return failure(translated(
        "Several rings on one axis are joined by drums around each other, which the kit cannot divide."));
  }
  if (!kit.plan.pins.empty() || !kit.plan.crossShaftBosses.empty())
    return failure(
        translated("A link turns on a pin across the axis of another, for which the kit has no part."));
  for (const TrainGear& gear : kit.train.gears) {
    if (!isToothed(gear.spec)) return failure(translated("The wheel %1 has no teeth.", {gear.name}));
    if (isFaceGear(gear.spec) || (isConical(gear.spec) && gear.spec.helixAngle != 0))
      return failure(translated("Spiral teeth and face gears are not printed: gear %1.", {gear.name}));
    if (isConical(gear.spec) && (gear.spec.coneAngle > kLargestCone || gear.spec.coneAngle < kSmallestCone)) {
      return failure(translated(
          "The bevel %1 has so flat or so steep a cone that it does not print on a face.", {gear.name}));
    }
    for (const AxisGroupOrdinal c : kit.plan.axes.ordinals()) {
      for (const Bearing& bearing : kit.plan.axes[c].bearings) {
        if (!bearing.isBoss())
          return failure(translated("Link %1 turns on a pin of link %2, for which the kit has no part.",
                                    {kit.label(bearing.child), kit.label(bearing.parent)}));
      }
    }
  }
  return std::nullopt;
}

void pairMarks(KitBuilder& kit) {
  std::map<int, std::vector<int>> used;  // counts, by gear
  for (const TrainMesh& mesh : kit.train.meshes) {
    const TrainGear &tail = kit.train.gears[mesh.tailGear], &head = kit.train.gears[mesh.headGear];
    const double a = pitchPlace(tail, mesh.pitchPoint), b = pitchPlace(head, mesh.pitchPoint);
    const auto offTooth = [](double place) { return std::abs(place - std::round(place)); };
    KitMark mark;
    mark.mesh = mesh.mesh;
    const bool isTail = offTooth(a) <= offTooth(b);
    mark.toothGear = isTail ? mesh.tailGear : mesh.headGear;
    mark.spaceGear = isTail ? mesh.headGear : mesh.tailGear;
    mark.tooth = wrapped(std::llround(isTail ? a : b), kit.train.gears[mark.toothGear].spec.teeth);
    mark.space = wrapped(static_cast<long long>(std::floor(isTail ? b : a)),
                         kit.train.gears[mark.spaceGear].spec.teeth);
    const auto isUsed = [&](int count) {
      for (const int gear : {int{mesh.tailGear}, int{mesh.headGear}}) {
        const std::vector<int>& counts = used[gear];
        if (std::find(counts.begin(), counts.end(), count) != counts.end()) return true;
      }
      return false;
    };
    while (isUsed(mark.count)) ++mark.count;
    used[mesh.tailGear].push_back(mark.count);
    used[mesh.headGear].push_back(mark.count);
    kit.marks.push_back(mark);
  }
}

namespace {

/// Bevels that overlap a wheel which they do not mesh with get narrower faces, at their small ends.
void narrowBevels(KitBuilder& kit) {
  constexpr double kCoarse = 0.01, kStep = 0.95, kNarrowest = 0.6;
  const auto mesh = [&](GearOrdinal a, GearOrdinal b) {
    return std::any_of(kit.train.meshes.begin(), kit.train.meshes.end(), [&](const TrainMesh& pair) {
      return (pair.tailGear == a && pair.headGear == b) || (pair.tailGear == b && pair.headGear == a);
    });
  };
  const auto overlap = [&](GearOrdinal a, GearOrdinal b) {
    KitAssembly pair;
    for (const GearOrdinal g : {a, b}) {
      GearSpec spec = kit.train.gears[g].spec;
      spec.bore = 0;
      if (!specDiagnostics(spec).empty()) return false;  // reported where it is made
      KitPart part;                                      // as its tips go round
      part.solid = std::make_shared<const Solid>(toothlessGear(spec, kCoarse));
      part.pose = kit.train.gears[g].pose;
      pair.add(part);
    }
    return pair.overlap({}).has_value();
  };
  for (const GearOrdinal a : kit.train.gears.ordinals()) {
    for (GearOrdinal b = 0; b < a; ++b) {
      TrainGear &one = kit.train.gears[a], &other = kit.train.gears[b];
      if (kit.stop.stop_requested()) return;
      if (!isConical(one.spec) || !isConical(other.spec) || one.link == other.link || mesh(a, b)) continue;
      TrainGear& outer = coneDistance(one.spec) > coneDistance(other.spec) ? one : other;
      const double before = outer.spec.faceWidth;
      while (overlap(a, b) && outer.spec.faceWidth > kNarrowest * before) outer.spec.faceWidth *= kStep;
      if (outer.spec.faceWidth == before) continue;
      kit.notes.push_back(
          translated("The face of wheel %1 is %2 mm instead of %3 mm, so that it clears %4.",
                     {outer.name, readableNumber(std::round(outer.spec.faceWidth * 100) / 100),
                      readableNumber(before), (&outer == &one ? other : one).name}));
    }
  }
}

}  // namespace

std::optional<KitFailure> addWheels(KitBuilder& kit) {
  narrowBevels(kit);
  for (const GearOrdinal g : kit.train.gears.ordinals()) {
    if (kit.stop.stop_requested()) return std::nullopt;
    TrainGear& gear = kit.train.gears[g];
    const AxisLayout& axis = kit.plan.axes[gear.axisGroup];
    WheelRequest wheel;
    const Vector3d k = gear.pose.linear().col(2);
    const double sense = k.dot(axis.direction) < 0 ? -1 : 1;
    // Marks look up where the axis is upright; the large end of a bevel is on the bed.
    wheel.isFlipped = isConical(gear.spec) || (areParallel(k, kit.up) && k.dot(kit.up) < 0);
    const bool isOnGround = gear.link == 0;
    const RingCarrierPlan* const carrier = isRing(gear.spec) ? carrierOf(kit, g) : nullptr;
    if (isRing(gear.spec) && isOnGround) gear.spec.rim = 2 * (nominalRootRadius(gear.spec) + kScrewRim);
    wheel.spec = gear.spec;
    const AxialSpan hub = hubSpan(gear.spec);
    double at = axis.coordinate(gear.pose.translation()) + sense * (hub.low + hub.high) / 2;
    double half = (hub.high - hub.low) / 2;
    if (isRing(gear.spec) && !isOnGround) {
      if (carrier == nullptr)
        return layoutFailure(
            translated("The ring %1 is joined to its link by more than a disc.", {gear.name}));
      wheel.isFlipped = carrier->side * sense > 0;
      wheel.floor = axis.width();
      wheel.below = std::abs(carrier->plate - axis.coordinate(gear.pose.translation())) + axis.width() / 2 -
                    gear.spec.faceWidth / 2;
      at = carrier->plate;
      half = axis.width() / 2;
    }
    const Isometry3d pose = gear.pose * printFrameOf(wheel.spec, wheel.isFlipped, wheel.below);
    if (!isRing(gear.spec) || !isOnGround) {
      if (kit.ownShaft(gear.axisGroup, gear.link, at) == nullptr)
        return layoutFailure(translated("The wheel %1 is on no shaft of its link.", {gear.name}));
      wheel.bore = {kit.bore(gear.link, gear.axisGroup, at, half, pose)};
    } else {
      // The ground's ring: screwed to posts from both sides.
      const double radius = nominalRootRadius(gear.spec) + kScrewRim / 2;
      const double height = heightOf(gear.spec);
      for (int i = 0; i < 8; ++i) {
        const double angle = pi / 4 * i + pi / 8;
        const Vector2d centre(radius * std::cos(angle), radius * std::sin(angle));
        // Even ones to the base, their heads above; odd ones to a bridge, their heads below.
        wheel.holes.push_back(screwHole(centre, 0, height, i % 2 == 0));
      }
    }
    std::vector<KitMark*> marked;
    for (KitMark& mark : kit.marks) {
      if (mark.count > 4) continue;
      if (mark.toothGear == g) wheel.marks.push_back({false, mark.tooth, mark.count});
      if (mark.spaceGear == g) wheel.marks.push_back({true, mark.space, mark.count});
      if (mark.toothGear == g || mark.spaceGear == g) marked.push_back(&mark);
    }
    wheel.number = kit.label(gear.link);
    wheel.chamfer = kit.options.chamfer;
    Expected<MadeWheel> made = printedWheel(wheel, kit.options.tolerance);
    if (!made) return KitFailure{KitFailure::Kind::gears, {}, made.error()};
    for (std::size_t m = 0; m < marked.size(); ++m) {
      (marked[m]->toothGear == g ? marked[m]->isToothMarked : marked[m]->isSpaceMarked) = made->hasMark[m];
    }
    const std::string what = (isRing(gear.spec) ? "ring-" : "wheel-") + gear.name;
    KitPart& part = kit.add(isRing(gear.spec) ? KitPartKind::ring : KitPartKind::wheel, gear.link, what,
                            std::move(made->solid), gear.pose * made->place);
    part.gear = g;
    part.number = made->hasNumber ? wheel.number : std::string();
    part.overhang = made->overhang;
    part.isSnug = !wheel.bore.empty();
  }
  return std::nullopt;
}

namespace {

/// A solid shaft lies on its flat; a tube stands.
KitPart shaftPart(KitBuilder& kit, const ShaftSegment& shaft) {
  const AxisLayout& axis = kit.plan.axes[shaft.axisGroup];
  const ShaftSection section = kit.sectionOf(shaft);
  const double length = shaft.high - shaft.low, chamfer = kit.options.chamfer;
  Isometry3d pose = Isometry3d::Identity();
  Solid solid;
  if (section.inner > 0) {
    pose = frameAlong(axis.at(shaft.low), axis.direction);
    const Vector3d towards = pose.linear().transpose() * section.towards;
    PlateShape shape;
    shape.outer =
        chamferedWall(flattedOutline(section.outer, section.flat, std::atan2(towards.y(), towards.x())), 0,
                      length, chamfer);
    shape.holes = {chamferedWall(reversed(circleOutline({0, 0}, section.inner)), 0, length, chamfer)};
    solid = plateSolid(shape);
  } else {
    KitOutline round = flattedOutline(section.outer, section.flat, 0);
    const double half = std::sqrt(section.outer * section.outer - section.flat * section.flat);
    const double cut = std::min(chamfer, half / 2);
    std::erase_if(round, [&](const Vector2d& p) { return p.x() > section.flat - cut + 1e-9; });
    const double wide = std::sqrt(section.outer * section.outer - std::pow(section.flat - cut, 2));
    round.emplace_back(section.flat - cut, -wide);
    if (cut > 0) {
      round.emplace_back(section.flat, -half + cut);
      round.emplace_back(section.flat, half - cut);
    }
    round.emplace_back(section.flat - cut, wide);
    PlateShape shape;
    shape.outer = {{0, round}, {length, round}};
    Isometry3d lie = Isometry3d::Identity();  // a, b, h of the section to h, b, flat - a
    lie.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    lie.translation() = Vector3d(0, 0, std::round(section.flat / KitShell::kGrid) * KitShell::kGrid);
    solid = moved(plateSolid(shape), lie);
    Isometry3d stand = Isometry3d::Identity();
    stand.linear().col(0) = section.towards;
    stand.linear().col(1) = axis.direction.cross(section.towards);
    stand.linear().col(2) = axis.direction;
    stand.translation() = axis.at(shaft.low);
    pose = stand * lie.inverse();
  }
  KitPart part;
  part.kind = KitPartKind::shaft;
  part.link = shaft.link;
  part.name = kit.label(shaft.link) + "-shaft";
  part.solid = std::make_shared<const Solid>(std::move(solid));
  part.pose = pose;
  part.diameter = 2 * section.outer;
  part.inner = 2 * section.inner;
  part.length = length;
  if (section.inner == 0) part.overhang = std::asin(section.flat / section.outer);
  return part;
}

/// A ring around a shaft from one coordinate to another: a spacer that turns freely, or a clip.
KitPart collarPart(KitBuilder& kit, const ShaftSegment& shaft, double low, double high, bool isClip) {
  const AxisLayout& axis = kit.plan.axes[shaft.axisGroup];
  const ShaftSection section = kit.sectionOf(shaft);
  const Isometry3d pose = frameAlong(axis.at(low), axis.direction);
  const Vector3d towards = pose.linear().transpose() * section.towards;
  const double outer = section.outer + (isClip ? 2.4 : 1.6);
  PlateShape shape;
  shape.outer = chamferedWall(circleOutline({0, 0}, outer), 0, high - low, kit.options.chamfer);
  const KitOutline hole = isClip ? flattedOutline(section.outer + kPressFit / 2, section.flat + kPressFit / 2,
                                                  std::atan2(towards.y(), towards.x()))
                                 : circleOutline({0, 0}, section.outer + kit.options.bore / 2);
  shape.holes = {chamferedWall(reversed(hole), 0, high - low, kit.options.chamfer)};
  KitPart part;
  part.kind = isClip ? KitPartKind::clip : KitPartKind::spacer;
  part.link = shaft.link;
  part.name = kit.label(shaft.link) + (isClip ? "-clip" : "-spacer");
  part.solid = std::make_shared<const Solid>(plateSolid(shape));
  part.pose = pose;
  part.diameter = 2 * outer;
  part.inner = 2 * section.outer;
  part.length = high - low;
  part.isSnug = isClip;
  return part;
}

}  // namespace

void addShafts(KitBuilder& kit) {
  constexpr double kLeastSpacer = 0.9, kAxialPlay = 0.2, kClip = 2.4;
  KitAssembly others;
  std::vector<LinkOrdinal> links;
  for (const KitPart& part : kit.parts) {
    others.add(part);
    links.push_back(part.link);
  }
  const auto drop = [&] {
    others.drop();
    links.pop_back();
  };
  // Keeps a part that overlaps nothing, also in motion.
  const auto fits = [&](const KitPart& part) {
    others.add(part);
    const std::size_t last = others.size() - 1;
    for (std::size_t p = 0; p < last; ++p) {
      const LinkOrdinal other = links[p];
      bool meet = others.overlaps(last, p);
      for (std::size_t k = 0; k < kit.poses.size() && !meet && other != part.link; ++k)
        meet = others.overlaps(last, p, kit.poses[k][part.link], kit.poses[k][other]);
      if (meet) {
        others.drop();
        return false;
      }
    }
    links.push_back(part.link);
    return true;
  };
  std::vector<KitPart> collars;
  std::vector<ShaftSegment> printed;
  for (const ShaftSegment& planned : kit.shafts) {
    if (kit.stop.stop_requested()) return;
    ShaftSegment shaft = planned;
    std::vector<ShaftItem> on;
    for (const ShaftItem& item : kit.items) {
      if (item.axisGroup == shaft.axisGroup && item.link == shaft.link && item.high > shaft.low &&
          item.low < shaft.high)
        on.push_back(item);
    }
    if (on.empty()) continue;  // the ground's, which the base replaces
    std::sort(on.begin(), on.end(), [](const ShaftItem& a, const ShaftItem& b) { return a.low < b.low; });
    for (std::size_t i = 0; i + 1 < on.size(); ++i) {
      const double low = on[i].high + kAxialPlay, high = on[i + 1].low - kAxialPlay;
      if (on[i].isBearing == on[i + 1].isBearing || high - low < kLeastSpacer) continue;
      KitPart spacer = collarPart(kit, shaft, low, high, false);
      if (fits(spacer)) collars.push_back(std::move(spacer));
    }
    const auto clip = [&](double low, double high, double end, double& reach) {
      ShaftSegment longer = shaft;
      (end < shaft.low || &reach == &shaft.low ? longer.low : longer.high) = end;
      KitPart collar = collarPart(kit, shaft, low, high, true);
      if (!fits(collar)) return;
      const KitPart whole = shaftPart(kit, longer);
      if (!fits(whole)) {
        drop();
        return;
      }
      drop();
      reach = end;
      collars.push_back(std::move(collar));
    };
    if (on.front().isBearing && !on.front().isClosed) {
      const double high = on.front().low - kAxialPlay;
      clip(high - kClip, high, std::min(shaft.low, high - kClip), shaft.low);
    }
    if (on.back().isBearing && !on.back().isClosed) {
      const double low = on.back().high + kAxialPlay;
      clip(low, low + kClip, std::max(shaft.high, low + kClip), shaft.high);
    }
    kit.parts.push_back(shaftPart(kit, shaft));
    others.add(kit.parts.back());
    links.push_back(shaft.link);
  }
  for (KitPart& collar : collars) kit.parts.push_back(std::move(collar));
}

}  // namespace geargraph
