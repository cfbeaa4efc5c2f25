#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/graph_format/graph_text.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline graph_format {

/// The digraph [AU, Fig. 2] of a mechanism, with all that tables hold of it (tablePart()), as a text that
/// readMechanismGraph() reads back. A node for each link, an edge for each turning joint and each mesh,
/// directed from tail to head. Nodes are named by their labels and have the link's id and name; edges have
/// label, id, kind ("turning" or "mesh"), the axis of a joint, the tooth counts of a mesh. Attributes are
/// named as the members of the document; a list is JSON. What belongs to no node and no edge (axes, wheels,
/// inputs, couplings, states, loads, ...) are attributes of the graph.
///
/// Texts are UTF-8; what a form cannot hold (control characters in XML) is left out. Cost: O(document).
[[nodiscard]] std::string digraphFile(const Mechanism& mechanism, GraphForm form);

/// The form of a graph by the beginning of its text; none where it begins as no graph. JSON is taken for
/// node-link where it has `nodes` and is no document.
[[nodiscard]] std::optional<GraphForm> graphFormOf(std::string_view bytes);

/// A mechanism from a graph, and in sentences what was assumed, as the graph does not state it, and what was
/// not read.
struct GraphReading {
  Mechanism mechanism;
  std::vector<std::string> notes{};
};

/// Reads a digraph as digraphFile() writes it, also after other programs have changed it, or one of theirs:
/// edges need a `kind`, turning joints an `axis`, meshes `tailTeeth` and `headTeeth`; axes without a place
/// are placed from the tooth counts. Nodes 0..n are sorted, other nodes keep their order, the first is the
/// ground.
///
/// Survives any bytes: the result is a mechanism that can be saved and opened again, or what is wrong, with
/// line and column, of which the first 100: `syntax`; `format` (no digraph of a mechanism), `version`;
/// `schema` (what a node or edge lacks), `duplicate-id`, `unknown-id`, `self-joint`. Beyond 64 MiB, 100,000
/// nodes or 200,000 edges: `schema`. No entity, document type or other file is read.
///
/// Identity  readMechanismGraph(digraphFile(m, f), f) is tablePart(m).mechanism (texts as f can hold them).
/// Cost      O(bytes log bytes); memory at most about 30 times the file and 300 MB.
[[nodiscard]] Expected<GraphReading> readMechanismGraph(std::string_view bytes, GraphForm form);

/// The mechanism of a document, a table or a graph, whichever the text looks like.
[[nodiscard]] Expected<GraphReading> readAnyMechanism(std::string_view bytes);

}  // namespace geargraph::inline graph_format
