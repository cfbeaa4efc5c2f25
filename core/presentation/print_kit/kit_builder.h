#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/machine/body_layout/carrier_flanges.h"
#include "core/presentation/print_kit/kit_shell.h"
#include "core/presentation/print_kit/kit_wheel.h"
#include "core/presentation/print_kit/print_kit.h"

namespace geargraph {

// Screws M3, countersunk: radii of the hole that they pass, of the one that they cut a thread in, of the
// head.
constexpr double kPassHole = 1.7;
constexpr double kTapHole = 1.3;
constexpr double kHeadHole = 3.1;
constexpr double kHeadDepth = kHeadHole - kPassHole;
constexpr double kThread = 8;       // mm of thread in the part
constexpr double kLeastWall = 2.0;  // mm around bores
constexpr double kPostRadius = 4.2;
constexpr double kScrewRim = 9;  // mm that a ring of the ground has outside of its roots

/// The section of a shaft: round, with a flat that keys what sits on it.
struct ShaftSection {
  double outer = 0;
  double inner = 0;
  double flat = 0;
  Eigen::Vector3d towards;  ///< unit normal of the flat, in the assembly
};

/// What is on a shaft: an interval of its axis.
struct ShaftItem {
  AxisGroupOrdinal axisGroup = 0;
  LinkOrdinal link = 0;  ///< of the shaft
  double low = 0;
  double high = 0;
  bool isBearing = false;  ///< the shaft turns in it; else it is keyed
  bool isClosed = false;   ///< the bearing has a floor
};

/// A kit in the making: the train and its arrangement in mm, and what has been made of them.
struct KitBuilder {
  KitBuilder(const Mechanism& aMechanism, const Placement& aPlacement, const GearTrain& aTrain,
             const Arrangement& anArrangement, double factor, const KitOptions& someOptions);

  std::vector<KitPose> poses = {};  ///< in mm, in which parts stay clear of each other
  std::stop_token stop = {};        ///< what follows ends soon after it is requested

  // What parts are made from.
  const Mechanism& mechanism;
  KitOptions options;
  GearTrain train;  ///< in mm, its teeth with the play; without bodies
  Arrangement plan;
  std::vector<FlangePlan> flanges;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< from the base to the rest
  std::vector<KitMark> marks;

  // What has been made.
  std::vector<KitPart> parts;
  std::vector<KitScrew> screws;
  std::vector<std::string> notes;  ///< sentences about what differs from the train
  std::vector<ShaftItem> items;
  std::vector<ShaftSegment> shafts;  ///< that are printed: plan.shafts, some of them longer

  [[nodiscard]] std::string label(LinkOrdinal link) const {
    return std::to_string(mechanism.linkLabel(link));
  }
  [[nodiscard]] ShaftSection sectionOf(const ShaftSegment& shaft) const;
  /// The link's own shaft at a coordinate; null if none is there.
  [[nodiscard]] const ShaftSegment* ownShaft(AxisGroupOrdinal axisGroup, LinkOrdinal link, double at) const;
  /// The widest shaft of another link at a coordinate.
  [[nodiscard]] const ShaftSegment* passing(AxisGroupOrdinal axisGroup, LinkOrdinal link, double at) const;
  /// The bore of a part of a link around an axis along its print frame's z, counter-clockwise: pressed onto
  /// the link's own shaft, or free around another's; empty if no shaft is there. Notes it as an item of the
  /// shaft over the thickness `half` on either side.
  KitOutline bore(LinkOrdinal link, AxisGroupOrdinal axisGroup, double at, double half,
                  const Eigen::Isometry3d& pose);
  /// The radius that a boss around that bore needs.
  [[nodiscard]] double bossRadiusAt(LinkOrdinal link, AxisGroupOrdinal axisGroup, double at) const;
  void addScrew(double grip);
  KitPart& add(KitPartKind kind, LinkOrdinal link, const std::string& what, Solid solid,
               const Eigen::Isometry3d& pose);
  /// Sinks the link's label into the upper face where there is room; returns what was sunk.
  std::string engrave(PlateShape& shape, LinkOrdinal link) const;
};

/// Directions that differ by less are one: the sine of the angle between them.
constexpr double kParallelDirections = 1e-6;
[[nodiscard]] inline bool areParallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.cross(b).norm() < kParallelDirections;
}

/// A hole for a screw, clockwise, from `low` to `high`, with its head in the upper or the lower face.
[[nodiscard]] std::vector<Rim> screwHole(const Eigen::Vector2d& centre, double low, double high,
                                         bool isHeadAbove);
/// A hole in which a screw cuts its thread.
[[nodiscard]] std::vector<Rim> tapHole(const Eigen::Vector2d& centre, double low, double high);
/// A round post with a hole for a screw from either end, upright.
[[nodiscard]] Solid postSolid(double radius, double length, double chamfer);

// The parts, one kind after the other. Each returns why it cannot be made.
[[nodiscard]] std::optional<KitFailure> checkTrain(const KitBuilder& kit);
void pairMarks(KitBuilder& kit);
[[nodiscard]] std::optional<KitFailure> addArms(KitBuilder& kit);
[[nodiscard]] std::optional<KitFailure> addWheels(KitBuilder& kit);
/// Base, bridges and posts; after all that moves.
[[nodiscard]] std::optional<KitFailure> addGround(KitBuilder& kit, const Placement& placement);
/// Shafts, spacers between what is on them, and clips at their ends; last.
void addShafts(KitBuilder& kit);

[[nodiscard]] KitFailure layoutFailure(std::string message);

}  // namespace geargraph
