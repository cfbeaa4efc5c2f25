#include "core/presentation/results/named_drawings.h"

#include <array>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/presentation/drawing/tt_graph_layout.h"
#include "core/presentation/schematic/schematic.h"

namespace geargraph::inline results {
namespace {

DisplayList digraph(const AnalysisSnapshot& snapshot, const std::stop_token& /*stop*/) {
  return digraphDrawing(*snapshot.mechanism, completedPositions(*snapshot.mechanism), {});
}

DisplayList ttGraph(const AnalysisSnapshot& snapshot, const std::stop_token& /*stop*/) {
  const TtGraph* graph = snapshot.kinematics ? snapshot.kinematics->ttGraph.get() : nullptr;
  const NodePositions places =
      ttPositions(ttLayout(*snapshot.mechanism, graph), snapshot.mechanism->view.ttNodes);
  return ttGraphDrawing(ttGraphGeometry(*snapshot.mechanism, graph, places), {});
}

DisplayList schematic(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  return schematicDrawing(schematicGeometry(*snapshot.geometry, stop), {});
}

constexpr std::array kDrawings = {NamedDrawing{"digraph", digraph}, NamedDrawing{"ttgraph", ttGraph},
                                  NamedDrawing{"schematic", schematic}};

}  // namespace

std::span<const NamedDrawing> drawings() {
  return kDrawings;
}

const NamedDrawing* drawingNamed(std::string_view name) {
  for (const NamedDrawing& drawing : kDrawings) {
    if (drawing.name == name) return &drawing;
  }
  return nullptr;
}

std::string drawingNames() {
  std::string names;
  for (const NamedDrawing& drawing : kDrawings)
    names += (names.empty() ? "" : ", ") + std::string(drawing.name);
  return names;
}

}  // namespace geargraph::inline results
