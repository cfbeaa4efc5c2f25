#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace geargraph {

/// Graph formats of other programs: Graphviz DOT, GraphML, and the node-link JSON of NetworkX.
enum class GraphForm { dot, graphMl, nodeLink };

/// "dot", "graphml", "node-link".
[[nodiscard]] std::optional<GraphForm> graphFormFromName(std::string_view name);

/// A JSON value: a number, true or false, a list. Formats without lists store it as text.
struct JsonText {
  std::string json;
};
using AttributeValue = std::variant<int, std::string, JsonText>;
using Attributes = std::vector<std::pair<std::string_view, AttributeValue>>;

struct DescribedNode {
  int label = 0;
  Attributes attributes;
};

struct DescribedEdge {
  int source = 0;
  int target = 0;
  std::string key;  ///< distinguishes edges between the same two nodes
  Attributes attributes;
};

/// A directed graph with attributes of the graph, its nodes and its edges.
struct GraphDescription {
  std::string name;
  Attributes attributes{};
  std::vector<DescribedNode> nodes{};
  std::vector<DescribedEdge> edges{};
};

/// Cost: O(size).
[[nodiscard]] std::string graphText(const GraphDescription& graph, GraphForm form);

}  // namespace geargraph
