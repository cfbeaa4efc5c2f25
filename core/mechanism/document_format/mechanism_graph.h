#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/document_format/graph_text.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The digraph [AU, Fig. 2] of a mechanism, with everything that a table can hold (tablePart()), as a text
/// that readMechanismGraph() reads back: a node for each link, an edge for each turning joint and each mesh,
/// directed from tail to head. Nodes are named by their labels and have the link's id and name; edges have
/// label, id, kind ("turning" or "mesh"), the axis of a joint, and the tooth counts of a mesh. Attributes
/// have the names of the document's members; lists are JSON. Everything else (axes, wheels, inputs,
/// couplings, states, loads, ...) is stored in attributes of the graph.
///
/// Texts are UTF-8; characters that a format does not allow (control characters in XML) are left out. Cost:
/// O(document).
[[nodiscard]] std::string digraphFile(const Mechanism& mechanism, GraphForm form);

/// The format of a graph, recognized by the beginning of its text; std::nullopt if it is no graph. JSON is
/// node-link if it has `nodes` and is not a document.
[[nodiscard]] std::optional<GraphForm> graphFormOf(std::string_view bytes);

/// A mechanism read from a graph. `notes`: sentences about what the graph does not state and was assumed, and
/// about what was not read.
struct GraphReading {
  Mechanism mechanism;
  std::vector<std::string> notes{};
};

/// Reads a digraph from digraphFile(), possibly modified by other programs, or one made by another program:
/// edges need a `kind`, turning joints an `axis`, meshes `tailTeeth` and `headTeeth`; axes without a position
/// are placed from the tooth counts. Nodes 0..n are sorted, other nodes keep their order; the first is the
/// ground.
///
/// Accepts any bytes: the result is a mechanism that can be saved and opened again, or what is wrong, with
/// line and column, at most the first 100: `syntax`; `format` (no digraph of a mechanism), `version`;
/// `schema` (a node or an edge is incomplete), `duplicate-id`, `unknown-id`, `self-joint`. Beyond 64 MiB,
/// 100,000 nodes or 200,000 edges: `schema`. No entity, document type or other file is read.
///
/// Identity  readMechanismGraph(digraphFile(m, f), f) is tablePart(m).mechanism (texts as f allows them).
/// Cost      O(bytes log bytes); memory at most about 30 times the file and 300 MB.
[[nodiscard]] Expected<GraphReading> readMechanismGraph(std::string_view bytes, GraphForm form);

/// Reads a document, a table or a graph, as the text is recognized.
[[nodiscard]] Expected<GraphReading> readAnyMechanism(std::string_view bytes);

}  // namespace geargraph
