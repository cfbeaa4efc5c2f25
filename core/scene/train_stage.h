#pragma once

#include "core/analysis/analysis.h"
#include "core/gears/gear_solid.h"
#include "core/render/feature_edges.h"
#include "core/render/stage.h"
#include "core/scene/shape_cache.h"

namespace geargraph {

/// Larger trains get no 3D picture: their teeth would fill the memory, and nobody could tell them apart.
constexpr int kMostStageLinks = 2'000;

/// The mechanism as a stage: toothed wheels on their axes, shafts, arms and bearings, in the colours of the
/// links, turning with the inputs. What the document leaves open is placed automatically; meshes that no
/// wheels can be made for are left out; without valid inputs nothing moves. An empty scene where the turning
/// joints are no spanning tree, or the mechanism has more than kMostStageLinks.
///
/// A part selects its link. Wheels light up with their meshes too, shafts with their joints.
///
/// `cache` keeps solids from one edit to the next, so that only what changed is made again.
/// Placement and motion are those of the snapshot's live part; nothing is solved again.
/// Cost: O(n + t + c), and what new solids cost.
///
/// `edges`: keeps feature edges from one edit to the next; with it the scene brings those of what a window
/// paints, so that the thread of the window need not look for them.
///
/// `shapes`: where the 3D files that links wear are read; none: they are left out. What cannot be shown of
/// them is said in Stage::notes.
[[nodiscard]] StagePtr trainStage(const AnalysisSnapshot& snapshot, GearCache& cache,
                                  const ShapeSource* shapes = nullptr, FeatureEdges* edges = nullptr);

}  // namespace geargraph
