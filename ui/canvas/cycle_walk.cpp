#include "ui/canvas/cycle_walk.h"

#include <QCoreApplication>

namespace geargraph {

std::optional<CycleWalk> cycleWalk(const AnalysisSnapshot& snapshot, MeshId mesh) {
  if (!snapshot.tree || !snapshot.graph) return std::nullopt;
  const Digraph& graph = *snapshot.graph;
  int ordinal = graph.t();
  while (ordinal < graph.edgeCount() && graph.edgeId(ordinal) != ElementId(mesh)) ++ordinal;
  if (ordinal == graph.edgeCount()) return std::nullopt;

  const DigraphEdge& chord = graph.edge(ordinal);
  CycleWalk walk;
  walk.emphases[mesh].walk = 1;
  walk.caption = QCoreApplication::translate("canvas", "Cycle C%1:").arg(graph.edgeLabel(ordinal));
  walk.caption += QString(" %1 ···%2··· %3").arg(chord.tail).arg(graph.edgeLabel(ordinal)).arg(chord.head);
  int node = chord.head;
  for (const PathStep& step : treePath(*snapshot.tree, chord.head, chord.tail)) {
    const DigraphEdge& joint = graph.turningEdge(step.joint);
    walk.emphases[graph.edgeId(step.joint)].walk = step.direction;
    node = node == joint.tail ? joint.head : joint.tail;
    walk.caption += QString(" –%1– %2").arg(graph.edgeLabel(step.joint)).arg(node);
  }
  return walk;
}

}  // namespace geargraph
