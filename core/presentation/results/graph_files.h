#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// Graphs as other programs read them: Graphviz' DOT, GraphML, and the node-link JSON of NetworkX.
enum class GraphForm { dot, graphMl, nodeLink };

/// "dot", "graphml", "node-link".
[[nodiscard]] std::optional<GraphForm> graphFormFromName(std::string_view name);

/// The digraph [AU, Fig. 2]: a node for each link, an edge for each turning joint and each mesh, directed
/// from tail to head. Nodes are named by their labels and have the link's id and name; edges have label, id,
/// kind ("turning" or "mesh"), the axis of a joint, and the tooth counts of a mesh.
///
/// Texts are UTF-8; what a form cannot hold (control characters in XML) is left out. Cost: O(n + t + c).
[[nodiscard]] std::string digraphFile(const Mechanism& mechanism, GraphForm form);

/// The T-T graph [AU, Fig. 5]: the turning joints with their levels, and two chords for each mesh, from the
/// carrier to either gear. Nothing where a mesh has no carrier, or there is no spanning tree.
[[nodiscard]] std::optional<std::string> ttGraphFile(const AnalysisSnapshot& snapshot, GraphForm form);

}  // namespace geargraph::inline results
