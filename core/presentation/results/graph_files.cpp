#include "core/presentation/results/graph_files.h"

#include <array>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/files/json_writer.h"

namespace geargraph::inline results {
namespace {

using Value = std::variant<int, std::string>;
using Attributes = std::vector<std::pair<std::string_view, Value>>;

struct GraphNode {
  int label = 0;
  Attributes attributes;
};

struct GraphEdge {
  int source = 0;
  int target = 0;
  std::string key;  ///< tells apart edges between the same two nodes
  Attributes attributes;
};

/// A graph with what its nodes and edges are about.
struct GraphDescription {
  std::string name;
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
};

std::vector<GraphNode> nodesOf(const Mechanism& mechanism) {
  std::vector<GraphNode> nodes;
  for (int i = 0; i <= mechanism.n(); ++i) {
    const Link& link = mechanism.links[static_cast<std::size_t>(i)];
    nodes.push_back({mechanism.linkLabel(i), {{"linkId", link.id.text()}, {"name", link.name}}});
  }
  return nodes;
}

std::string valueText(const Value& value) {
  const int* number = std::get_if<int>(&value);
  return number != nullptr ? std::to_string(*number) : std::get<std::string>(value);
}

/// DOT knows no escapes but of the quote; a backslash begins an escape of labels, so it is doubled.
std::string dotText(std::string_view text) {
  std::string dot = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') dot += '\\';
    dot += c;
  }
  return dot + '"';
}

std::string dotAttributes(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) {
    text += (text.empty() ? "" : ", ") + std::string(name) + '=' + dotText(valueText(value));
  }
  return " [" + text + "];\n";
}

std::string asDot(const GraphDescription& graph) {
  std::string text = "digraph " + dotText(graph.name) + " {\n";
  for (const GraphNode& node : graph.nodes)
    text += "  " + std::to_string(node.label) + dotAttributes(node.attributes);
  for (const GraphEdge& edge : graph.edges) {
    text += "  " + std::to_string(edge.source) + " -> " + std::to_string(edge.target) +
            dotAttributes(edge.attributes);
  }
  return text + "}\n";
}

/// XML 1.0 has no control characters but tab and line ends.
std::string xmlText(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 && c != '\t' && c != '\n' && c != '\r') continue;
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

template <class Element>
void declareKeys(std::string& text, std::string_view what, const std::vector<Element>& elements) {
  std::set<std::string_view> known;
  for (const Element& element : elements) {
    for (const auto& [name, value] : element.attributes) {
      if (!known.insert(name).second) continue;
      text += "  <key id=\"" + std::string(what) + '.' + std::string(name) + "\" for=\"" + std::string(what) +
              "\" attr.name=\"" + std::string(name) + "\" attr.type=\"" +
              (std::holds_alternative<int>(value) ? "int" : "string") + "\"/>\n";
    }
  }
}

void writeData(std::string& text, std::string_view what, const Attributes& attributes) {
  for (const auto& [name, value] : attributes) {
    text += "      <data key=\"" + std::string(what) + '.' + std::string(name) + "\">" +
            xmlText(valueText(value)) + "</data>\n";
  }
}

std::string asGraphMl(const GraphDescription& graph) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
      "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  declareKeys(text, "node", graph.nodes);
  declareKeys(text, "edge", graph.edges);
  text += "  <graph id=\"" + xmlText(graph.name) + "\" edgedefault=\"directed\">\n";
  for (const GraphNode& node : graph.nodes) {
    text += "    <node id=\"" + std::to_string(node.label) + "\">\n";
    writeData(text, "node", node.attributes);
    text += "    </node>\n";
  }
  for (const GraphEdge& edge : graph.edges) {
    text += "    <edge id=\"" + xmlText(edge.key) + "\" source=\"" + std::to_string(edge.source) +
            "\" target=\"" + std::to_string(edge.target) + "\">\n";
    writeData(text, "edge", edge.attributes);
    text += "    </edge>\n";
  }
  return text + "  </graph>\n</graphml>\n";
}

void writeMembers(JsonWriter& json, const Attributes& attributes) {
  for (const auto& [name, value] : attributes) {
    std::visit([&, &key = name](const auto& each) { json.member(key, each); }, value);
  }
}

std::string asNodeLink(const GraphDescription& graph) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("directed", true);
    json.member("multigraph", true);
    json.key("graph");
    json.beginObject(JsonWriter::Layout::row);
    json.member("name", graph.name);
    json.endObject();
    json.key("nodes");
    json.beginArray();
    for (const GraphNode& node : graph.nodes) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("id", node.label);
      writeMembers(json, node.attributes);
      json.endObject();
    }
    json.endArray();
    json.key("links");
    json.beginArray();
    for (const GraphEdge& edge : graph.edges) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("source", edge.source);
      json.member("target", edge.target);
      json.member("key", edge.key);
      writeMembers(json, edge.attributes);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

std::string written(const GraphDescription& graph, GraphForm form) {
  switch (form) {
    case GraphForm::dot:
      return asDot(graph);
    case GraphForm::graphMl:
      return asGraphMl(graph);
    case GraphForm::nodeLink:
      return asNodeLink(graph);
  }
  return {};
}

}  // namespace

std::optional<GraphForm> graphFormFromName(std::string_view name) {
  constexpr std::array<std::string_view, 3> kNames = {"dot", "graphml", "node-link"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames.at(i) == name) return static_cast<GraphForm>(i);
  }
  return std::nullopt;
}

std::string digraphFile(const Mechanism& mechanism, GraphForm form) {
  const Digraph digraph(mechanism);
  GraphDescription graph{mechanism.name, nodesOf(mechanism), {}};
  for (int e = 0; e < digraph.edgeCount(); ++e) {
    const int label = digraph.edgeLabel(e);
    GraphEdge& edge = graph.edges.emplace_back();
    edge.source = digraph.nodeLabel(digraph.edge(e).tail);
    edge.target = digraph.nodeLabel(digraph.edge(e).head);
    edge.key = std::to_string(label);
    edge.attributes = {{"label", label}, {"edgeId", digraph.edgeId(e).id.text()}};
    if (e < digraph.t()) {
      const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(e)];
      edge.attributes.emplace_back("kind", "turning");
      edge.attributes.emplace_back("axis", joint.axis.text());
    } else {
      const GearMesh& mesh = mechanism.gearMeshes[static_cast<std::size_t>(e - digraph.t())];
      edge.attributes.emplace_back("kind", "mesh");
      edge.attributes.emplace_back("tailTeeth", mesh.tailTeeth);
      edge.attributes.emplace_back("headTeeth", mesh.headTeeth);
    }
  }
  return written(graph, form);
}

std::optional<std::string> ttGraphFile(const AnalysisSnapshot& snapshot, GraphForm form) {
  if (!snapshot.kinematics || !snapshot.kinematics->ttGraph->isComplete()) return std::nullopt;
  const TtGraph& ttGraph = *snapshot.kinematics->ttGraph;
  const Digraph& digraph = ttGraph.graph();
  GraphDescription graph{snapshot.mechanism->name, nodesOf(*snapshot.mechanism), {}};
  for (int joint = 0; joint < digraph.t(); ++joint) {
    const int label = digraph.edgeLabel(joint);
    const DigraphEdge& edge = digraph.turningEdge(joint);
    graph.edges.push_back(
        {digraph.nodeLabel(edge.tail),
         digraph.nodeLabel(edge.head),
         std::to_string(label),
         {{"label", label}, {"kind", "branch"}, {"level", ttGraph.levels().levelOf(joint)}}});
  }
  for (int mesh = 0; mesh < digraph.c(); ++mesh) {
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
  return written(graph, form);
}

}  // namespace geargraph::inline results
