#pragma once

#include <memory>
#include <stop_token>

#include "core/machine/solids/gear_solid.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/mechanism_scene/shape_cache.h"
#include "core/presentation/scene/solid_properties.h"
#include "core/presentation/scene3d/stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
class BodyCache;
}  // namespace geargraph

namespace geargraph {

/// Larger trains get no 3D picture: their teeth would exhaust the memory and be indistinguishable.
constexpr int kMaxStageLinks = 4'000;

/// The caches from one edit to the next, in addition to the solids of wheels. Not thread-safe.
class SceneMemory {
 public:
  SceneMemory();
  ~SceneMemory();

  [[nodiscard]] BodyCache& bodies() { return *m_bodies; }
  /// Adds the precomputed data of the scene's solids (SolidProperties), computing it for new ones unless
  /// `stop` is requested.
  void addFactsTo(Scene& scene, const std::stop_token& stop = {});
  /// Are feature edges precomputed, as for a window that paints on the GUI thread?
  void setFindsEdges(bool finds) { m_findsEdges = finds; }

 private:
  std::unique_ptr<BodyCache> m_bodies;
  SolidProperties m_properties;
  bool m_findsEdges = false;
};

/// The mechanism as a stage: toothed wheels on their axes, shafts, arms and bearings, in the colours of the
/// links, turning with the inputs. What the document leaves open is placed automatically; meshes for which no
/// wheels can be made are left out; without valid inputs nothing moves. The scene is empty if the turning
/// joints are no spanning tree, or the mechanism has more than kMaxStageLinks. Trains of more than
/// kMaxRoutedGears have simple bodies, with a note in Stage::notes.
///
/// A click on a part selects its link. Wheels are also highlighted with their meshes, shafts with their
/// joints.
///
/// `cache` keeps solids from one edit to the next, so that only changed ones are made again. Placement and
/// motion are those of the snapshot's live part; nothing is solved again. Cost: O(n + t + c), and that of new
/// solids.
///
/// `memory`: caches bodies and derived data of solids (SolidProperties), which are then part of the scene.
///
/// `shapes`: where attached 3D files are read from; null: they are left out. Files that cannot be shown are
/// noted in Stage::notes. Wheels of more than kMaxShownTeeth are shown without teeth, with a note too.
///
/// Null, within some milliseconds, if `stop` was requested meanwhile.
[[nodiscard]] MechanismScenePtr mechanismScene(const AnalysisSnapshot& snapshot, GearCache& cache,
                                               const ShapeSource* shapes = nullptr,
                                               SceneMemory* memory = nullptr,
                                               const std::stop_token& stop = {});

}  // namespace geargraph
