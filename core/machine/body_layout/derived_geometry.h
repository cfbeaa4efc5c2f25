#pragma once

#include <memory>
#include <stop_token>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {
struct GearTrain;
struct TrainWheels;
}  // namespace geargraph

namespace geargraph {
struct Arrangement;
}  // namespace geargraph

namespace geargraph {

/// All geometry that follows from one mechanism: its placement, its wheels, the train with its bodies, and
/// the diagnostics of the train. Edits, analysis, 3D view, schematic, forms and exports of a document share
/// it.
///
/// Each part is computed once, on the thread that requests it first (DeferredValue). A cancelled request
/// returns null, and the next one computes the part. Immutable otherwise; thread-safe.
///
/// Where the document's coordinates are too large for the precision that gears need in doubles, the train is
/// computed about an origin of its own (recentred()) and then moved to its place, so that pictures, files and
/// diagnostics show the same train.
class DerivedGeometry {
 public:
  explicit DerivedGeometry(PlacedMechanism placed);
  ~DerivedGeometry();
  DerivedGeometry(const DerivedGeometry&) = delete;
  DerivedGeometry& operator=(const DerivedGeometry&) = delete;

  [[nodiscard]] const PlacedMechanism& placed() const { return m_placed; }
  [[nodiscard]] const Mechanism& mechanism() const { return m_placed.mechanism(); }
  [[nodiscard]] const Placement& placement() const { return m_placed.placement(); }

  /// The wheels of the train, in the order of its gears; empty if the turning joints are no spanning tree.
  [[nodiscard]] std::shared_ptr<const TrainWheels> wheels(const std::stop_token& stop = {}) const;
  /// trainOf(). Its bodies are planned; their solids are made on demand.
  [[nodiscard]] std::shared_ptr<const GearTrain> train(const std::stop_token& stop = {}) const;
  /// The arrangement of the train's bodies.
  [[nodiscard]] std::shared_ptr<const Arrangement> arrangement(const std::stop_token& stop = {}) const;
  /// trainDiagnostics().
  [[nodiscard]] std::shared_ptr<const Diagnostics> diagnostics(const std::stop_token& stop = {}) const;

 private:
  struct Parts;

  PlacedMechanism m_placed;
  std::unique_ptr<Parts> m_parts;
};

using DerivedGeometryPtr = std::shared_ptr<const DerivedGeometry>;

}  // namespace geargraph
