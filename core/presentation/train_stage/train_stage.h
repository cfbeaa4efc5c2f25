#pragma once

#include <memory>
#include <stop_token>

#include "core/machine/solids/gear_solid.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/painting/solid_facts.h"
#include "core/presentation/stage/stage.h"
#include "core/presentation/train_stage/shape_cache.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline bodies {
class BodyCache;
}  // namespace geargraph::inline bodies

namespace geargraph::inline train_stage {

/// Larger trains get no 3D picture: their teeth would fill the memory, and nobody could tell them apart.
constexpr int kMostStageLinks = 4'000;

/// What is kept from one edit to the next beside the solids of wheels. Not for two threads at once.
class StageMemory {
 public:
  StageMemory();
  ~StageMemory();

  [[nodiscard]] BodyCache& bodies() { return *m_bodies; }
  /// Adds what is known of the solids, and of new ones what has to be, unless `stop` is requested.
  void addFactsTo(Scene& scene, const std::stop_token& stop = {});
  /// Are feature edges found ahead, as for a window that paints by itself?
  void setFindsEdges(bool finds) { m_findsEdges = finds; }

 private:
  std::unique_ptr<BodyCache> m_bodies;
  SolidFacts m_facts;
  bool m_findsEdges = false;
};

/// The mechanism as a stage: toothed wheels on their axes, shafts, arms and bearings, in the colours of the
/// links, turning with the inputs. What the document leaves open is placed automatically; meshes that no
/// wheels can be made for are left out; without valid inputs nothing moves. An empty scene where the turning
/// joints are no spanning tree, or the mechanism has more than kMostStageLinks. Trains of more than
/// kMostRoutedGears have simple bodies, as Stage::notes tells.
///
/// A part selects its link. Wheels light up with their meshes too, shafts with their joints.
///
/// `cache` keeps solids from one edit to the next, so that only what changed is made again.
/// Placement and motion are those of the snapshot's live part; nothing is solved again.
/// Cost: O(n + t + c), and what new solids cost.
///
/// `memory`: keeps bodies and what is known of solids; with it the scene brings what follows from them
/// (SolidFacts).
///
/// `shapes`: where the 3D files that links wear are read; none: they are left out. What cannot be shown of
/// them is said in Stage::notes. Wheels of more than kMostShownTeeth are shown without teeth, and noted too.
///
/// Null when `stop` was requested meanwhile, within some milliseconds.
[[nodiscard]] StagePtr trainStage(const AnalysisSnapshot& snapshot, GearCache& cache,
                                  const ShapeSource* shapes = nullptr, StageMemory* memory = nullptr,
                                  const std::stop_token& stop = {});

}  // namespace geargraph::inline train_stage
