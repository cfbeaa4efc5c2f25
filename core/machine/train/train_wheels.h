#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline train {

/// A wheel while the train is made.
struct TrainWheel {
  int link = 0;
  int axisClass = 0;
  std::vector<int> meshes;
  std::vector<double> planes;  ///< by mesh: where along the axis it lies, from the origin; bevels: 0
  std::optional<WheelId> id;
  Eigen::Vector3d axis;      ///< +z of the gear; bevel: from the apex to the gear
  Eigen::Vector3d origin;    ///< of the gear's frame: middle of the face, or the apex
  double workingRadius = 0;  ///< operating pitch radius in its first mesh
  GearSpec spec;
};

struct TrainPair {
  int mesh = 0;
  int tail = 0;  ///< positions of wheels
  int head = 0;
  MeshKind kind = MeshKind::external;
  Eigen::Vector3d pitchPoint;
  double distance = 0;    ///< of the axes; 0 for bevels
  bool movable = false;   ///< the document leaves open where along the axes the pair lies
  bool openFace = false;  ///< the document says no face width
};

struct TrainWheels {
  std::vector<TrainWheel> wheels;
  std::vector<TrainPair> pairs;
};

/// Which wheels there are, where, and of what kind, teeth and cone. The specs' other measures are not set
/// yet. Of no use when `stop` was requested meanwhile.
[[nodiscard]] TrainWheels wheelsOf(const Mechanism& mechanism, const Placement& placement,
                                   const std::stop_token& stop = {});

/// Modules, profile shifts, face widths, backlash and tips of all wheels. A wheel whose meshes lie in several
/// planes (the long planet of a Ravigneaux set) is as wide as all of them, its origin in their middle.
/// Of no use when `stop` was requested meanwhile. Cost: O(wheels + sweeps * meshes), 500 sweeps at most.
void shapeWheels(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop = {});

/// Moves movable groups of wheels along their axes until no two wheels that do not mesh stand in one place;
/// but for linked sets so that as few as can be are shut in between wheels of another link (stack_order.h).
/// Of no use when `stop` was requested meanwhile.
void stackWheels(TrainWheels& train, const Placement& placement, const std::stop_token& stop = {});

/// Shortens faces of bevel pairs that the document leaves open, where that takes a wheel of theirs out of the
/// room of another. Of no use when `stop` was requested meanwhile. Cost: O(wheels^2).
void shortenFaces(TrainWheels& train, const Placement& placement, const std::stop_token& stop = {});

/// Wheels of different links that still stand in one place and do not mesh, nor have a wheel in common that
/// both mesh with beside each other (neighbours, whose own finding says more). Incomplete when `stop` was
/// requested meanwhile.
[[nodiscard]] std::vector<std::pair<int, int>> wheelsInOnePlace(const TrainWheels& train,
                                                                const Placement& placement,
                                                                const std::stop_token& stop = {});

[[nodiscard]] inline Eigen::Vector3d wide(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace geargraph::inline train
