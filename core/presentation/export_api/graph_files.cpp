#include "core/presentation/export_api/graph_files.h"

namespace geargraph {
namespace {

std::vector<DescribedNode> nodesOf(const Mechanism& mechanism) {
  std::vector<DescribedNode> nodes;
  for (int i = 0; i <= mechanism.n(); ++i) {
    const Link& link = mechanism.links[i];
    nodes.push_back({mechanism.linkLabel(i), {{"linkId", link.id.text()}, {"name", link.name}}});
  }
  return nodes;
}

}  // namespace

std::optional<std::string> ttGraphFile(const AnalysisSnapshot& snapshot, GraphForm form) {
  if (!snapshot.kinematics || !snapshot.kinematics->ttGraph->isComplete()) return std::nullopt;
  const TtGraph& ttGraph = *snapshot.kinematics->ttGraph;
  const Digraph& digraph = ttGraph.graph();
  GraphDescription graph{snapshot.mechanism->name};
  graph.nodes = nodesOf(*snapshot.mechanism);
  for (JointOrdinal joint = 0; joint < digraph.t(); ++joint) {
    const int label = digraph.edgeLabel(joint);
    const DigraphEdge& edge = digraph.turningEdge(joint);
    graph.edges.push_back(
        {digraph.nodeLabel(edge.tail),
         digraph.nodeLabel(edge.head),
         std::to_string(label),
         {{"label", label}, {"kind", "branch"}, {"level", ttGraph.levels().levelOf(joint)}}});
  }
  for (MeshOrdinal mesh = 0; mesh < digraph.c(); ++mesh) {
    const TerminalPair& pair = *ttGraph.terminal(mesh);
    const int label = digraph.edgeLabel(digraph.t() + mesh);
    for (const bool isTail : {true, false}) {
      const std::string side = isTail ? "tail" : "head";
      graph.edges.push_back({digraph.nodeLabel(pair.carrier),
                             digraph.nodeLabel(isTail ? pair.tail : pair.head),
                             std::to_string(label) + ':' + side,
                             {{"label", label},
                              {"kind", "chord"},
                              {"side", side},
                              {"teeth", isTail ? pair.tailTeeth : pair.headTeeth},
                              {"primes", pair.primes}}});
    }
  }
  return graphText(graph, form);
}

}  // namespace geargraph
