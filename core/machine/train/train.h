#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/machine/solids/deferred_solid.h"
#include "core/machine/teeth/gear_spec.h"
#include "core/machine/train/train_wheels.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {
struct BodyPart;
}  // namespace geargraph

namespace geargraph {

/// A toothed wheel of the mechanism: its shape, and its place in the reference pose.
struct TrainGear {
  /// "15:tail" by the label of its mesh; for a wheel of several meshes its id in the document, else the name
  /// by the first mesh.
  std::string name;
  LinkOrdinal link = 0;             ///< the gear moves with this link
  AxisGroupOrdinal axisGroup = 0;   ///< of the placement
  std::vector<MeshOrdinal> meshes;  ///< in document order
  std::optional<WheelId> wheel;
  GearSpec spec;
  /// Gear frame (gear_spec.h) to base frame in the reference pose, turned so that its teeth mesh.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// Two gears of the train in mesh.
struct TrainMesh {
  MeshOrdinal mesh = 0;  ///< of the document
  GearOrdinal tailGear;
  GearOrdinal headGear;
  Eigen::Vector3d
      pitchPoint;       ///< in the gears' plane; gears that the program stacked have left the document's
  double residual = 0;  ///< phase error in pitches; not 0 where a loop cannot be assembled
};

/// Two pulleys of the train with the strands between them.
struct TrainStrand {
  MeshOrdinal mesh = 0;  ///< of the document
  GearOrdinal tailGear;
  GearOrdinal headGear;
};

/// Shafts, arms, hubs and bearings of a link: solids in the base frame at the reference pose, which move with
/// it.
struct LinkBody {
  LinkOrdinal link = 0;
  double module = 1;                            ///< the smallest of its parts
  std::shared_ptr<const DeferredSolid> fine;    ///< chordal error at most kBodyTolerance, made on first use
  std::shared_ptr<const DeferredSolid> coarse;  ///< at most kMaxTolerance
  std::shared_ptr<const std::vector<BodyPart>> recipe = {};  ///< what the solids are made of (BodyRecipe)

  [[nodiscard]] const Solid& solid() const { return *fine->solid(); }
};

/// Larger trains get straight bodies that are not routed past each other (Arrangement::isSimple), and bevels
/// keep their face widths: routing costs more than the square of the number of wheels and would take minutes.
constexpr std::size_t kMaxRoutedGears = 400;

/// The mechanism in three dimensions. Every mesh with a geometry has its two gears; a mesh without one is
/// left out (the placement's diagnostics give the reason).
struct GearTrain {
  ByGear<TrainGear> gears;
  std::vector<TrainMesh> meshes;
  std::vector<TeethConflict> conflicts;
  std::vector<TrainStrand> strands;
  std::vector<LinkBody> bodies;
  /// Links whose bodies have no clearance from each other: two, or all of one axis.
  std::vector<std::vector<LinkOrdinal>> blocked;
  /// The train has more than kMaxRoutedGears: its bodies are straight and may pass through each other, its
  /// wheels are discs without webs.
  bool hasSimpleBodies = false;
};

}  // namespace geargraph
