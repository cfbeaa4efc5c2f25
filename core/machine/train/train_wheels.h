#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A wheel during the construction of the train.
struct TrainWheel {
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;
  std::vector<MeshOrdinal> meshes;
  std::vector<double> planes;  ///< of its meshes: coordinate along the axis from the base origin; bevels: 0
  std::optional<WheelId> id;
  Eigen::Vector3d axis;      ///< +z of the gear; bevel: from the apex to the gear
  Eigen::Vector3d origin;    ///< of the gear's frame: middle of the face, or the apex
  double workingRadius = 0;  ///< operating pitch radius in its first mesh
  GearSpec spec;
};

struct TrainPair {
  MeshOrdinal mesh = 0;
  GearOrdinal tail;
  GearOrdinal head;
  MeshKind kind = kUsualKind;
  Eigen::Vector3d pitchPoint;
  /// Of skew axes: the tooth normal in the plane that touches both pitch cylinders; else 0.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double distance = 0;    ///< of the axes; 0 for bevels
  bool movable = false;   ///< the document leaves the pair's position along the axes open
  bool openFace = false;  ///< the document gives no face width
};

/// A wheel of which a mesh says other teeth than those before it: helix angle, hand or module.
struct TeethConflict {
  GearOrdinal wheel;
  MeshOrdinal mesh;     ///< that differs
  MeshOrdinal first;    ///< that the wheel follows
  bool isHelix = true;  ///< else the module
};

struct TrainWheels {
  ByGear<TrainWheel> wheels;
  std::vector<TrainPair> pairs;
  std::vector<TeethConflict> conflicts;
};

/// The wheels with their places, kinds, teeth, cone and helix angles. The other members of the specs are not
/// set yet. The result is meaningless if `stop` was requested meanwhile.
[[nodiscard]] TrainWheels wheelsOf(const Mechanism& mechanism, const Placement& placement,
                                   const std::stop_token& stop = {});

/// Modules, profile shifts, face widths, backlash and tips of all wheels. A wheel whose meshes are in several
/// planes (the long planet of a Ravigneaux set) spans all of them, with its origin in the middle. Incomplete
/// if `stop` was requested meanwhile. Wheels in equal circumstances get equal shifts, whatever their number.
/// Cost: O(wheels + sweeps * meshes), at most 500 sweeps.
void shapeWheels(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop = {});

/// Moves movable groups of wheels along their axes until no two wheels overlap that do not mesh; in compound
/// planetary gear sets in the order with the fewest enclosures (stack_order.h). Incomplete if `stop` was
/// requested meanwhile.
void stackWheels(TrainWheels& train, const Placement& placement, const std::stop_token& stop = {});

/// Reduces open face widths of bevel pairs where that removes an overlap of one of their wheels with another.
/// Incomplete if `stop` was requested meanwhile. Cost: O(wheels^2).
void shortenFaces(TrainWheels& train, const Placement& placement, const std::stop_token& stop = {});

/// Pairs of wheels of different links that still overlap and do not mesh, without neighbours around a common
/// wheel, which neighbourDiagnostics() reports. Incomplete if `stop` was requested meanwhile.
[[nodiscard]] std::vector<std::pair<int, int>> overlappingWheels(const TrainWheels& train,
                                                                 const Placement& placement,
                                                                 const std::stop_token& stop = {});

[[nodiscard]] inline Eigen::Vector3d wide(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace geargraph
